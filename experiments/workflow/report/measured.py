# SPDX-License-Identifier: BSD-3-Clause
"""A study with what its runs gave: the values of a metric by configuration and seed."""
from metrics import METRICS, TIMES, WALL_TIME

from . import selection


class Measured:
    def __init__(self, study, results):
        self.study = study
        self.results = results
        self._by_run = {self._key(r.run.configuration, r.run.seed): r for r in results}
        self.missing = [run for run in study.runs
                        if self._key(run.configuration, run.seed) not in self._by_run]
        self.failed = [r for r in results if r.failed()]
        self._with_value = {
            (r.run.configuration.dataset, name) for r in results for name in METRICS
            if self._value(r, name) is not None}

    @staticmethod
    def _key(config, seed):
        return selection.key(config), seed

    @staticmethod
    def _value(result, metric):
        return None if result.failed() else result.scores.get(metric)

    def result(self, config, seed):
        """None where the run is missing."""
        return self._by_run.get(self._key(config, seed))

    def values(self, config, metric):
        """By seed, of the runs that ended; None: a run without a value."""
        results = {seed: self.result(config, seed) for seed in self.study.seeds}
        return {seed: self._value(r, metric) for seed, r in results.items() if r is not None}

    def exists(self, dataset, metric):
        """Whether the metric can be had on this dataset: without truth, for example, many cannot."""
        return (dataset, metric) in self._with_value

    def datasets(self):
        return list(dict.fromkeys(config.dataset for config in self.study.configurations))

    def shown_metrics(self):
        """Those that the study names and some dataset has, the main one first."""
        return [name for name in self.study.metrics
                if any(self.exists(dataset, name) for dataset in self.datasets())]

    def main_metric(self, dataset):
        """The first metric of the study that this dataset has."""
        return next((m for m in self.study.metrics if self.exists(dataset, m)), None)

    def all_metrics(self):
        """Without those that differ from one execution of the same run to the next."""
        return [name for name in METRICS if name not in TIMES
                and any(self.exists(dataset, name) for dataset in self.datasets())]

    def cost_metrics(self):
        return [name for name in METRICS if name in TIMES
                and any(self.exists(dataset, name) for dataset in self.datasets())]

    def compared_costs(self):
        """Without the wall time, which depends on what else the machine does."""
        return [name for name in self.cost_metrics() if name != WALL_TIME]
