"""A study with what its runs gave: the values of a metric by cell and seed."""
from metrics import METRICS, TIMES, WALL_TIME

from . import selection


class Measured:
    def __init__(self, study, results):
        self.study = study
        self.results = results
        self._by_run = {self._key(r.run.cell, r.run.seed): r for r in results}
        self.missing = [run for run in study.runs
                        if self._key(run.cell, run.seed) not in self._by_run]
        self.failed = [r for r in results if r.failed()]
        self._with_value = {
            (r.run.cell.log, name) for r in results for name in METRICS
            if self._value(r, name) is not None}

    @staticmethod
    def _key(cell, seed):
        return selection.key(cell), seed

    @staticmethod
    def _value(result, metric):
        return None if result.failed() else result.scores.get(metric)

    def result(self, cell, seed):
        """None where the run is missing."""
        return self._by_run.get(self._key(cell, seed))

    def values(self, cell, metric):
        """By seed, of the runs that ended; None: a run without a value."""
        results = {seed: self.result(cell, seed) for seed in self.study.seeds}
        return {seed: self._value(r, metric) for seed, r in results.items() if r is not None}

    def exists(self, log, metric):
        """Whether the metric can be had on this log: without truth, for example, many cannot."""
        return (log, metric) in self._with_value

    def logs(self):
        return list(dict.fromkeys(cell.log for cell in self.study.cells))

    def shown_metrics(self):
        """Those that the study names and some log has, the main one first."""
        return [name for name in self.study.metrics
                if any(self.exists(log, name) for log in self.logs())]

    def main_metric(self, log):
        """The first metric of the study that this log has."""
        return next((m for m in self.study.metrics if self.exists(log, m)), None)

    def all_metrics(self):
        """Without those that differ from one execution of the same run to the next."""
        return [name for name in METRICS if name not in TIMES
                and any(self.exists(log, name) for log in self.logs())]

    def cost_metrics(self):
        return [name for name in METRICS if name in TIMES
                and any(self.exists(log, name) for log in self.logs())]

    def compared_costs(self):
        """Without the wall time, which depends on what else the machine does."""
        return [name for name in self.cost_metrics() if name != WALL_TIME]
