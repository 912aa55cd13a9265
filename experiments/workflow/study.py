# SPDX-License-Identifier: BSD-3-Clause
"""A study: which runs one YAML file asks for. Complains in one line before anything runs."""
from __future__ import annotations

import dataclasses
import itertools
import pathlib
from typing import Any

import datasets
import flags
import ids
from dataset_kinds import Dataset, RecordedDataset, SimulatedDataset
from figure import Figure, read_figures
from metrics import METRICS
from yaml_entry import Entry, StudyError, did_you_mean, read_yaml

__all__ = ["Configuration", "Run", "Study", "StudyError", "load_study"]

FLAGS = datasets.ROOT / "experiments" / "flags"
KEYS = ["title", "description", "datasets", "seeds", "flags", "variants", "axes", "metrics",
        "compare", "figures"]
DATASET_KEYS = ["carmen", "stress", "size", "world", "path", "obstacles", "simulate", "random"]
SIMULATE = "simulate."  # begins the name of an axis over a flag of the simulator
RESERVED = {
    "log": "the study's 'datasets'",
    "seed": "the study's 'seeds'",
    "output_dir": "the workflow",
}


@dataclasses.dataclass(frozen=True)
class Variant:
    flagfile: pathlib.Path | None
    flags: dict[str, flags.Value]


@dataclasses.dataclass(frozen=True)
class Configuration:
    """One dataset, one variant, one value of each axis: what the seeds of a comparison share."""
    dataset: str
    variant: str
    axes: dict[str, flags.Value]

    def label(self) -> str:
        values = [f"{name}={flags.as_text(value)}" for name, value in self.axes.items()]
        return ", ".join([self.dataset, *([self.variant] if self.variant else []), *values])

    def coordinates(self) -> dict[str, Any]:
        """What a selector can name: dataset, variant and axes."""
        return {"dataset": self.dataset, "variant": self.variant, **self.axes}


@dataclasses.dataclass(frozen=True)
class Run:
    """A configuration with a seed."""
    id: str
    configuration: Configuration
    seed: int
    log_id: str | None  # of a log that is made for the study
    log_tool: str | None  # that makes it, with these arguments and those for its output
    log_argv: list[str] | None
    log_file: pathlib.Path | None  # of a recorded log
    relations: pathlib.Path | None  # that score a recorded log; a log that is made has its own
    argv: list[str]  # arguments of `gmapping_spa`, without --log and --output_dir


@dataclasses.dataclass(frozen=True)
class Study:
    name: str
    path: pathlib.Path
    title: str
    description: str
    metrics: list[str]
    compare: list[tuple[dict[str, Any], dict[str, Any]]]
    figures: list[Figure]
    configurations: list[Configuration]
    seeds: list[int]
    runs: list[Run]

    def select(self, selector: dict[str, Any]) -> list[Configuration]:
        """The configurations with these coordinates."""
        return [c for c in self.configurations if selector.items() <= c.coordinates().items()]


def load_study(path: pathlib.Path, binaries: pathlib.Path, data: pathlib.Path,
               quick: bool = False) -> Study:
    """Reads and checks the study, its quick version included, and returns one of the two."""
    path = pathlib.Path(path)
    reader = _Reader(path, pathlib.Path(binaries), pathlib.Path(data))
    return reader.quick if quick else reader.full


