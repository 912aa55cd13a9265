#!/usr/bin/env python3
"""Accuracy, CPU time and memory of plain GMapping on the real logs, as the table of README.md.

Runs gmapping_spa with one thread for every log and seed, one run at a time, and a fixed calibration
loop before each log; replaces the table between the markers of README.md in this folder, and the
short one in the README of the project.
"""
import argparse
import json
import os
import pathlib
import platform
import statistics
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
# The original GMapping (30 particles, updates every 1.0 m / 0.5 rad) on a machine of the same kind:
# mean relation error, CPU seconds, peak memory.
ORIGINAL = {
    "intel": ("0.0393", "112", "122"),
    "fr079": ("1.119", "104", "101"),
    "aces": ("0.0583", "45", "119"),
    "mit-killian": ("-", "-", "-"),
}


def run(*words):
    return subprocess.run(words, check=True, capture_output=True, text=True).stdout


def processor():
    for line in pathlib.Path("/proc/cpuinfo").read_text().splitlines():
        if line.startswith("model name"):
            return line.split(":", 1)[1].strip()
    return platform.machine()


def measure(args, log, seed, folder):
    out = pathlib.Path(folder) / f"{log}-{seed}"
    run(args.bin / "gmapping_spa", f"--flagfile={args.flagfile}", f"--seed={seed}", "--threads=1",
        f"--log={args.data / 'carmen' / (log + '.clf.gz')}", f"--output_dir={out}")
    record = json.loads((out / "run.json").read_text())
    result = {
        "cpu_s": record["resources"]["user_s"] + record["resources"]["system_s"],
        "memory_mb": record["resources"]["peak_memory_mb"],
        "updates": record["counts"]["updates"],
        "map": f"{record['map']['width'] * record['map']['resolution_m']:.0f} x "
               f"{record['map']['height'] * record['map']['resolution_m']:.0f}",
    }
    relations = args.data / "relations" / f"{log}.relations.gz"
    if relations.exists():
        result["errors"] = json.loads(
            run(args.bin / "evaluate_relations", f"--relations={relations}",
                f"--trajectory={out / 'trajectory.tum'}"))
    return result


def errors(results):
    """Median and range over seeds of the mean error, then medians of median error and rotation."""
    if "errors" not in results[0]:
        return "-", "-", "-"
    means = [r["errors"]["translation_m"]["mean"] for r in results]
    middle = statistics.median(r["errors"]["translation_m"]["median"] for r in results)
    rotation = statistics.median(r["errors"]["rotation_deg"]["mean"] for r in results)
    return (f"{statistics.median(means):.4f} ({min(means):.4f} to {max(means):.4f})",
            f"{middle:.4f}", f"{rotation:.2f}")


def rows(log, results, calibration_s):
    """The row of the long table and that of the short one."""
    def median(key):
        return statistics.median(r[key] for r in results)

    translation, middle, rotation = errors(results)
    original = "{} m, {} s, {} MB".format(*ORIGINAL[log])
    cost = f"{median('cpu_s'):.1f} | {median('memory_mb'):.0f}"
    return (f"| {log} | {translation} | {middle} | {rotation} | {cost} | {calibration_s:.2f} | "
            f"{results[0]['updates']} | {results[0]['map']} | {original} |",
            f"| {log} | {translation} | {rotation} | {cost} | {original} |")


def tables(args):
    head = (f"`{' '.join(['experiments/bench/front_end.py', *sys.argv[1:]])}`, {processor()}, "
            f"{len(args.seeds)} seed(s): medians (range).\n")
    long = [head, "| log | mean relation error, m | median, m | mean rotation, deg | CPU s "
            "| peak MB | calibration, CPU s | updates | map, m | original GMapping |",
            "|---|---|---|---|---|---|---|---|---|---|"]
    short = [head, "| log | mean relation error, m | mean rotation, deg | CPU s | peak MB "
             "| original GMapping |", "|---|---|---|---|---|---|"]
    with tempfile.TemporaryDirectory() as folder:
        for log in args.logs:
            calibration_s = json.loads(run(args.bin / "calibration"))["cpu_s"]
            results = []
            for seed in args.seeds:
                print(f"{log}, seed {seed}", file=sys.stderr)
                results.append(measure(args, log, seed, folder))
            for lines, row in zip((long, short), rows(log, results, calibration_s)):
                lines.append(row)
            print(long[-1], file=sys.stderr)
    return "\n".join(long), "\n".join(short)


def replace_table(readme, name, table):
    begin, end = f"<!-- {name} begin -->", f"<!-- {name} end -->"
    text = readme.read_text()
    readme.write_text(f"{text[:text.index(begin)]}{begin}\n{table}\n{text[text.index(end):]}")


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--data", type=pathlib.Path, default=pathlib.Path(
        os.environ.get("GMAPPING_SPA_DATA", ROOT.parent / "shared" / "data")))
    parser.add_argument("--bin", type=pathlib.Path, default=ROOT / "build" / "bin")
    parser.add_argument("--flagfile", type=pathlib.Path,
                        default=ROOT / "experiments" / "flags" / "gmapping.flags")
    parser.add_argument("--logs", nargs="+", default=list(ORIGINAL))
    parser.add_argument("--seeds", nargs="+", type=int, default=[1, 2, 3, 4, 5])
    args = parser.parse_args()
    long, short = tables(args)
    replace_table(pathlib.Path(__file__).with_name("README.md"), "front_end.py", long)
    replace_table(ROOT / "README.md", "results", short)


if __name__ == "__main__":
    main()
