#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Makes a stressed copy of a CARMEN log, and of the relations that score it.

    stress_log.py --log=IN.clf.gz --stress=KIND --seed=S --output=OUT.clf.gz

Scans that are left keep their time stamps, unless the kind is about time. Files are gzipped if
their name ends with .gz.
"""
import argparse
import math
import pathlib
import sys

import carmen
import relations
import stresses


class ListKinds(argparse.Action):
    """Ends like --help, whatever else is missing."""

    def __init__(self, option_strings, dest, **kwargs):
        super().__init__(option_strings, dest, nargs=0, **kwargs)

    def __call__(self, parser, *_):
        print(*stresses.STRESSES, sep="\n")
        parser.exit()


def parse_arguments() -> argparse.Namespace:
    kinds = "\n".join(f"  {name:14} {stress.meaning}"
                      for name, stress in sorted(stresses.STRESSES.items()))
    parser = argparse.ArgumentParser(
        description=__doc__, epilog=f"kinds of stress:\n{kinds}",
        formatter_class=argparse.RawDescriptionHelpFormatter, allow_abbrev=False)
    parser.add_argument("--list", action=ListKinds, help="prints the kinds and ends")
    parser.add_argument("--log", type=pathlib.Path, required=True)
    parser.add_argument("--stress", required=True, choices=sorted(stresses.STRESSES),
                        metavar="KIND")
    parser.add_argument("--seed", type=int, default=1, help="of what is random; at least 0")
    parser.add_argument("--size", type=float, default=1.0,
                        help="scales the stress (its angle, distance, time, share); default: 1")
    parser.add_argument("--first_scans", type=int,
                        help="only that many scans from the start of the log")
    parser.add_argument("--relations", type=pathlib.Path, help="true motions between scans")
    parser.add_argument("--relations_output", type=pathlib.Path,
                        help="the same in the stressed log's time stamps; ends whose scans are "
                        "gone move on to the next scan that has a relation to them")
    parser.add_argument("--output", type=pathlib.Path, required=True)
    args = parser.parse_args()
    if args.seed < 0 or not (math.isfinite(args.size) and args.size > 0):
        parser.error("expected a seed of 0 or more and a size above 0")
    if args.first_scans is not None and args.first_scans < 2:
        parser.error("--first_scans: expected 2 or more")
    if (args.relations is None) != (args.relations_output is None):
        parser.error("--relations and --relations_output need each other")
    return args


def cut(log: carmen.Log, scans: int) -> None:
    """Leaves out what is later than that many scans."""
    kept = log.scans()[:scans]
    log.keep(kept)
    log.records = [r for r in log.records
                   if isinstance(r, carmen.Other) or r.stamp_s <= kept[-1].stamp_s]


def main() -> None:
    args = parse_arguments()
    try:
        log = carmen.read(args.log)
        true_motions = relations.read(args.relations) if args.relations else []
        relations.mark(log, true_motions)
        if args.first_scans:
            cut(log, args.first_scans)
        stresses.apply(log, args.stress, args.seed, args.size)
        carmen.write(log, args.output)
        print(f"{args.output}: {len(log.scans())} scans")
        if args.relations:
            followed = relations.follow(log, true_motions)
            relations.write(followed, args.relations_output)
            print(f"{args.relations_output}: {len(followed)} of {len(true_motions)} relations")
    except (carmen.LogError, OSError) as error:
        sys.exit(f"stress_log.py: error: {error}")


if __name__ == "__main__":
    main()
