#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Writes the paper's studies anew for a world of the reader's own, and prints those that can run.

Studies with obstacles need obstacles for that world; without --obstacles they are written for the
claims' sake, but not printed. The world, its tour and its obstacles are driven once, so that a bad
file is one line now and not a failed run later.
"""
import argparse
import pathlib
import subprocess
import sys
import tempfile

import yaml

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "experiments" / "workflow"))

import flags  # noqa: E402


def parse_arguments() -> argparse.Namespace:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("studies", nargs="+", type=pathlib.Path, metavar="STUDY.yaml")
    parser.add_argument("--world", required=True, type=pathlib.Path)
    parser.add_argument("--path", type=pathlib.Path,
                        help="way points; default: the world's name with .path.yaml")
    parser.add_argument("--obstacles", type=pathlib.Path)
    parser.add_argument("--output", required=True, type=pathlib.Path, help="folder of the studies")
    parser.add_argument("--bin", type=pathlib.Path, default=ROOT / "build" / "bin")
    args = parser.parse_args()
    args.path = args.path or args.world.with_suffix(".path.yaml")
    for flag in ("world", "path", "obstacles"):
        file = getattr(args, flag)
        if file is not None and not file.is_file():
            sys.exit(f"in_another_world.py: error: --{flag}={file}: no such file")
        setattr(args, flag, file and file.resolve())
    return args


def simulated_datasets(study: dict) -> list[dict]:
    """Of the study and its quick version, which names what differs only."""
    entries = [entry for part in (study, study.get("quick", {}))
               for entry in part.get("datasets", {}).values()]
    return [entry for entry in entries if isinstance(entry, dict) and "carmen" not in entry]


def move(study: dict, args: argparse.Namespace) -> None:
    """Each dataset of the study gets the world, and its tour instead of the paper's long or short one."""
    study["title"] += f" (world {args.world.stem})"
    study["description"] = (f"In the world {args.world.name} instead of the paper's building. What the "
                            f"study says of that: {study['description']}")
    for dataset in simulated_datasets(study):
        dataset.pop("path", None)
        if "world" in dataset:
            dataset |= {"world": str(args.world), "path": str(args.path)}
        if "obstacles" in dataset and args.obstacles:
            dataset["obstacles"] = str(args.obstacles)


def drive(dataset: dict, binaries: pathlib.Path) -> None:
    """One tour with a coarse laser; ends with the simulator's message when that fails."""
    words = [f"--{key}={dataset[key]}" for key in ("world", "path", "obstacles") if key in dataset]
    with tempfile.TemporaryDirectory() as folder:
        done = subprocess.run(
            [binaries / "simulate", *words, *flags.as_arguments(dataset.get("simulate", {})),
             "--angular_resolution=30", f"--output_dir={folder}"], capture_output=True, text=True)
    if done.returncode != 0:
        sys.exit((done.stderr.strip().splitlines() or ["simulate failed without a word"])[-1])


def main() -> None:
    args = parse_arguments()
    studies = {file: yaml.safe_load(file.read_text()) for file in args.studies}
    runnable = [file for file, study in studies.items() if args.obstacles or not any(
        "obstacles" in dataset for dataset in simulated_datasets(study))]
    for study in studies.values():
        move(study, args)
    driven = []
    for file in runnable:
        for dataset in simulated_datasets(studies[file]):
            if "world" in dataset and dataset not in driven:
                drive(dataset, args.bin)
                driven.append(dataset)
    args.output.mkdir(parents=True, exist_ok=True)
    for file, study in studies.items():
        (args.output / file.name).write_text(yaml.safe_dump(study, sort_keys=False, width=100))
    for file in {file.parent / "claims.yaml" for file in studies}:
        if file.is_file():
            (args.output / "claims.yaml").write_bytes(file.read_bytes())
    left_out = [file.stem for file in studies if file not in runnable]
    if left_out:
        print(f"left out for want of --obstacles=FILE: {', '.join(left_out)}", file=sys.stderr)
    print(*(args.output / file.name for file in runnable), sep="\n")


if __name__ == "__main__":
    main()
