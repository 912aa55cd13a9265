#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Localizes the second half of a log in the map of the first half, from random starts.

    random_starts.py --log=intel.clf.gz --relations=intel.relations.gz --output_dir=DIR
                     [--elsewhere=OTHER.clf.gz ...] [--starts=50] [--seconds=60] [--seed=1] [--jobs=2]

Truth of a pose is that of a run of the whole log, whose map begins in the same frame; truth between the
halves are the relations with an end in each. Prints JSON, and writes starts.csv: a line for each start.
"""
import argparse
import bisect
import concurrent.futures
import csv
import gzip
import json
import math
import pathlib
import random
import subprocess
import sys

WRONG_M, WRONG_RAD = 0.5, math.radians(10)
DRIVEN_M = 3.0  # a start is in the mapped part when the first half was driven so near to it


def read_lines(path):
    opener = gzip.open if path.suffix == ".gz" else open
    with opener(path, "rb") as file:
        return [line for line in file if line.startswith((b"FLASER", b"ROBOTLASER1", b"ODOM"))]


def logger_time(line):
    return float(line.split()[-1])


def read_trajectory(path):
    """(stamp, x, y, theta) of each pose, in the order of stamps."""
    poses = []
    for line in path.read_text().splitlines():
        t, x, y, _, _, _, qz, qw = map(float, line.split())
        poses.append((t, x, y, 2 * math.atan2(qz, qw)))
    return sorted(poses)


def near(poses, stamp, max_gap_s=0.1):
    """The pose whose stamp is nearest, or None."""
    k = bisect.bisect(poses, (stamp,))
    best = min(poses[max(k - 1, 0):k + 1], key=lambda pose: abs(pose[0] - stamp), default=None)
    return best if best and abs(best[0] - stamp) <= max_gap_s else None


def between(a, b):
    dx, dy = b[1] - a[1], b[2] - a[2]
    cos, sin = math.cos(a[3]), math.sin(a[3])
    return cos * dx + sin * dy, -sin * dx + cos * dy, math.remainder(b[3] - a[3], 2 * math.pi)


def relation_error(relations, poses, first_of_second_s):
    """Mean translation error (m) of the relations with an end in each half, and their number."""
    errors = []
    for t_i, t_j, x, y, _, _, _, yaw in relations:
        if (t_i < first_of_second_s) == (t_j < first_of_second_s):
            continue
        i, j = near(poses, t_i), near(poses, t_j)
        if i and j:
            dx, dy, _ = between(i, j)
            cos, sin = math.cos(yaw), math.sin(yaw)
            ex, ey = dx - x, dy - y
            errors.append(math.hypot(cos * ex + sin * ey, -sin * ex + cos * ey))
    return (sum(errors) / len(errors) if errors else math.nan), len(errors)


class Program:
    def __init__(self, bin_dir, folder):
        self.executable, self.folder = bin_dir / "gmapping_spa", folder

    def run(self, name, lines, *flags):
        """Runs on these lines of a log: the record, and the folder of results."""
        log = self.folder / f"{name}.clf"
        log.write_bytes(b"".join(lines))
        out = self.folder / name
        subprocess.run([self.executable, f"--log={log}", f"--output_dir={out}", *flags], check=True,
                       stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        log.unlink()
        return json.loads((out / "run.json").read_text()), out


def cut(lines, start, seconds):
    end = start
    while end < len(lines) and logger_time(lines[end]) - logger_time(lines[start]) <= seconds:
        end += 1
    return lines[start:end]


def judge(record, out, truth, first_half):
    """What came of one start."""
    found = record["session"]["found"]
    wrong = worst_m = 0
    poses = read_trajectory(out / "trajectory.tum")
    for pose in poses:
        true_pose = near(truth, pose[0]) if truth else None
        if true_pose is None:
            wrong += 0 if truth else 1
            continue
        dx, dy, turn = between(true_pose, pose)
        worst_m = max(worst_m, math.hypot(dx, dy))
        wrong += math.hypot(dx, dy) > WRONG_M or abs(turn) > WRONG_RAD
    row = {"found_after_s": found[0]["after_s"] if found else None, "poses": len(poses), "wrong_poses": wrong,
           "largest_error_m": round(worst_m, 3)}
    if truth:
        with open(out / "localization.csv", encoding="ascii") as file:
            start = near(truth, float(next(csv.DictReader(file))["stamp_s"]))
        row["is_mapped"] = start is not None and any(
            math.hypot(p[1] - start[1], p[2] - start[2]) <= DRIVEN_M for p in first_half)
    return row


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--log", type=pathlib.Path, required=True)
    parser.add_argument("--relations", type=pathlib.Path, required=True)
    parser.add_argument("--elsewhere", type=pathlib.Path, nargs="*", default=[], help="logs of other buildings")
    parser.add_argument("--output_dir", type=pathlib.Path, required=True)
    parser.add_argument("--bin_dir", type=pathlib.Path,
                        default=pathlib.Path(__file__).resolve().parents[2] / "build/bin")
    parser.add_argument("--starts", type=int, default=50)
    parser.add_argument("--seconds", type=float, default=60.0, help="of log from each start")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--jobs", type=int, default=2)
    args = parser.parse_args()
    args.output_dir.mkdir(parents=True, exist_ok=True)
    program = Program(args.bin_dir, args.output_dir)

    lines = read_lines(args.log)
    half = len(lines) // 2
    session = args.output_dir / "first.session"
    _, whole = program.run("whole", lines)
    _, first = program.run("first", lines[:half], f"--save_session={session}")
    truth, first_half = read_trajectory(whole / "trajectory.tum"), read_trajectory(first / "trajectory.tum")

    opener = gzip.open if args.relations.suffix == ".gz" else open
    with opener(args.relations, "rt") as file:
        relations = [tuple(map(float, line.split())) for line in file if line.strip()]
    boundary_s = first_half[-1][0] + 1e-6
    result = {"log": args.log.name, "starts": args.starts, "seconds": args.seconds, "seed": args.seed}
    one_run, count = relation_error(relations, truth, boundary_s)
    result["relations_between_halves"] = {"used": count, "one_run_m": round(one_run, 4)}
    flags = [f"--map_session={session}", "--localize"]
    localized_record, localized = program.run("localized", lines[half:], *flags)
    both = sorted(first_half + read_trajectory(localized / "trajectory.tum"))
    result["relations_between_halves"]["localized_m"] = round(relation_error(relations, both, boundary_s)[0], 4)
    result["second_half"] = {key: localized_record["session"][key] for key in ("found", "scans_of_unknown_pose")}

    draw = random.Random(args.seed)

    def one_start(name, log_lines, begin, true_poses, k):
        record, out = program.run(f"{name}_{k}", cut(log_lines, begin, args.seconds), *flags)
        return {"log": name, "start": begin, **judge(record, out, true_poses, first_half)}

    tasks = [("here", lines, draw.randrange(half, len(lines) - 50), truth, k) for k in range(args.starts)]
    for other in args.elsewhere:
        other_lines = read_lines(other)
        tasks += [(other.name.split(".")[0], other_lines, draw.randrange(len(other_lines) - 50), None, k)
                  for k in range(args.starts)]
    rows = []
    with concurrent.futures.ThreadPoolExecutor(args.jobs) as pool:
        for done, row in enumerate(pool.map(lambda task: one_start(*task), tasks), 1):
            rows.append(row)
            print(f"\r{done} of {len(tasks)} starts", end="", file=sys.stderr, flush=True)
    print(file=sys.stderr)

    with open(args.output_dir / "starts.csv", "w", encoding="ascii", newline="") as file:
        writer = csv.DictWriter(file, list(rows[0]))
        writer.writeheader()
        writer.writerows(rows)
    here = [row for row in rows if row["log"] == "here"]
    result["here"] = {
        "in_the_mapped_part": sum(row["is_mapped"] for row in here),
        "found_within_5_s": sum(row["found_after_s"] is not None and row["found_after_s"] <= 5 for row in here),
        "of_these_mapped": sum(row["is_mapped"] and row["found_after_s"] is not None and row["found_after_s"] <= 5
                               for row in here),
        "found_later": sum(row["found_after_s"] is not None and row["found_after_s"] > 5 for row in here),
        "unknown": sum(row["found_after_s"] is None for row in here),
        "wrong": sum(row["wrong_poses"] > 0 for row in here)}
    result["elsewhere_found"] = sum(row["found_after_s"] is not None for row in rows if row["log"] != "here")
    print(json.dumps(result, indent=2))


if __name__ == "__main__":
    main()
