"""The logs of a study: files of real robots, those under stress, or the simulator's."""
from __future__ import annotations

import dataclasses
import pathlib
from typing import ClassVar

import flags
import ids


@dataclasses.dataclass(frozen=True)
class CarmenLog:
    """A recorded log, scored by hand-checked relations if there are some."""
    tool: ClassVar[str | None] = None  # that makes it, see log_tools.py
    file: pathlib.Path
    relations: pathlib.Path | None

    def content_id(self, seed: int) -> str:
        del seed  # all have the same log
        return ids.content_id("carmen", ids.file_hash(self.file))


@dataclasses.dataclass(frozen=True)
class StressedLog:
    """A recorded log with something made worse, other places of it by every seed."""
    tool: ClassVar[str | None] = "stress_log"
    carmen: CarmenLog
    stress: str
    size: float

    def argv(self, seed: int) -> list[str]:
        """Arguments of `stress_log.py`, without those that say where the output goes."""
        relations = [f"--relations={self.carmen.relations}"] if self.carmen.relations else []
        return [f"--log={self.carmen.file}", *relations, f"--stress={self.stress}",
                f"--size={flags.as_text(self.size)}", f"--seed={seed}"]

    def content_id(self, seed: int) -> str:
        relations = self.carmen.relations
        return ids.content_id(
            "stressed", ids.file_hash(self.carmen.file),
            ids.file_hash(relations) if relations else None, self.stress, self.size, seed)


@dataclasses.dataclass(frozen=True)
class SimulatedLog:
    """A tour of a robot through a world; every seed makes another log of it."""
    tool: ClassVar[str | None] = "simulate"
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


Log = CarmenLog | StressedLog | SimulatedLog
