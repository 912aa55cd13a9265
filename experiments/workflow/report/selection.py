# SPDX-License-Identifier: BSD-3-Clause
"""Configurations by their coordinates (dataset, variant, axes), and the pairs of a comparison."""
from flags import as_text
from study import StudyError


def key(config):
    return tuple(config.coordinates().items())


def label(coordinates):
    """`improved, particles 5` of {variant: improved, particles: 5}."""
    return ", ".join(as_text(value) if name in ("dataset", "variant") else f"{name} {as_text(value)}"
                     for name, value in coordinates.items() if value != "")


def label_within_dataset(config):
    return label({k: v for k, v in config.coordinates().items() if k != "dataset"}) or "all"


def labels_of_pair(a, b):
    """What both share, and what sets each apart."""
    own_a, own_b = a.coordinates(), b.coordinates()
    shared = {name for name in own_a if own_a[name] == own_b[name]}
    return (label({k: v for k, v in own_a.items() if k in shared}),
            *(label({k: v for k, v in own.items() if k not in shared}) for own in (own_a, own_b)))


def pairs(study, a, b):
    """Pairs of one configuration that matches a and one that matches b, alike in all that neither names:
    {variant: X} against {variant: Y} is one pair for each dataset and each value of the axes."""
    named = set(a) | set(b)

    def rest(config):
        return tuple(item for item in key(config) if item[0] not in named)

    found = []
    for config in study.select(a):
        partners = [c for c in study.select(b) if rest(c) == rest(config)]
        if len(partners) > 1:
            raise StudyError(f"{study.path}: comparison with {b}: expected one configuration to "
                             f"compare {config.label()} with, found {len(partners)}")
        found += [(config, partner) for partner in partners]
    if not found:
        raise StudyError(f"{study.path}: no two configurations to compare by {a} and {b}")
    return found
