# SPDX-License-Identifier: BSD-3-Clause
"""What others report on the same datasets, beside our runs: published.yaml in the studies' folder.

    - system: NAME
      source: where the numbers come from
      DATASET: {translation_m: [mean, std], rotation_deg: [mean, std]}    # std and rotation: if known
"""
from yaml_entry import read_yaml

from . import statistics
from .selection import label
from .table import Shown, Table

FILE = "published.yaml"
KEYS = ("translation_m", "rotation_deg")
OURS = (("relation_error_m", "relation_std_m"), ("relation_rotation_deg", None))


def tables_beside(measured):
    """A row a system and configuration, a column a dataset with relations; nothing without such a file
    or dataset."""
    published = read_beside(measured.study)
    datasets = [dataset for dataset in measured.datasets() if measured.exists(dataset, OURS[0][0])]
    if not published or not datasets:
        return {}
    rows = [[system, source, *(by_dataset.get(dataset) for dataset in datasets)]
            for system, source, by_dataset in published]
    configs = {}
    for config in measured.study.configurations:
        within = {k: v for k, v in config.coordinates().items() if k != "dataset"}
        configs.setdefault(label(within), {})[config.dataset] = config
    rows += [[name, "this study", *(_ours(measured, by_dataset.get(dataset)) for dataset in datasets)]
             for name, by_dataset in configs.items()]
    return {"published": Table(
        f"{measured.study.name}_published",
        f"{measured.study.title}: error of the relations, mean ± standard deviation over the "
        "relations in m / mean rotation in degrees. Of this study: means of these over "
        f"{len(measured.study.seeds)} seeds",
        ["system", "source", *datasets], rows)}


def read_beside(study):
    """(system, source, what it reports by dataset) from the folder of the study."""
    file = study.path.parent / FILE
    return [_read_system(entry) for entry in read_yaml(file).sequence()] if file.exists() else []


def _read_system(entry):
    by_dataset = entry.mapping()
    for key in ("system", "source"):
        if key not in by_dataset:
            entry.fail(f"'{key}' is missing")
    system, source = (by_dataset.pop(key).text() for key in ("system", "source"))
    return system, source, {dataset: _read(below) for dataset, below in by_dataset.items()}


def _read(entry):
    parts = entry.mapping(KEYS)
    if "translation_m" not in parts:
        entry.fail("'translation_m' is missing")
    numbers = {}
    for key, part in parts.items():
        values = [value.scalar() for value in part.sequence()]
        if len(values) not in (1, 2) or not all(isinstance(v, (int, float)) for v in values):
            part.fail("expected [mean] or [mean, standard deviation]")
        numbers[key] = values
    mean, *std = numbers["translation_m"]
    return _shown(mean, *(std or [None]), numbers.get("rotation_deg", [None])[0])


def _ours(measured, config):
    if config is None:
        return None
    (mean, std), (rotation, _) = (
        [None if name is None else
         statistics.summarize(list(measured.values(config, name).values())).mean for name in names]
        for names in OURS)
    return None if mean is None else _shown(mean, std, rotation)


def _shown(mean_m, std_m, rotation_deg):
    text = f"{mean_m:.4f}" + (f" ± {std_m:.4f}" if std_m is not None else "")
    return Shown(text + (f" / {rotation_deg:.2f}" if rotation_deg is not None else ""), mean_m)
