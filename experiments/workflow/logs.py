"""Where the logs of a study come from: files of real robots, or the simulator."""
from __future__ import annotations

import dataclasses
import pathlib

import flags
import ids
from yaml_entry import Entry

ROOT = pathlib.Path(__file__).resolve().parents[2]
WORLDS = ROOT / "experiments" / "simulation" / "worlds"

EVERY = "*"

RESERVED = {
    "world": "the log's 'world'",
    "path": "the log's 'path'",
    "obstacles": "the log's 'obstacles'",
    "seed": "the study's 'seeds'",
    "output_dir": "the workflow",
}


@dataclasses.dataclass(frozen=True)
class CarmenLog:
    """A recorded log, scored by hand-checked relations if there are some."""
    file: pathlib.Path
    relations: pathlib.Path | None

    def content_id(self) -> str:
        return ids.content_id("carmen", ids.file_hash(self.file))


@dataclasses.dataclass(frozen=True)
class SimulatedLog:
    """A tour of a robot through a world; every seed makes another log of it."""
    world: pathlib.Path
    path: pathlib.Path
    obstacles: pathlib.Path | None
    flags: dict[str, flags.Value]

    def argv(self, seed: int) -> list[str]:
        """Arguments of `simulate`, without --output_dir."""
        files = [f"--world={self.world}", f"--path={self.path}"]
        if self.obstacles:
            files.append(f"--obstacles={self.obstacles}")
        return [*files, *flags.as_arguments(self.flags), f"--seed={seed}"]

    def content_id(self, seed: int) -> str:
        return ids.content_id(
            "simulated", ids.world_hash(self.world), ids.file_hash(self.path),
            ids.file_hash(self.obstacles) if self.obstacles else None,
            flags.as_arguments(self.flags), seed)


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


def read_log(entry: Entry, parts: dict[str, Entry], data: pathlib.Path,
             simulator_flags: dict[str, str]) -> CarmenLog | SimulatedLog:
    """`parts` are the values below `entry`, those of the study's quick version merged in."""
    if ("carmen" in parts) == ("world" in parts):
        entry.fail("expected either 'carmen: NAME' or 'world: FILE'")
    if "carmen" in parts:
        for key in parts.keys() - {"carmen"}:
            parts[key].fail(f"'{key}' is for simulated logs")
        file = find_file_of_log(parts["carmen"], data)
        relations = data / "relations" / f"{parts['carmen'].text()}.relations"
        return CarmenLog(file, _gzipped_or_not(relations))
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
    return SimulatedLog(world, path, obstacles, values)


def find_file_of_log(entry: Entry, data: pathlib.Path) -> pathlib.Path:
    file = _gzipped_or_not(data / "carmen" / f"{entry.text()}.clf")
    if not file:
        entry.fail(f"no file '{data / 'carmen' / entry.text()}.clf.gz'; --data=DIR says where the "
                   "logs are")
    return file.resolve()


def every_recorded_log(entry: Entry, data: pathlib.Path) -> dict[str, tuple[Entry, dict]]:
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
