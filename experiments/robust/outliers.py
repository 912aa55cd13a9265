#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Optimizes graphs with wrong loop closures, and reports how far from the truth the poses end.

    experiments/robust/outliers.py STUDY.yaml --graphs FOLDER --bin build/bin --output_dir out/robust

Writes results.csv (a line for each optimization), outliers.md and recognized.md (tables), and
outliers.png. Optimizations that results.csv has are not done again.
"""
import argparse
import csv
import gzip
import json
import pathlib
import subprocess
import tempfile

import numpy as np
import yaml
from wrong_closures import add_wrong_closures

FIELDS = ["graph", "policy", "count", "draw", "configuration", "error_m", "cpu_s",
          "right_rejected", "wrong_accepted"]
TIMEOUT_S = 600


def lines_of(path):
    with gzip.open(path, "rt") as lines:
        return lines.read().splitlines()


def positions(lines):
    """Positions (m) of the vertices of a .g2o file, in its order."""
    return np.array([[float(word) for word in line.split()[2:4]] for line in lines
                     if line.startswith("VERTEX_SE2 ")])


def errors_after_alignment(estimate, truth):
    """Distances (m) between positions after the rigid alignment that makes their squares least."""
    a, b = estimate - estimate.mean(0), truth - truth.mean(0)
    u, _, vt = np.linalg.svd(a.T @ b)
    rotation = u @ np.diag([1.0, np.linalg.det(u @ vt)]) @ vt
    return np.linalg.norm(a @ rotation - b, axis=1)


def optimize(lines, flags, executables):
    """Optimized positions, the summary, or None when it failed or took too long."""
    with tempfile.TemporaryDirectory() as folder:
        graph, result = pathlib.Path(folder) / "graph.g2o", pathlib.Path(folder) / "result.g2o"
        graph.write_text("\n".join(lines) + "\n")
        command = [executables / "optimize_graph", f"--input={graph}", f"--output={result}"]
        try:
            done = subprocess.run(command + flags.split(), capture_output=True, text=True,
                                  timeout=TIMEOUT_S, check=True)
        except (subprocess.CalledProcessError, subprocess.TimeoutExpired):
            return None
        return positions(result.read_text().splitlines()), json.loads(done.stdout)


def outlier_tasks(study, graphs):
    """(keys of the result, lines of the graph, score of positions, wrong closures)."""
    clean = lines_of(graphs / study["clean_graph"])
    truth = np.array([[float(w) for w in line.split()[:2]] for line in lines_of(graphs / study["truth"])])

    def rmse(found):
        return float(np.sqrt(np.mean(errors_after_alignment(found, truth) ** 2)))

    name = study["clean_graph"].split(".")[0]
    yield (name, "none", 0, 1), clean, rmse, set()
    for policy in study["policies"]:
        for count in study["counts"]:
            for draw in range(1, study["draws"] + 1):
                lines, wrong = add_wrong_closures(clean, policy, count, draw)
                yield (name, policy, count, draw), lines, rmse, wrong


def recognized_tasks(study, graphs):
    spec = study["recognized"]
    stamps = np.array([float(line) for line in lines_of(graphs / spec["stamps"])])
    truth = np.array([[float(w) for w in line.split(",")] for line in lines_of(graphs / spec["truth"])])
    after = np.searchsorted(truth[:, 0], stamps)
    known = (after > 0) & (after < len(truth))
    known[known] &= np.diff(truth[:, 0])[after[known] - 1] <= 1.0  # gaps are not bridged
    at = np.stack([np.interp(stamps, truth[:, 0], truth[:, k]) for k in (1, 2)], axis=1)

    def mean_error(found):
        return float(np.mean(errors_after_alignment(found[known], at[known])))

    for graph in spec["graphs"]:
        yield (graph.split("/")[-1].removesuffix(".g2o.gz"), "recognized", "", 1), \
            lines_of(graphs / graph), mean_error, None


def run(study, args):
    results_file = args.output_dir / "results.csv"
    rows = []
    if results_file.exists():
        with results_file.open() as file:
            rows = list(csv.DictReader(file))
    done = {tuple(row[key] for key in FIELDS[:5]) for row in rows}
    with results_file.open("a", newline="") as file:
        writer = csv.DictWriter(file, FIELDS)
        if not rows:
            writer.writeheader()
        tasks = list(recognized_tasks(study, args.graphs)) + list(outlier_tasks(study, args.graphs))
        for number, (keys, lines, score, wrong) in enumerate(tasks, 1):
            for configuration, how in study["configurations"].items():
                if keys[3] > how.get("draws", keys[3]) or (keys[2] or 0) > how.get("max_count", 1e9):
                    continue
                row = dict(zip(FIELDS, [*map(str, keys), configuration]))
                if tuple(row[key] for key in FIELDS[:5]) in done:
                    continue
                result = optimize(lines, how["flags"], args.bin)
                if result is not None:
                    found, summary = result
                    row["error_m"], row["cpu_s"] = score(found), summary["cpu_s"]
                    rejected = {(edge["i"], edge["j"]) for edge in summary["loop_closures"]["rejected_edges"]}
                    if wrong is not None:
                        row["right_rejected"] = len(rejected - wrong)
                        row["wrong_accepted"] = len(wrong - rejected)
                    else:
                        row["right_rejected"] = row["wrong_accepted"] = ""
                writer.writerow(row)
                file.flush()
                rows.append({key: str(row.get(key, "")) for key in FIELDS})
            print(f"{number}/{len(tasks)} {' '.join(map(str, keys))}", flush=True)
    return rows


def spread(values, digits):
    """Median [min, max]; 'failed' stands for optimizations without a result."""
    found = [float(value) for value in values if value]
    failed = len(values) - len(found)
    if not values:
        return "not run"
    text = f"{np.median(found):.{digits}f} [{min(found):.{digits}f}, {max(found):.{digits}f}]" if found else ""
    return (text + (f", {failed} failed" if failed else "")).lstrip(", ")


def write_tables(study, rows, folder):
    names = list(study["configurations"])
    head = "| wrong closures | " + " | ".join(f"{name}, RMSE m | CPU s" for name in names) + " |"
    lines = [head, "| --- |" + " ---: | ---: |" * len(names)]
    kinds = list(dict.fromkeys((r["policy"], r["count"]) for r in rows if r["policy"] != "recognized"))
    for policy, count in kinds:
        cells = []
        for name in names:
            chosen = [r for r in rows if (r["policy"], r["count"], r["configuration"]) == (policy, count, name)]
            cells += [spread([r["error_m"] for r in chosen], 3), spread([r["cpu_s"] for r in chosen], 2)]
        lines.append(f"| {count} {policy if count != '0' else ''} | " + " | ".join(cells) + " |")
    (folder / "outliers.md").write_text("\n".join(lines) + "\n")

    graphs = list(dict.fromkeys(r["graph"] for r in rows if r["policy"] == "recognized"))
    lines = ["| graph | " + " | ".join(names) + " |", "| --- |" + " ---: |" * len(names)]
    for graph in graphs:
        chosen = {r["configuration"]: r["error_m"] for r in rows if r["graph"] == graph}
        lines.append(f"| {graph} | " + " | ".join(spread([chosen.get(n, '')], 3).split(" ")[0] for n in names) + " |")
    (folder / "recognized.md").write_text("\n".join(lines) + "\n")


def draw(study, rows, file):
    import matplotlib
    matplotlib.use("Agg")
    from matplotlib import pyplot
    figure, axes = pyplot.subplots(1, len(study["policies"]), figsize=(10, 3), sharey=True)
    for axis, policy in zip(axes, study["policies"]):
        for offset, name in enumerate(study["configurations"]):
            points = [(float(r["count"]), float(r["error_m"])) for r in rows
                      if r["policy"] == policy and r["configuration"] == name and r["error_m"]]
            if points:
                x, y = zip(*points)
                axis.plot(np.array(x) * 1.12 ** (offset - 2), y, ".", label=name)
        axis.set(xscale="log", yscale="log", title=policy, xlabel="wrong loop closures")
    axes[0].set_ylabel("RMSE (m)")
    axes[-1].legend(fontsize=7)
    figure.tight_layout()
    figure.savefig(file, dpi=110)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("study", type=pathlib.Path)
    parser.add_argument("--graphs", type=pathlib.Path, required=True, help="folder of the graphs")
    parser.add_argument("--bin", type=pathlib.Path, required=True, help="folder of the executables")
    parser.add_argument("--output_dir", type=pathlib.Path, required=True)
    args = parser.parse_args()
    study = yaml.safe_load(args.study.read_text())
    args.output_dir.mkdir(parents=True, exist_ok=True)
    rows = run(study, args)
    write_tables(study, rows, args.output_dir)
    draw(study, rows, args.output_dir / "outliers.png")


if __name__ == "__main__":
    main()
