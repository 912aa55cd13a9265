#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Makes a random building, a tour of it and a robot with a laser, as `simulate` takes them.

    random_world.py --seed=S --output_dir=DIR [--kind=KIND]
    simulate --world=DIR/world.yaml --flagfile=DIR/simulate.flags --output_dir=DIR

DIR gets world.yaml, world.path.yaml and simulate.flags. The same seed and kind make the same bytes.
"""
import argparse
import math
import pathlib
import subprocess
import sys
import zlib

import numpy as np

import floor_plan
import random_robot
import tour
from building_kinds import KINDS

ANY = "any"


class ListKinds(argparse.Action):
    """Ends like --help, whatever else is missing."""

    def __init__(self, option_strings, dest, **kwargs):
        super().__init__(option_strings, dest, nargs=0, **kwargs)

    def __call__(self, parser, *_):
        print(*KINDS, ANY, sep="\n")
        parser.exit()


def parse_arguments() -> argparse.Namespace:
    kinds = "\n".join(f"  {name:10} {kind.meaning}" for name, kind in KINDS.items())
    parser = argparse.ArgumentParser(
        description=__doc__, epilog=f"kinds of buildings, every second of them not along the axes:\n"
        f"{kinds}\n  {ANY:10} one of these, by the seed",
        formatter_class=argparse.RawDescriptionHelpFormatter, allow_abbrev=False)
    parser.add_argument("--list", action=ListKinds, help="prints the kinds and ends")
    parser.add_argument("--seed", type=int, required=True,
                        help="of all that is random, the simulation too; at least 0")
    parser.add_argument("--kind", choices=[*KINDS, ANY], default=ANY, metavar="KIND",
                        help=f"of the building; default: {ANY}")
    parser.add_argument("--output_dir", type=pathlib.Path, required=True,
                        help="folder for the files; made if needed")
    parser.add_argument("--simulate", type=pathlib.Path, metavar="FILE",
                        help="the executable `simulate`: drives the tour, with log and truth into the "
                        "same folder; default: not driven")
    args = parser.parse_args()
    if args.seed < 0:
        parser.error("expected a seed of 0 or more")
    return args


def make(kind: str, seed: int, folder: pathlib.Path) -> None:
    rng = np.random.default_rng([seed, zlib.crc32(kind.encode())])
    if kind == ANY:
        kind = list(KINDS)[rng.integers(len(KINDS))]
    robot = random_robot.draw_robot(rng)
    length_m = random_robot.draw_length_m(robot, rng)
    angle_rad = rng.uniform(0, 2 * math.pi) if rng.random() < 0.5 else 0.0
    robot["max_range"] = max(robot["max_range"], KINDS[kind].least_range_m)
    plan, size_m = KINDS[kind].draw(rng).placed(angle_rad)
    points = tour.draw_tour(tour.free_cells(plan, size_m), length_m, rng)
    folder.mkdir(parents=True, exist_ok=True)
    floor_plan.write_world(folder / "world.yaml", plan, size_m)
    tour.write_tour(folder / "world.path.yaml", points)
    flags = {"seed": seed, **robot}
    (folder / "simulate.flags").write_text("".join(
        f"--{name}={str(value).lower()}\n" for name, value in flags.items()))


def drive(simulate: pathlib.Path, folder: pathlib.Path) -> None:
    done = subprocess.run(
        [simulate, f"--world={folder / 'world.yaml'}", f"--flagfile={folder / 'simulate.flags'}",
         f"--output_dir={folder}"], capture_output=True, text=True)
    if done.returncode != 0:
        sys.exit((done.stderr.strip().splitlines() or ["simulate: no message"])[-1])


def main() -> None:
    args = parse_arguments()
    try:
        make(args.kind, args.seed, args.output_dir)
        if args.simulate:
            drive(args.simulate, args.output_dir)
    except (tour.NoTourError, OSError) as error:
        sys.exit(f"random_world.py: error: {error}")


if __name__ == "__main__":
    main()
