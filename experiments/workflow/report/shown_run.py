# SPDX-License-Identifier: BSD-3-Clause
"""Which run of a configuration its pictures show: the same rule for all, not the nicest run."""
import math

from metrics import METRICS

RULE = ("Every picture shows its configuration's median run by {metric}: the runs are sorted from best "
        "to worst (failed ones and others without a value last, equals by seed), and the middle one is "
        "shown, of two middle ones the better.")
WORST = " Where a column says worst, the last one is shown."


def rule(measured, dataset, with_worst):
    metric = measured.main_metric(dataset)
    text = RULE.format(metric=METRICS[metric].label if metric else "seed")
    return text + WORST if with_worst else text


def seed_of(measured, config, which):
    """Of the 'median' or the 'worst' run; None where no run of the configuration is there."""
    metric = measured.main_metric(config.dataset)
    sign = -1 if metric and METRICS[metric].better == "higher" else 1
    values = {seed: measured.values(config, metric)[seed] if metric else 0
              for seed in measured.study.seeds if measured.result(config, seed)}
    order = sorted(values, key=lambda s: (math.inf if values[s] is None else sign * values[s], s))
    if not order:
        return None
    return order[-1] if which == "worst" else order[(len(order) - 1) // 2]
