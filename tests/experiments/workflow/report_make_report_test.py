#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
import re
import unittest

import report_fixture
import report_verdicts_test


def outputs(results, folder):
    root = results.folder / folder
    return {str(file.relative_to(root)): file.read_bytes()
            for file in root.glob("**/*") if file.is_file()}


class ReportOfGoodResultsTest(report_fixture.SharedResultsTestCase):
    def test_writes_one_page_every_figure_and_every_table_twice(self):
        figures = [f"figures/few_particles_two_by_two{kind}.png" for kind in ("", "_error_maps")]
        tables = [f"tables/few_particles_{table}.{ending}" for ending in ("csv", "md")
                  for table in ("overview", "configurations", "comparisons", "runs", "cost",
                                "cost_comparisons", "run_costs")]
        self.assertEqual(sorted(outputs(self.results, "report")),
                         sorted(["index.html", *figures, *tables]))

    def test_same_results_same_bytes(self):
        self.assertEqual(self.results.report(output="again").returncode, 0)
        self.assertEqual(outputs(self.results, "report"), outputs(self.results, "again"))

    def test_page_refers_to_nothing_outside_of_it(self):
        for reference in re.findall(r"(?:src|href)=\"([^\"]*)\"", self.page):
            self.assertRegex(reference, "^(data:|#)")
        self.assertNotRegex(self.page, r"@import|url\(|<script src|<link rel=\"stylesheet\"")

    def test_every_command_line_is_on_the_page(self):
        for run in self.results.study.runs:
            self.assertIn(f"--output_dir=$W/runs/{run.id}", self.page)

    def test_every_picture_says_what_it_shows(self):
        pictures = re.findall(r"<img [^>]*>", self.page)
        # A plot, and 2 x 2 maps with their error maps.
        self.assertEqual(len(pictures), 9)
        for picture in pictures:
            self.assertRegex(picture, r'alt="[^"]{10,}"')

    def test_no_warning_where_all_is_well(self):
        self.assertNotIn('class="warning"', self.page)


class MakeReportTest(report_fixture.ResultsTestCase):
    def test_warns_of_failed_and_missing_runs(self):
        self.results.fail(self.results.run("improved", 5, 1))
        self.results.remove(self.results.run("GMapping", 5, 1))
        self.results.remove(self.results.run("GMapping", 5, 2))
        page = self.results.page()
        self.assertIn("2 of 24 runs are missing", page)
        self.assertIn("1 of 24 runs failed", page)
        self.assertIn("<code>no scan in the log</code>", page)

    def test_warns_of_mixed_versions(self):
        self.results.write(self.results.run("improved", 5, 1), version="0.2.0, build 11")
        self.assertIn("Runs of different versions are mixed: 0.1.0, build 00, 0.2.0, build 11.",
                      self.results.page())

    def test_quick_report_says_so_and_has_the_quick_runs_only(self):
        page = self.results.page("--quick")
        self.assertIn("This is the quick version", page)
        self.assertIn("4 configurations x 2 seeds = 8", page)

    def test_report_without_any_result_says_that_all_is_missing(self):
        for run in self.results.study.runs:
            self.results.remove(run)
        self.assertIn("24 of 24 runs are missing", self.results.page())

    def test_median_run_that_failed_has_no_picture_and_says_so(self):
        for seed in range(1, 6):
            self.results.fail(self.results.run("improved", 5, seed))
        self.assertIn("improved, particles 5, seed 2: the median run failed", self.results.page())

    def test_claims_beside_the_study_are_judged(self):
        (self.results.folder / "claims.yaml").write_text(report_verdicts_test.CLAIMS)
        page = self.results.page()
        self.assertIn('<span class="verdict supported">supported</span>', page)
        self.assertIn("tables/claims.csv", outputs(self.results, "report"))

    def test_text_of_a_study_is_text_and_no_html(self):
        self.results.study_file.write_text(
            report_fixture.STUDY.replace("title: Few particles", "title: a <b> & c"))
        page = self.results.page()
        self.assertIn("a &lt;b&gt; &amp; c", page)
        self.assertNotIn("<b>", page)

    def test_a_bad_study_is_one_line_and_no_report(self):
        self.results.study_file.write_text(
            report_fixture.STUDY.replace("rows: variant", "rows: varient"))
        done = self.results.report()
        self.assertNotEqual(done.returncode, 0)
        self.assertRegex(done.stderr, r"^make_report.py: error: .*few_particles.yaml:17: rows: "
                                      r"'varient' is no axis of the study; "
                                      r"did you mean 'variant'\?\n$")
        self.assertFalse((self.results.folder / "report").exists())


if __name__ == "__main__":
    unittest.main()
