#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
import csv
import io
import unittest

import report_fixture
import metrics
from report import statistics, tables
from report.table import Shown, Table, mean_or_median, text


def records(table):
    return list(csv.DictReader(io.StringIO(table.csv())))


class TableTest(unittest.TestCase):
    TABLE = Table("t", "Caption", ["name", "value"], [
        ["a|b", 0.123456789], ["c", None], ["d", Shown("1 (0 to 2)", 1.0)]])

    def test_csv_has_every_digit(self):
        self.assertEqual(self.TABLE.csv(), "name,value\na|b,0.123456789\nc,\nd,1 (0 to 2)\n")

    def test_markdown_has_four_digits_and_escapes_bars(self):
        self.assertEqual(self.TABLE.markdown(), (
            "Caption\n\n| name | value |\n| --- | --- |\n| a\\|b | 0.1235 |\n| c | – |\n"
            "| d | 1 (0 to 2) |\n"))


class MeanOrMedianTest(unittest.TestCase):
    def shown(self, *values):
        return mean_or_median(statistics.summarize(list(values), lowest=0.0)).text

    def test_five_runs_show_the_mean_with_its_interval(self):
        self.assertEqual(self.shown(1.0, 1.0, 1.0, 1.0, 1.0), "1 (1 to 1)")
        self.assertEqual(self.shown(0.0, 0.0, 0.0, 0.0, 500.0), "100 (0 to 378)")

    def test_fewer_runs_show_the_median_and_the_range(self):
        self.assertEqual(self.shown(160.0, 100.0, 100.0), "100 [100, 160]")
        self.assertEqual(self.shown(1.5, None), "1.5")

    def test_no_run_shows_a_dash(self):
        self.assertEqual(self.shown(None, None), "–")


class MetricsTest(unittest.TestCase):
    def test_shares_are_metrics_and_have_no_unit(self):
        for name in metrics.SHARES:
            self.assertEqual(metrics.METRICS[name].unit, "", name)


