"""Which run of a cell its pictures show: the same rule for every cell, not the nicest run."""
import math

from metrics import METRICS

RULE = ("Every picture shows its cell's median run by {metric}: the runs that ended are sorted "
        "from best to worst (those without a value last, equals by seed), and the middle one is taken, "
        "of two middle ones the better.")


def rule(measured, log):
    metric = measured.main_metric(log)
    return RULE.format(metric=METRICS[metric].label if metric else "seed")


def median_seed(measured, cell):
    """None where no run of the cell has ended."""
    metric = measured.main_metric(cell.log)
    sign = -1 if metric and METRICS[metric].better == "higher" else 1
    values = {seed: measured.values(cell, metric)[seed] if metric else 0
              for seed in measured.study.seeds if measured.result(cell, seed)}
    order = sorted(values, key=lambda s: (math.inf if values[s] is None else sign * values[s], s))
    return order[(len(order) - 1) // 2] if order else None
