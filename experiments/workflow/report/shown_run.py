"""Which run of a cell its pictures show: the same rule for every cell, not the nicest run."""
import math

from metrics import METRICS

RULE = ("Every picture shows its cell's median run by {metric}: the runs that ended are sorted "
        "from best to worst (those without a value last, equals by seed), and the middle one is taken, "
        "of two middle ones the better.")
WORST = " Where a column says worst, the last one is taken."


def rule(measured, log, with_worst):
    metric = measured.main_metric(log)
    text = RULE.format(metric=METRICS[metric].label if metric else "seed")
    return text + WORST if with_worst else text


def seed_of(measured, cell, which):
    """Of the 'median' or the 'worst' run; None where no run of the cell has ended."""
    metric = measured.main_metric(cell.log)
    sign = -1 if metric and METRICS[metric].better == "higher" else 1
    values = {seed: measured.values(cell, metric)[seed] if metric else 0
              for seed in measured.study.seeds if measured.result(cell, seed)}
    order = sorted(values, key=lambda s: (math.inf if values[s] is None else sign * values[s], s))
    if not order:
        return None
    return order[-1] if which == "worst" else order[(len(order) - 1) // 2]
