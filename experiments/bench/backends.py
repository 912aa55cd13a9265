#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Runs backends_bench and writes its results into the table of README.md beside this file.

Usage: backends.py BENCH_EXECUTABLE FOLDER_OF_GRAPHS
"""

import json
import os
import pathlib
import statistics
import subprocess
import sys

GRAPHS = ["intel", "MIT", "CSAIL", "manhattan", "kitti_00", "city10000", "M3500a", "M3500b", "M3500c"]
CONTESTANTS = ["spa", "spa_cholmod", "ceres_best", "ceres_lm_defaults"]
REPETITIONS = 5


def run(bench, folder, pattern, repetitions):
    """Returns {name: [(cpu_ms, iterations, cost)]}, runs in random order, and the peak memory in MB."""
    arguments = [bench, folder, f"--benchmark_filter={pattern}", "--benchmark_format=json",
                 f"--benchmark_repetitions={repetitions}",
                 "--benchmark_enable_random_interleaving=true"]
    with subprocess.Popen(arguments, stdout=subprocess.PIPE) as process:
        output = process.stdout.read()
        _, status, usage = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
    if process.returncode != 0:
        raise RuntimeError(f"{' '.join(arguments)} failed")
    results = {}
    for record in json.loads(output)["benchmarks"]:
        if record["run_type"] != "iteration":
            continue
        name = "/".join(record["name"].split("/")[:2])
        results.setdefault(name, []).append(
            (record["cpu_time"], record.get("iterations_taken"), record["cost"]))
    return results, usage.ru_maxrss / 1024


def cell(runs):
    """Median time, iterations and cost of the runs of one contestant on one graph."""
    time = statistics.median(run[0] for run in runs)
    iterations = f" / {runs[0][1]:.0f}" if runs[0][1] is not None else ""
    return f"{time:.2f}{iterations}<br>{runs[0][2]:.6f}"


def batch_table(results):
    lines = ["| graph | " + " | ".join(CONTESTANTS) + " | ceres_best : spa | ceres_lm_defaults : spa |",
             "|---|" + "---|" * (len(CONTESTANTS) + 2)]
    for graph in GRAPHS + ["online_manhattan"]:
        runs = [results[f"{graph}/{contestant}"] for contestant in CONTESTANTS]
        medians = [statistics.median(run[0] for run in contestant) for contestant in runs]
        lines.append(f"| {graph} | " + " | ".join(cell(contestant) for contestant in runs) +
                     f" | {medians[2] / medians[0]:.1f} | {medians[3] / medians[0]:.1f} |")
    return lines


def main():
    bench, folder = sys.argv[1:]
    results, _ = run(bench, folder, "^[^o]", REPETITIONS)  # all but online
    online, _ = run(bench, folder, "^online", 1)
    results.update(online)
    peaks = {contestant: run(bench, folder, f"^city10000/{contestant}/", 1)[1]
             for contestant in CONTESTANTS}
    lines = batch_table(results)
    lines += ["", "Peak memory of a process that reads and optimizes city10000 (MB): " +
              ", ".join(f"{name} {peak:.1f}" for name, peak in peaks.items()) + "."]
    readme = pathlib.Path(__file__).with_name("README.md")
    text = readme.read_text(encoding="utf-8")
    begin, end = "<!-- backends.py begin -->\n", "<!-- backends.py end -->"
    head, rest = text.split(begin)
    tail = rest.split(end)[1]
    readme.write_text(head + begin + "\n".join(lines) + "\n" + end + tail, encoding="utf-8")
    print("\n".join(lines))


if __name__ == "__main__":
    main()
