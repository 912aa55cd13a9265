# SPDX-License-Identifier: BSD-3-Clause
"""Reads from a study which datasets it has; dataset_kinds.py says which kinds there are."""
from __future__ import annotations

import functools
import math
import pathlib

import flags
import log_tools
from dataset_kinds import (Dataset, RandomDataset, RecordedDataset, SimulatedDataset,
                           StressedDataset)
from yaml_entry import Entry, did_you_mean

ROOT = pathlib.Path(__file__).resolve().parents[2]
WORLDS = ROOT / "experiments" / "simulation" / "worlds"

EVERY = "*"
UNSTRESSED = "none"  # a kind of stress: the log as it was recorded

RESERVED = {
    "world": "the dataset's 'world'",
    "path": "the dataset's 'path'",
    "obstacles": "the dataset's 'obstacles'",
    "seed": "the study's 'seeds'",
    "output_dir": "the workflow",
}


def find_file(entry: Entry, *folders: pathlib.Path) -> pathlib.Path:
    """The file that the entry names, from the first folder that has it."""
    name = entry.text()
    for folder in folders:
        if (folder / name).is_file():
            return (folder / name).resolve()
    entry.fail(f"no file '{name}' in {' or '.join(map(str, folders))}")


def read_flag_values(entry: Entry, known: dict[str, str],
                     reserved: dict[str, str]) -> dict[str, flags.Value]:
    values = {}
    for name, value in entry.mapping().items():
        flags.check_name(name, value, known, reserved)
        values[name] = flags.value_of(value, known[name])
    return values


def read_datasets(name: str, entry: Entry, parts: dict[str, Entry], data: pathlib.Path,
              simulator_flags: dict[str, str]) -> dict[str, Dataset]:
    """By name: one dataset, or with a list of stresses the dataset 'NAME KIND' for each of them. `parts`
    are the values below `entry`, those of the study's quick version merged in."""
    sources = parts.keys() & {"carmen", "world", "random"}
    if len(sources) != 1:
        entry.fail("expected one of 'carmen: NAME', 'world: FILE' and 'random: KIND'")
    if "random" in parts:
        for key in parts.keys() - {"random"}:
            parts[key].fail(f"'{key}' is not for random buildings")
        return {name: _read_random(parts["random"])}
    if "world" in parts:
        for key in parts.keys() & {"stress", "size"}:
            parts[key].fail(f"'{key}' is for recorded datasets")
        return {name: _read_simulated(entry, parts, simulator_flags)}
    for key in parts.keys() - {"carmen", "stress", "size"}:
        parts[key].fail(f"'{key}' is for simulated datasets")
    recorded = find_recorded(parts["carmen"], data)
    if "stress" not in parts:
        if "size" in parts:
            parts["size"].fail("expected a 'stress' that it scales, found none")
        return {name: recorded}
    size = _read_size(parts["size"]) if "size" in parts else 1.0
    if not parts["stress"].is_sequence():
        return {name: _read_stressed(parts["stress"], recorded, size)}
    kinds = parts["stress"].sequence()
    found = {f"{name} {kind.text()}": _read_stressed(kind, recorded, size) for kind in kinds}
    if not kinds or len(found) < len(kinds):
        parts["stress"].fail("expected different kinds of stress, one or more")
    return found


def _read_stressed(kind: Entry, recorded: RecordedDataset,
                   size: float) -> RecordedDataset | StressedDataset:
    known = _kinds("stress_log")
    if kind.text() == UNSTRESSED:
        return recorded
    if kind.text() not in known:
        kind.fail(f"unknown stress '{kind.text()}'{did_you_mean(kind.text(), known)}")
    return StressedDataset(recorded, kind.text(), size)


def _read_random(kind: Entry) -> RandomDataset:
    known = _kinds("random_world")
    if kind.text() not in known:
        kind.fail(f"unknown kind of building '{kind.text()}'{did_you_mean(kind.text(), known)}")
    return RandomDataset(kind.text())


_kinds = functools.cache(log_tools.kinds)


def _read_size(entry: Entry) -> float:
    size = flags.value_of(entry, "double")
    if not (math.isfinite(size) and size > 0.0):
        entry.fail(f"expected a number above 0, found {entry.found()}")
    return size


def _read_simulated(entry: Entry, parts: dict[str, Entry],
                    simulator_flags: dict[str, str]) -> SimulatedDataset:
    folders = [entry.file.parent, WORLDS]
    world = find_file(parts["world"], *folders)
    if "path" in parts:
        path = find_file(parts["path"], *folders)
    else:
        path = world.with_suffix(".path.yaml")
        if not path.is_file():
            parts["world"].fail(f"no file '{path}'; name the way points by 'path: FILE'")
    obstacles = None
    if "obstacles" in parts:
        flags.check_name("obstacles", parts["obstacles"], simulator_flags, {})
        obstacles = find_file(parts["obstacles"], *folders)
    values = {}
    if "simulate" in parts:
        values = read_flag_values(parts["simulate"], simulator_flags, RESERVED)
    return SimulatedDataset(world, path, obstacles, values)


def find_recorded(entry: Entry, data: pathlib.Path) -> RecordedDataset:
    """The log of this name in the data folder, and its relations."""
    file = _gzipped_or_not(data / "carmen" / f"{entry.text()}.clf")
    if not file:
        entry.fail(f"no file '{data / 'carmen' / entry.text()}.clf.gz'; --data=DIR says where the "
                   "logs are")
    relations = _gzipped_or_not(data / "relations" / f"{entry.text()}.relations")
    return RecordedDataset(file.resolve(), relations)


def every_recorded_dataset(entry: Entry, data: pathlib.Path) -> dict[str, tuple[Entry, dict]]:
    """`"*": {carmen: "*"}` is all logs of the data folder: entry and parts of each by name."""
    parts = entry.mapping(["carmen"])
    if "carmen" not in parts or parts["carmen"].text() != EVERY:
        entry.fail(f"expected {{carmen: '{EVERY}'}}, which is every recorded log")
    names = sorted({file.name.removesuffix(".gz").removesuffix(".clf")
                    for pattern in ("*.clf", "*.clf.gz")
                    for file in (data / "carmen").glob(pattern)})
    if not names:
        entry.fail(f"no logs in '{data / 'carmen'}'; --data=DIR says where the logs are")
    return {name: (entry, {"carmen": parts["carmen"].with_text(name)}) for name in names}


def _gzipped_or_not(file: pathlib.Path) -> pathlib.Path | None:
    return next((f for f in (file.with_name(f"{file.name}.gz"), file) if f.is_file()), None)
