#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Certifies the least squares of graphs, from a good start and from the poses of the files.

    experiments/robust/certificate.py --bin build/bin --output_dir out/certificate GRAPH.g2o.gz...

Writes certificate.json (all that optimize_graph says) and two tables: certified.md, of the back end
spa, and escaped.md, of Ceres from the poses of the file, as it ends and after the descent. CPU times
are medians of --repeats runs, taken in turns.
"""
import argparse
import json
import pathlib
import statistics
import subprocess

RUNS = {"spa": "--backend=spa --certify",
        "ceres": "--backend=ceres --init=keep --certify --nocertify_descend",
        "descent": "--backend=ceres --init=keep --certify"}


def optimize(graph, flags, executables):
    """What optimize_graph says of the least squares of a graph."""
    command = [executables / "optimize_graph", f"--input={graph}", "--loss=none", *flags.split()]
    done = subprocess.run(command, capture_output=True, text=True)
    if done.returncode not in (0, 2):  # 2: not proved
        raise SystemExit(f"certificate.py: error: {graph}: {done.stderr.strip()}")
    return json.loads(done.stdout)


def run(graph, args):
    """One result for each of RUNS, whose times are medians."""
    results = [{name: optimize(graph, flags, args.bin) for name, flags in RUNS.items()}
               for _ in range(args.repeats)]
    first = results[0]
    for name in RUNS:
        first[name]["cpu_s"] = statistics.median(r[name]["cpu_s"] for r in results)
        first[name]["certificate"]["cpu_s"] = statistics.median(
            r[name]["certificate"]["cpu_s"] for r in results)
    return first


def verdict(certificate):
    if certificate["optimal"]:
        return f"optimal, to {certificate['relative_suboptimality']:.0e}"
    if certificate["lower_bound"] > 0:
        return f"undecided, to {certificate['relative_suboptimality']:.0e}"
    return "not proved"


def milliseconds(seconds):
    return f"{1e3 * seconds:.3g}"


def write_table(path, head, rows):
    lines = [head, ["---"] + ["---:"] * (len(head) - 1), *rows]
    path.write_text("".join("| " + " | ".join(line) + " |\n" for line in lines))


def write_tables(results, folder):
    certified, escaped = [], []
    for name, result in results.items():
        spa, ceres, descent = result["spa"], result["ceres"], result["descent"]
        certified.append([name, str(spa["nodes"]), str(spa["edges"]), f"{spa['final_cost']:.7g}",
                          verdict(spa["certificate"]), milliseconds(spa["cpu_s"]),
                          milliseconds(spa["certificate"]["cpu_s"]), milliseconds(ceres["cpu_s"])])
        steps = descent["certificate"]["descents"]
        if not any(step["rank"] > 0 for step in steps):
            continue
        escaped.append([name, f"{ceres['final_cost']:.7g}", verdict(ceres["certificate"]),
                        f"{steps[0]['cost']:.7g}", f"{descent['final_cost']:.7g}",
                        verdict(descent["certificate"]), milliseconds(ceres["cpu_s"]),
                        milliseconds(descent["certificate"]["cpu_s"])])
    write_table(folder / "certified.md",
                ["graph", "poses", "edges", "cost", "certificate", "spa, CPU ms",
                 "certificate, CPU ms", "Ceres, CPU ms"], certified)
    write_table(folder / "escaped.md",
                ["graph", "Ceres ends at", "certificate there", "its local minimum",
                 "after the descent", "certificate", "Ceres, CPU ms", "descent, CPU ms"], escaped)


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("graphs", nargs="+", type=pathlib.Path, metavar="GRAPH")
    parser.add_argument("--bin", type=pathlib.Path, required=True, help="folder of the executables")
    parser.add_argument("--output_dir", type=pathlib.Path, required=True)
    parser.add_argument("--repeats", type=int, default=3)
    args = parser.parse_args()
    args.output_dir.mkdir(parents=True, exist_ok=True)
    results = {}
    for graph in args.graphs:
        results[graph.name.split(".")[0]] = run(graph, args)
        print(f"{len(results)}/{len(args.graphs)} {graph}", flush=True)
    (args.output_dir / "certificate.json").write_text(json.dumps(results, indent=1) + "\n")
    write_tables(results, args.output_dir)


if __name__ == "__main__":
    main()
