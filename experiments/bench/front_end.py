#!/usr/bin/env python3
"""Accuracy, CPU time and memory of the front end on the real logs, as the tables of README.md.

Runs plain GMapping and improved GMapping with one thread for every log and seed, one run at a time,
and a fixed calibration loop before each log; replaces the table between the markers of README.md in
this folder, and the short one in the README of the project.
"""
import argparse
import json
import pathlib
import statistics
import sys
import tempfile

import runs

VARIANTS = [
    ("plain GMapping, 30 particles", [f"--flagfile={runs.FLAGS / 'gmapping.flags'}"]),
    ("improved, 5 particles", ["--particles=5"]),
    ("improved, 1 particle", ["--particles=1"]),
]
# Mean relation error of the best system that was published or measured, and of the original
# GMapping at the settings of gmapping.flags, with its cost on a machine of the same kind.
BEST_KNOWN = {"intel": "0.0195", "fr079": "0.0352", "aces": "0.0375"}
ORIGINAL = {
    "intel": "0.0393 m, 112 s, 122 MB",
    "fr079": "1.119 m, 104 s, 101 MB",
    "aces": "0.0583 m, 45 s, 119 MB",
}


def errors(results):
    """Median and range over seeds of the mean error, then medians of median error and rotation."""
    if "error_m" not in results[0]:
        return "-", "-", "-"
    means = [r["error_m"] for r in results]
    return (f"{statistics.median(means):.4f} ({min(means):.4f} to {max(means):.4f})",
            f"{statistics.median(r['median_m'] for r in results):.4f}",
            f"{statistics.median(r['rotation_deg'] for r in results):.2f}")


def rows(log, variant, results, calibration_s):
    """The row of the long table and that of the short one."""
    translation, middle, rotation = errors(results)
    records = [r["record"] for r in results]
    cost = (f"{statistics.median(r['cpu_s'] for r in results):.1f} | "
            f"{statistics.median(r['memory_mb'] for r in results):.0f}")
    closures = f"{statistics.median(r['loop_closures']['accepted'] for r in records):.0f}"
    size = " x ".join(f"{records[0]['map'][side] * records[0]['map']['resolution_m']:.0f}"
                      for side in ("width", "height"))
    known = BEST_KNOWN.get(log, "-")
    return (f"| {log} | {variant} | {translation} | {middle} | {rotation} | {cost} | "
            f"{calibration_s:.2f} | {records[0]['counts']['updates']} | {closures} | {size} |",
            f"| {log} | {variant} | {translation} | {rotation} | {cost} | {known} | "
            f"{ORIGINAL.get(log, '-')} |")


def tables(args):
    head = (f"`{runs.command('front_end.py')}`, "
            f"{runs.processor()}, {len(args.seeds)} seed(s): medians (range).\n")
    long = [head, "| log | variant | mean relation error, m | median, m | mean rotation, deg | CPU s "
            "| peak MB | calibration, CPU s | updates | closures | map, m |",
            "|---|---|---|---|---|---|---|---|---|---|---|"]
    short = [head, "| log | variant | mean relation error, m | mean rotation, deg | CPU s | peak MB "
             "| best known system | original GMapping |", "|---|---|---|---|---|---|---|---|"]
    with tempfile.TemporaryDirectory() as folder:
        for log in args.logs:
            calibration_s = json.loads(runs.run(args.bin / "calibration"))["cpu_s"]
            for variant, flags in VARIANTS:
                results = []
                for seed in args.seeds:
                    print(f"{log}, {variant}, seed {seed}", file=sys.stderr)
                    results.append(runs.measure(args, log, [*flags, f"--seed={seed}"],
                                                pathlib.Path(folder) / "out"))
                for lines, row in zip((long, short), rows(log, variant, results, calibration_s)):
                    lines.append(row)
                print(long[-1], file=sys.stderr)
    return "\n".join(long), "\n".join(short)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    runs.add_arguments(parser)
    parser.add_argument("--logs", nargs="+", default=list(ORIGINAL))
    parser.add_argument("--seeds", nargs="+", type=int, default=[1, 2, 3, 4, 5])
    args = parser.parse_args()
    long, short = tables(args)
    runs.replace_table(pathlib.Path(__file__).with_name("README.md"), "front_end.py", long)
    runs.replace_table(runs.ROOT / "README.md", "results", short)


if __name__ == "__main__":
    main()
