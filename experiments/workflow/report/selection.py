"""Cells by their coordinates (log, variant, axes), and the pairs that a comparison asks for."""
from flags import as_text
from study import StudyError


def key(cell):
    return tuple(cell.coordinates().items())


def label(coordinates):
    """`improved, particles 5` of {variant: improved, particles: 5}."""
    return ", ".join(as_text(value) if name in ("log", "variant") else f"{name} {as_text(value)}"
                     for name, value in coordinates.items() if value != "")


def label_within_log(cell):
    return label({k: v for k, v in cell.coordinates().items() if k != "log"}) or "all"


def labels_of_pair(a, b):
    """What both share, and what sets each apart."""
    own_a, own_b = a.coordinates(), b.coordinates()
    shared = {name for name in own_a if own_a[name] == own_b[name]}
    return (label({k: v for k, v in own_a.items() if k in shared}),
            *(label({k: v for k, v in own.items() if k not in shared}) for own in (own_a, own_b)))


def pairs(study, a, b):
    """Pairs of one cell that matches a and one that matches b, alike in all that neither names:
    {variant: X} against {variant: Y} is one pair for each log and each value of the axes."""
    named = set(a) | set(b)

    def rest(cell):
        return tuple(item for item in key(cell) if item[0] not in named)

    found = []
    for cell in study.select(a):
        partners = [c for c in study.select(b) if rest(c) == rest(cell)]
        if len(partners) > 1:
            raise StudyError(f"{study.path}: comparison with {b}: expected one cell to compare "
                             f"{cell.label()} with, found {len(partners)}")
        found += [(cell, partner) for partner in partners]
    if not found:
        raise StudyError(f"{study.path}: no two cells to compare by {a} and {b}")
    return found
