# SPDX-License-Identifier: BSD-3-Clause
"""The tables of a study. What depends on the machine's load stands in tables of its own (`cost`),
so that all others are the same, byte for byte, when the study is run again."""
from metrics import METRICS, TIMES, highest

from . import selection, statistics
from .table import Shown, Table, mean_or_median, p_value


def heading(name):
    unit = METRICS[name].unit
    return f"{METRICS[name].label} ({unit})" if unit else METRICS[name].label


def tables(measured):
    """All of a study, by what they hold."""
    makers = [overview, configurations, comparisons, runs, cost, cost_comparisons, run_costs]
    if len(measured.datasets()) > 1:
        makers.append(by_dataset)
    return {make.__name__: make(measured) for make in makers}


def overview(measured):
    """The metrics that the study asks for: a row a configuration."""
    names = [m for m in measured.shown_metrics() if m not in TIMES]
    rows = []
    for config in measured.study.configurations:
        summaries = [_summary(measured, config, name) for name in names]
        rows.append([*_identity(config), _successful(measured, config), *map(mean_or_median, summaries)])
    return Table(
        f"{measured.study.name}_overview",
        f"{measured.study.title}: {_statistic(measured)}",
        [*_identity_header(measured), "successful runs",
         *(heading(m) for m in names)], rows)


def by_dataset(measured):
    """The main metric alone, and how many maps broke, a column a dataset that has one, so that a
    glance shows who is good where."""
    main = {dataset: _main_metric(measured, dataset) for dataset in measured.datasets()}
    datasets = [name for name in main if main[name]]
    rows = {}
    for config in measured.study.configurations:
        within = tuple((k, v) for k, v in config.coordinates().items() if k != "dataset")
        rows.setdefault(within, {})[config.dataset] = config
    heads = [f"{dataset}: {heading(main[dataset])}" for dataset in datasets]
    return Table(
        f"{measured.study.name}_by_dataset",
        f"{measured.study.title}: " + (
            _statistic(measured) if len(measured.study.seeds) == 1 else
            "median over the successful runs, and the worst of them, and how many of their maps are "
            "broken (IoU below 0.5), if any"),
        [*(name for name, _ in next(iter(rows))), *heads],
        [[*(value for _, value in within),
          *(_median_and_worst(measured, by_dataset[dataset], main[dataset]) for dataset in datasets)]
         for within, by_dataset in rows.items()])


def _main_metric(measured, dataset):
    """The first metric that the dataset has, costs apart, which have tables of their own."""
    return next((m for m in measured.study.metrics
                 if m not in TIMES and measured.exists(dataset, m)), None)


def _median_and_worst(measured, config, name):
    values = [v for v in measured.values(config, name).values() if v is not None]
    if not values:
        return None
    worst = max(values) if METRICS[name].better == "lower" else min(values)
    median = statistics.summarize(values).median
    broken = [v for v in measured.values(config, "map_broken").values() if v is not None]
    return Shown(f"{median:.4f}" + (f" ({worst:.4f})" if len(values) > 1 else "")
                 + (f", {sum(broken):.0f} of {len(broken)} broken" if any(broken) else ""), median)


def configurations(measured):
    """Every metric that any dataset has: a row a configuration and metric."""
    rows = []
    for config in measured.study.configurations:
        for name in measured.all_metrics():
            if measured.exists(config.dataset, name):
                s = _summary(measured, config, name)
                rows.append([*_identity(config), name, METRICS[name].unit, s.n_ok, s.n_all,
                             s.mean, s.std, s.median, s.min, s.max, s.low, s.high])
    return Table(
        f"{measured.study.name}_configurations",
        f"{measured.study.title}: all metrics. Runs with a value, all runs, and over those with a "
        "value: mean, standard deviation, median, least, greatest, 95 % interval of the mean, of "
        f"{statistics.FEW} values or more",
        [*_identity_header(measured), "metric", "unit", "n with value", "n", "mean",
         "standard deviation", "median", "min", "max", "interval from", "to"], rows)


def comparisons(measured):
    """The study's pairs of configurations, by seed."""
    names = [m for m in measured.shown_metrics() if m not in TIMES]
    return _comparisons(measured, names, "comparisons")


