#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Precision of the loop closures of a run: what the hand-checked relations say about them.

    experiments/bench/closures.py OUTPUT_DIR RELATIONS

A closure is judged by the relations both of whose ends were taken near its own, within a few
seconds and metres; the little way in between is bridged by the trajectory of the run. It is
violated when the median of what they say is off by more than --max_m or --max_deg: single relations
are off by more than a degree themselves. Prints JSON.
"""
import argparse
import bisect
import csv
import gzip
import json
import math
import pathlib
import statistics


def compose(a, b):
    c, s = math.cos(a[2]), math.sin(a[2])
    return (a[0] + c * b[0] - s * b[1], a[1] + s * b[0] + c * b[1],
            math.remainder(a[2] + b[2], 2 * math.pi))


def inverse(a):
    c, s = math.cos(a[2]), math.sin(a[2])
    return -c * a[0] - s * a[1], s * a[0] - c * a[1], -a[2]


class Trajectory:
    def __init__(self, path):
        rows = [[float(word) for word in line.split()] for line in path.read_text().splitlines()]
        self.poses = sorted((r[0], (r[1], r[2], 2 * math.atan2(r[6], r[7]))) for r in rows)
        self.stamps = [stamp for stamp, _ in self.poses]

    def at(self, stamp):
        k = bisect.bisect(self.stamps, stamp)
        return min(self.poses[max(k - 1, 0):k + 1], key=lambda p: abs(p[0] - stamp))[1]


def read_relations(path):
    """(stamp i, stamp j, i_T_j), both ways round."""
    with gzip.open(path, "rt") as lines:
        for line in lines:
            values = [float(word) for word in line.split()]
            if len(values) == 8:
                pose = (values[2], values[3], values[7])
                yield values[0], values[1], pose
                yield values[1], values[0], inverse(pose)


def errors(closure, relations, trajectory, args):
    """(m, deg) between the closure and each relation that can judge it."""
    i, j = float(closure["old_stamp_s"]), float(closure["stamp_s"])
    measured = tuple(float(closure[key]) for key in ("x_m", "y_m", "theta_rad"))
    for stamp_i, stamp_j, relation in relations:
        if max(abs(stamp_i - i), abs(stamp_j - j)) > args.near_s:
            continue
        to_i = compose(inverse(trajectory.at(i)), trajectory.at(stamp_i))
        to_j = compose(inverse(trajectory.at(stamp_j)), trajectory.at(j))
        if max(math.hypot(*to_i[:2]), math.hypot(*to_j[:2])) > args.near_m:
            continue
        off = compose(inverse(measured), compose(compose(to_i, relation), to_j))
        yield math.hypot(*off[:2]), math.degrees(abs(off[2]))


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("output_dir", type=pathlib.Path)
    parser.add_argument("relations", type=pathlib.Path)
    parser.add_argument("--near_s", type=float, default=20.0)
    parser.add_argument("--near_m", type=float, default=3.0)
    parser.add_argument("--max_m", type=float, default=0.2)
    parser.add_argument("--max_deg", type=float, default=1.0)
    args = parser.parse_args()

    trajectory = Trajectory(args.output_dir / "trajectory.tum")
    relations = list(read_relations(args.relations))
    with open(args.output_dir / "loop_closures.csv") as table:
        accepted = [row for row in csv.DictReader(table) if row["verdict"] == "accepted"]
    judged, violated = [], []
    for closure in accepted:
        found = list(errors(closure, relations, trajectory, args))
        if not found:
            continue
        error = tuple(statistics.median(values) for values in zip(*found))
        judged.append(error)
        if error[0] > args.max_m or error[1] > args.max_deg:
            violated.append({"old_node": int(closure["old_node"]), "node": int(closure["node"]),
                             "error_m": error[0], "error_deg": error[1], "relations": len(found)})
    print(json.dumps({
        "accepted": len(accepted), "judged": len(judged), "violated": violated,
        "precision": 1 - len(violated) / len(judged) if judged else None,
        "median_error_m": statistics.median(e[0] for e in judged) if judged else None,
        "median_error_deg": statistics.median(e[1] for e in judged) if judged else None,
    }, indent=2))


if __name__ == "__main__":
    main()
