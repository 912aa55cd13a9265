#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Optimizes random walks of up to a million poses, and writes scale.md: a table of their cost."""

import argparse
import json
import os
import pathlib
import subprocess
import sys

import numpy as np

import manhattan_walk
from outliers import errors_after_alignment, positions

# Poses, half the side of the city in m, part of the visits that close a loop.
WALKS = [(10_000, 40, 0.3), (100_000, 125, 0.3), (1_000_000, 350, 0.3), (1_000_000, 250, 0.25)]
CERES_LARGEST = 100_000
CERES_TIME_S = 120


def run(command):
    """Returns the JSON that the command prints, its CPU time in s and its peak memory in MB."""
    with subprocess.Popen(command, stdout=subprocess.PIPE) as process:
        output = process.stdout.read()
        _, status, usage = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
    if process.returncode != 0:
        raise RuntimeError(f"{' '.join(command)} failed")
    return json.loads(output), usage.ru_utime + usage.ru_stime, usage.ru_maxrss / 1024


def row(folder, bin_dir, poses, half_side, closure_part):
    truth, closures = manhattan_walk.walk(poses, half_side, closure_part)
    graph = folder / f"walk_{poses}_{half_side}.g2o"
    if not graph.exists():
        manhattan_walk.write_graph(graph, truth, closures)
    true_positions = np.array([pose[:2] for pose in truth], dtype=float)
    cells = [f"{poses:,}", f"{poses - 1 + len(closures):,}"]
    for backend in ("spa", "ceres"):
        if backend == "ceres" and poses > CERES_LARGEST:
            cells += ["not run"] * 3
            continue
        output = folder / f"{graph.stem}_{backend}.g2o"
        summary, cpu_s, memory_mb = run(
            [f"{bin_dir}/optimize_graph", f"--input={graph}", f"--output={output}",
             f"--backend={backend}",
             *([f"--max_solver_time_s={CERES_TIME_S}"] if backend == "ceres" else [])])
        errors_m = errors_after_alignment(positions(output.read_text().splitlines()), true_positions)
        cells += [f"{cpu_s:.1f}", f"{memory_mb:.0f}", f"{np.sqrt((errors_m ** 2).mean()):.2f}"
                  + ("" if summary["termination"] == "converged" else " (not converged)")]
        print(f"{graph.name}: {backend}, {cpu_s:.1f} CPU s", file=sys.stderr)
    return "| " + " | ".join(cells) + " |"


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--bin", required=True, help="folder of the executables")
    parser.add_argument("--output_dir", required=True, help="folder that gets the graphs")
    arguments = parser.parse_args()
    folder = pathlib.Path(arguments.output_dir)
    folder.mkdir(parents=True, exist_ok=True)
    lines = ["| poses | edges | spa, CPU s | memory MB | RMSE m | ceres, CPU s | memory MB | RMSE m |",
             "| ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: |"]
    lines += [row(folder, arguments.bin, *walk) for walk in WALKS]
    (folder / "scale.md").write_text("\n".join(lines) + "\n")


if __name__ == "__main__":
    main()
