# SPDX-License-Identifier: BSD-3-Clause
"""Kinds of datasets of a study: logs of real robots, those under stress, and the simulator's, in worlds
that somebody drew or in random ones."""
from __future__ import annotations

import dataclasses
import pathlib
from typing import ClassVar

import flags
import ids


@dataclasses.dataclass(frozen=True)
class RecordedDataset:
    """The log of a real robot, scored by hand-checked relations if there are some."""
    tool: ClassVar[str | None] = None  # that makes it, see log_tools.py
    file: pathlib.Path
    relations: pathlib.Path | None

    def content_id(self, seed: int) -> str:
        del seed  # all have the same log
        return ids.content_id("carmen", ids.file_hash(self.file))


@dataclasses.dataclass(frozen=True)
class StressedDataset:
    """A recorded log with something made worse, other places of it by every seed."""
    tool: ClassVar[str | None] = "stress_log"
    recorded: RecordedDataset
    stress: str
    size: float

    def argv(self, seed: int) -> list[str]:
        """Arguments of `stress_log.py`, without those that say where the output goes."""
        relations = [f"--relations={self.recorded.relations}"] if self.recorded.relations else []
        return [f"--log={self.recorded.file}", *relations, f"--stress={self.stress}",
                f"--size={flags.as_text(self.size)}", f"--seed={seed}"]

    def content_id(self, seed: int) -> str:
        relations = self.recorded.relations
        return ids.content_id(
            "stressed", ids.file_hash(self.recorded.file),
            ids.file_hash(relations) if relations else None, self.stress, self.size, seed)


@dataclasses.dataclass(frozen=True)
class SimulatedDataset:
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


@dataclasses.dataclass(frozen=True)
class RandomDataset:
    """A tour through a random building; every seed makes another building, tour and robot."""
    tool: ClassVar[str | None] = "random_world"
    kind: str

    def argv(self, seed: int) -> list[str]:
        """Arguments of `random_world.py`, without --simulate and --output_dir."""
        return [f"--kind={self.kind}", f"--seed={seed}"]

    def content_id(self, seed: int) -> str:
        return ids.content_id("random", self.kind, seed)


Dataset = RecordedDataset | StressedDataset | SimulatedDataset | RandomDataset