class TablesTest(report_fixture.ResultsTestCase):
    def tables(self):
        return tables.tables(self.measured())

    def record_of(self, variant, particles, metric):
        return next(r for r in records(self.tables()["configurations"]) if r["variant"] == variant
                    and r["particles"] == str(particles) and r["metric"] == metric)

    def test_configurations_are_summaries_of_the_scores(self):
        found = self.record_of("improved", 5, "map_blur_m")
        expected = statistics.summarize([(0.16 + 0.01 * seed) / 2 for seed in range(1, 7)])
        for column, value in (("mean", expected.mean), ("standard deviation", expected.std),
                              ("median", expected.median), ("interval from", expected.low),
                              ("to", expected.high)):
            self.assertAlmostEqual(float(found[column]), value, msg=column)
        self.assertEqual((found["n with value"], found["n"], found["unit"]), ("6", "6", "m"))

    def test_metrics_that_no_run_has_are_left_out(self):
        self.assertNotIn("ate_rmse_m", self.tables()["configurations"].csv())

    def test_datasets_stand_side_by_side_with_median_and_worst(self):
        self.results.study_file.write_text(report_fixture.STUDY.replace(
            "datasets:", "datasets:\n  second: {world: paper_building.yaml, simulate: {scan_rate: 5}}")
            .replace("columns: particles}", "columns: particles, dataset: building}"))
        self.results.study = self.results.load()
        for run in self.results.study.runs:
            self.results.write(run)
        self.results.fail(next(r for r in self.results.study.runs
                               if r.configuration.dataset == "second"))
        table = self.tables()["by_dataset"]
        self.assertEqual(table.header, ["variant", "particles", "second: boundary blur (m)",
                                        "building: boundary blur (m)"])
        plain = [text(value) for value in table.rows[0]]
        self.assertEqual(plain, ["GMapping", "30", "0.1400 (0.1600)", "0.1350 (0.1600)"])
        for run in self.results.study.runs:
            self.results.write_scores(run, {"map_blur_m": 0.1, "map_broken": float(run.seed == 2)})
        self.assertEqual(text(self.tables()["by_dataset"].rows[0][3]),
                         "0.1000 (0.1000), 1 of 6 broken")

    def test_one_dataset_has_no_table_of_datasets_side_by_side(self):
        self.assertNotIn("by_dataset", self.tables())

    def test_failed_runs_are_counted_and_shown(self):
        self.results.fail(self.results.run("improved", 5, 2))
        found = self.record_of("improved", 5, "map_blur_m")
        self.assertEqual((found["n with value"], found["n"]), ("5", "6"))
        overview = records(self.tables()["overview"])
        self.assertEqual([r["successful runs"] for r in overview],
                         ["6 of 6", "6 of 6", "6 of 6", "5 of 6"])
        failed = [r for r in records(self.tables()["runs"]) if r["exit status"] == "1"]
        self.assertEqual([(r["seed"], r["error"], r["map_blur_m"]) for r in failed],
                         [("2", "no scan in the log", "")])

    def test_missing_runs_are_shown_and_not_counted_as_failed(self):
        self.results.remove(self.results.run("improved", 5, 2))
        self.assertEqual(self.record_of("improved", 5, "map_blur_m")["n"], "5")
        missing = [r for r in records(self.tables()["runs"]) if r["exit status"] == "missing"]
        self.assertEqual([(r["variant"], r["particles"], r["seed"]) for r in missing],
                         [("improved", "5", "2")])

    def test_every_run_has_its_command_log_and_version(self):
        rows = records(self.tables()["runs"])
        self.assertEqual(len(rows), 24)
        for row, run in zip(rows, self.results.study.runs):
            self.assertEqual(row["command"], f"build/bin/gmapping_spa {' '.join(run.argv)} "
                                             f"--output_dir=$W/runs/{run.id}")
            self.assertEqual(row["command that made the log"],
                             f"build/bin/simulate --seed={run.seed}")
            self.assertEqual(row["SHA-256 of the log"], f"{run.seed:064x}")
            self.assertEqual(row["version"], "0.1.0, build 00")

    def test_comparisons_are_of_like_with_like_and_by_direction(self):
        rows = records(self.tables()["comparisons"])
        self.assertEqual([(r["where"], r["A"], r["B"], r["metric"]) for r in rows[:4]], [
            ("building", "improved, particles 5", "GMapping, particles 30", "boundary blur (m)"),
            ("building", "improved, particles 5", "GMapping, particles 30",
             "recall of occupied cells"),
            ("building, particles 30", "improved", "GMapping", "boundary blur (m)"),
            ("building, particles 30", "improved", "GMapping", "recall of occupied cells")])
        # closures_accepted has no better direction, so there are 3 pairs x 2 metrics.
        self.assertEqual(len(rows), 6)
        for row in rows:
            self.assertEqual(row["better / worse / equal"], "6 / 0 / 0")
            # 2 / 2^6 for each of six tests that are all as clear.
            self.assertEqual((row["p"], row["p (Holm)"]), ("0.0312", "0.1875"))

    def test_a_failed_run_loses_its_pair(self):
        self.results.fail(self.results.run("improved", 5, 2))
        row = records(self.tables()["comparisons"])[0]
        self.assertEqual((row["better / worse / equal"], row["pairs"]), ("5 / 1 / 0", "5 of 6"))

    def test_captions_say_what_is_shown(self):
        for seeds, caption in (("1-6", "mean over the successful runs (95 % interval of the mean)"),
                               ("1-4", "median over the successful runs [min, max]"),
                               ("1", "single runs, of one seed")):
            self.results.study_file.write_text(
                report_fixture.STUDY.replace("seeds: 1-6", f"seeds: {seeds}"))
            self.results.study = self.results.load()
            for name in ("overview", "cost"):
                self.assertIn(caption, self.tables()[name].caption)

    def test_wall_time_is_shown_of_single_runs_only(self):
        run = self.results.run("improved", 5, 2)
        self.results.write_scores(run, {"cpu_s": 2.0, "wall_s": 99.0})
        self.assertIn("wall_s", self.tables()["run_costs"].header)
        for name in ("cost", "cost_comparisons", "overview"):
            self.assertNotIn("wall time", self.tables()[name].markdown())

    def test_costs_stand_in_tables_of_their_own(self):
        before = {name: table.csv() for name, table in self.tables().items()}
        run = self.results.run("improved", 5, 2)
        self.results.write_scores(run, {
            "map_blur_m": report_fixture.blur_of(run),
            "map_recall": 1 - report_fixture.blur_of(run),
            "closures_accepted": 3, "cpu_s": 99.0})
        after = {name: table.csv() for name, table in self.tables().items()}
        self.assertEqual({name for name in before if before[name] != after[name]},
                         {"cost", "cost_comparisons", "run_costs"})


if __name__ == "__main__":
    unittest.main()