def cost_comparisons(measured):
    """The same pairs by what they cost."""
    return _comparisons(measured, measured.compared_costs(), "cost_comparisons")


def _comparisons(measured, names, name):
    found = [(a, b, metric, statistics.compare(
                  measured.values(a, metric), measured.values(b, metric),
                  METRICS[metric].better == "lower", highest(metric)))
             for selectors in measured.study.compare
             for a, b in selection.pairs(measured.study, *selectors) for metric in names
             if METRICS[metric].better != "none" and measured.exists(a.dataset, metric)]
    corrected = statistics.holm([comparison.p for *_, comparison in found])
    rows = [[*selection.labels_of_pair(a, b), heading(metric),
             mean_or_median(c.difference), f"{c.difference.n_ok} of {c.n_pairs}",
             f"{c.better} / {c.worse} / {c.equal}", p_value(c.p), p_value(p)]
            for (a, b, metric, c), p in zip(found, corrected)]
    return Table(
        f"{measured.study.name}_{name}",
        f"{measured.study.title}: A with B, paired by seed. Difference A - B over the pairs in which "
        f"both have a value, {_statistic(measured, over='')}. Over all pairs, with failed runs as the "
        "worst: seeds on which A is better, worse, equal, and p of Wilcoxon's signed-rank test, as it is "
        f"and with Holm's correction for the {len(rows)} tests of this table",
        ["where", "A", "B", "metric", "A - B", "pairs", "better / worse / equal", "p", "p (Holm)"],
        rows)


def runs(measured):
    """Every run with its metrics and all that is needed to do it again."""
    names = measured.all_metrics()
    rows = []
    for run in measured.study.runs:
        result = measured.result(run.configuration, run.seed)
        start = [*_identity(run.configuration), run.seed, run.id]
        if result is None:
            rows.append([*start, "missing", *[None] * (len(names) + 5)])
            continue
        outcome = result.outcome
        rows.append([*start, outcome["exit_status"], outcome["error"],
                     *(measured.values(run.configuration, name)[run.seed] for name in names),
                     outcome["version"], outcome["log_sha256"], outcome["log_command"],
                     outcome["command"]])
    return Table(
        f"{measured.study.name}_runs", f"{measured.study.title}: every run",
        [*_identity_header(measured), "seed", "run", "exit status", "error", *names, "version",
         "SHA-256 of the log", "command that made the log", "command"], rows)


def cost(measured):
    names = measured.compared_costs()
    rows = [[*_identity(config), *(mean_or_median(_summary(measured, config, name)) for name in names)]
            for config in measured.study.configurations]
    return Table(
        f"{measured.study.name}_cost",
        f"{measured.study.title}: cost of a run, {_statistic(measured)}",
        [*_identity_header(measured), *(heading(m) for m in names)], rows)


def run_costs(measured):
    names = measured.cost_metrics()
    rows = [[*_identity(r.run.configuration), r.run.seed, r.run.id, r.outcome.get("processor"),
             *(measured.values(r.run.configuration, name)[r.run.seed] for name in names)]
            for r in measured.results]
    return Table(f"{measured.study.name}_run_costs", f"{measured.study.title}: cost of every run",
                 [*_identity_header(measured), "seed", "run", "processor", *names], rows)


def _identity_header(measured):
    return list(measured.study.configurations[0].coordinates())


def _identity(config):
    return list(config.coordinates().values())


def _summary(measured, config, name):
    return statistics.summarize(list(measured.values(config, name).values()), 0.0, highest(name))


def _statistic(measured, over=" over the successful runs"):
    """What mean_or_median shows of this study, for captions."""
    if len(measured.study.seeds) == 1:
        return "single runs, of one seed"
    if len(measured.study.seeds) < statistics.FEW:
        return f"median{over} [min, max]"
    return (f"mean{over} (95 % interval of the mean); of fewer than {statistics.FEW} values "
            "median [min, max]")


def _successful(measured, config):
    results = [measured.result(config, seed) for seed in measured.study.seeds]
    good = sum(r is not None and not r.failed() for r in results)
    return Shown(f"{good} of {len(results)}", good)