class _Reader:
    def __init__(self, path: pathlib.Path, binaries: pathlib.Path, data: pathlib.Path):
        self.slam_flags = flags.read_flags(binaries / "gmapping_spa")
        self.simulator_flags = flags.read_flags(binaries / "simulate")
        self.path, self.data = path, data
        self.root = read_yaml(path)
        parts = self.root.mapping([*KEYS, "quick"])
        changes = parts.pop("quick").mapping(KEYS) if "quick" in parts else {}
        dataset_parts = self._dataset_parts(parts)
        self.full = self._study(parts, dataset_parts, compared_must_exist=True)
        dataset_parts = _merged(dataset_parts, self._dataset_parts(changes))
        self.quick = self._study(parts | changes, dataset_parts,
                                 compared_must_exist="compare" in changes)

    def _dataset_parts(self, parts: dict[str, Entry]) -> dict[str, tuple[Entry, dict[str, Entry]]]:
        """Each dataset's entry and its parts; none for `null`, which leaves one out when quick."""
        if "datasets" not in parts:
            return {}
        found = {}
        for name, entry in parts["datasets"].mapping().items():
            if name == datasets.EVERY:
                found |= datasets.every_recorded_dataset(entry, self.data)
            else:
                found[name] = (entry, {} if entry.is_null() else entry.mapping(DATASET_KEYS))
        return found

    def _study(self, parts: dict[str, Entry],
               dataset_parts: dict[str, tuple[Entry, dict[str, Entry]]],
               compared_must_exist: bool) -> Study:
        for key in ("title", "datasets", "seeds", "metrics"):
            if key not in parts:
                self.root.fail(f"'{key}' is missing")
        sources = self._sources(dataset_parts)
        if not sources:
            parts["datasets"].fail("expected one dataset or more, found none")
        common = self._slam_flags(parts["flags"]) if "flags" in parts else {}
        variants = self._variants(parts["variants"]) if "variants" in parts else {
            "": Variant(None, {})}
        axes = self._axes(parts["axes"], sources, common, variants) if "axes" in parts else {}
        seeds = _seeds(parts["seeds"])
        configurations = [Configuration(dataset, variant, dict(zip(axes, values)))
                          for dataset in sources for variant in variants
                          for values in itertools.product(*axes.values())]
        study = Study(
            name=self.path.stem, path=self.path, title=parts["title"].text(),
            description=parts["description"].text().strip() if "description" in parts else "",
            metrics=_metrics(parts["metrics"]), compare=[], figures=[],
            configurations=configurations, seeds=seeds,
            runs=[_run(c, seed, sources[c.dataset], common, variants[c.variant])
                  for c in configurations for seed in seeds])
        if "compare" in parts:
            study.compare.extend(_compare(parts["compare"], study, compared_must_exist))
        if "figures" in parts:
            study.figures.extend(read_figures(parts["figures"], study))
        return study

    def _sources(
            self, dataset_parts: dict[str, tuple[Entry, dict[str, Entry]]]) -> dict[str, Dataset]:
        sources: dict[str, Dataset] = {}
        for name, (entry, below) in dataset_parts.items():
            found = datasets.read_datasets(name, entry, below, self.data, self.simulator_flags)
            for twice in found.keys() & sources.keys():
                entry.fail(f"the dataset '{twice}' is there twice")
            sources |= found
        return sources

    def _slam_flags(self, entry: Entry) -> dict[str, flags.Value]:
        return datasets.read_flag_values(entry, self.slam_flags, RESERVED)

    def _variants(self, entry: Entry) -> dict[str, Variant]:
        variants = {}
        known = {**self.slam_flags, "flagfile": "string"}
        for name, below in entry.mapping().items():
            values = datasets.read_flag_values(below, known, RESERVED)
            file = None
            if values.pop("flagfile", None):
                file = datasets.find_file(below.mapping()["flagfile"], self.path.parent, FLAGS)
            variants[name] = Variant(file, values)
        if not variants:
            entry.fail("expected one variant or more, found none")
        return variants

    def _axes(self, entry: Entry, sources: dict[str, Dataset],
              common: dict[str, flags.Value],
              variants: dict[str, Variant]) -> dict[str, list[flags.Value]]:
        axes = {}
        for name, values in entry.mapping().items():
            if name.startswith(SIMULATE):
                flag, known, reserved = (
                    name.removeprefix(SIMULATE), self.simulator_flags, datasets.RESERVED)
                for dataset, source in sources.items():
                    if not isinstance(source, SimulatedDataset):
                        values.fail(f"is for datasets with a 'world'; '{dataset}' has none")
            else:
                flag, known, reserved = name, self.slam_flags, RESERVED
                for label, others in [("'flags'", common)] + [
                        (f"variant '{v}'", variant.flags) for v, variant in variants.items()]:
                    if name in others:
                        values.fail(f"is an axis, and set by {label} as well")
            flags.check_name(flag, values, known, reserved)
            axes[name] = [flags.value_of(value, known[flag]) for value in values.sequence()]
            if not axes[name] or len(set(axes[name])) < len(axes[name]):
                values.fail("expected different values, one or more")
        return axes


def _merged(full: dict, quick: dict) -> dict:
    """Quick datasets by name over those above; the flags of `simulate` are merged as well."""
    merged = dict(full)
    for name, (entry, parts) in quick.items():
        if entry.is_null():
            merged.pop(name, None)
            continue
        _, above = merged.get(name, (entry, {}))
        together = above | parts
        if "simulate" in above and "simulate" in parts:
            together["simulate"] = above["simulate"].merged(parts["simulate"])
        merged[name] = (entry, together)
    return merged


def _seeds(entry: Entry) -> list[int]:
    """From a list, one number or a range such as 1-20."""
    if entry.is_sequence():
        seeds = [flags.value_of(value, "uint32") for value in entry.sequence()]
    else:
        first, _, last = entry.text().partition("-")
        if not first.isdecimal() or not (last or first).isdecimal():
            entry.fail(f"expected seeds such as 1-20 or [1, 2, 3], found {entry.found()}")
        seeds = list(range(int(first), int(last or first) + 1))
    if not seeds or len(set(seeds)) < len(seeds):
        entry.fail(f"expected different seeds, one or more, found {entry.found()}")
    return seeds


def _metrics(entry: Entry) -> list[str]:
    names = []
    for value in entry.sequence():
        name = value.text()
        if name not in METRICS:
            value.fail(f"unknown metric '{name}'{did_you_mean(name, METRICS)}")
        names.append(name)
    if not names:
        entry.fail("expected one metric or more, found none")
    return names


def _compare(entry: Entry, study: Study,
             must_exist: bool) -> list[tuple[dict[str, Any], dict[str, Any]]]:
    """Pairs of selectors; without `must_exist`, those that select nothing are left out."""
    pairs = []
    for pair in entry.sequence():
        sides = [_selector(side, study) for side in pair.sequence()]
        if len(sides) != 2:
            pair.fail(f"expected two selectors, found {len(sides)}")
        missing = [side for side, selector in zip(pair.sequence(), sides)
                   if not study.select(selector)]
        if missing and must_exist:
            missing[0].fail("selects no configuration of the study")
        if not missing:
            pairs.append((sides[0], sides[1]))
    return pairs


def _selector(entry: Entry, study: Study) -> dict[str, Any]:
    known = list(study.configurations[0].coordinates())
    selector = {}
    for name, value in entry.mapping(known).items():
        as_written = value.scalar()
        # As the axis has it: 1 for 1.0, and the text of a flag whose value looks like a number.
        selector[name] = next(
            (v for v in {c.coordinates()[name] for c in study.configurations}
             if v == as_written or flags.as_text(v) == value.text()), as_written)
    return selector


def _run(config: Configuration, seed: int, source: Dataset,
         common: dict[str, flags.Value], variant: Variant) -> Run:
    slam = common | variant.flags | {
        name: value for name, value in config.axes.items() if not name.startswith(SIMULATE)}
    argv = [*([f"--flagfile={variant.flagfile}"] if variant.flagfile else []),
            *flags.as_arguments(slam), f"--seed={seed}"]
    if isinstance(source, SimulatedDataset):
        source = dataclasses.replace(source, flags=source.flags | {
            name.removeprefix(SIMULATE): value for name, value in config.axes.items()
            if name.startswith(SIMULATE)})
    log = source.content_id(seed)
    recorded = isinstance(source, RecordedDataset)
    return Run(
        id=ids.content_id(log, flags.as_arguments(slam),
                          ids.file_hash(variant.flagfile) if variant.flagfile else None, seed),
        configuration=config, seed=seed,
        log_id=None if recorded else log,
        log_tool=source.tool,
        log_argv=None if recorded else source.argv(seed),
        log_file=source.file if recorded else None,
        relations=source.relations if recorded else None,
        argv=argv)
