#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
import unittest

import report_fixture
from report import verdicts
from study import StudyError

CLAIMS = """
title: Claims
source: Made up.
claims:
  - place: 3.1, paragraph 2
    statement: Improved is clearer.
    tests:
      ours:
        - study: few_particles
          compare: [{variant: improved, particles: 5}, {variant: GMapping, particles: 30}]
          metrics: [map_blur_m]
          expect: better
"""
SIDES = "[{variant: improved, particles: 5}, {variant: GMapping, particles: 30}]"


class VerdictsTest(report_fixture.ResultsTestCase):
    def judge(self, text=CLAIMS):
        file = self.results.folder / "claims.yaml"
        file.write_text(text)
        return verdicts.judge_beside([self.measured()])

    def verdict(self, text=CLAIMS):
        (_, verdict, _), = self.judge(text).claims
        return verdict

    def complaint(self, old, new):
        self.assertIn(old, CLAIMS)
        with self.assertRaises(StudyError) as caught:
            self.judge(CLAIMS.replace(old, new))
        self.assertNotIn("\n", str(caught.exception))
        return str(caught.exception).replace(f"{self.results.folder}/", "")

    def test_supported_where_a_is_better_beyond_chance(self):
        # Better on six of six seeds: p = 2 / 2^6 = 0.031.
        self.assertEqual(self.verdict(), "supported")

    def test_not_supported_where_a_is_worse_beyond_chance(self):
        turned = "[{variant: GMapping, particles: 30}, {variant: improved, particles: 5}]"
        self.assertEqual(self.verdict(CLAIMS.replace(SIDES, turned)), "not supported")

    def test_undecided_where_it_can_be_chance(self):
        self.results.write(self.results.run("improved", 5, 3), blur=5.0)
        self.assertEqual(self.verdict(), "undecided")

    def test_failed_runs_speak_against_a_claim(self):
        for seed in (1, 2):
            self.results.fail(self.results.run("improved", 5, seed))
        self.assertEqual(self.verdict(), "undecided")
        for seed in (3, 4, 5, 6):
            self.results.fail(self.results.run("improved", 5, seed))
        self.assertEqual(self.verdict(), "not supported")

    def test_allowance_is_a_share_of_b_or_in_the_metrics_unit(self):
        # A is 0.17 to 0.22, B 0.11 to 0.16, seed by seed: 0.06 more, that is 37 to 55 %.
        for seed in self.results.study.seeds:
            self.results.write(self.results.run("improved", 5, seed), blur=0.16 + 0.01 * seed)
        for expected, verdict in (("not worse by 60 %", "supported"),
                                  ("not worse by 30 %", "not supported"),
                                  ("not worse by 0.07", "supported"),
                                  ("not worse by 0.05", "not supported")):
            with self.subTest(expected):
                self.assertEqual(self.verdict(CLAIMS.replace("better", expected)), verdict)

    def test_allowance_goes_down_where_higher_is_better(self):
        for seed in self.results.study.seeds:
            self.results.write(self.results.run("improved", 5, seed), blur=0.16 + 0.01 * seed)
        text = CLAIMS.replace("map_blur_m", "map_recall")
        self.assertEqual(self.verdict(text), "not supported")
        self.assertEqual(self.verdict(text.replace("better", "not worse by 0.07")), "supported")

    def test_a_claim_is_worth_all_its_tests(self):
        two = CLAIMS + """\
        - study: few_particles
          compare: [{variant: GMapping, particles: 5}, {variant: GMapping, particles: 30}]
          metrics: [map_blur_m]
          expect: better
"""
        # Holm's correction makes 0.031 to 0.062 for both.
        self.assertEqual(self.verdict(two), "undecided")
        (_, _, lines), = self.judge(two).claims
        self.assertEqual(len(lines), 2)
        self.assertEqual(self.judge(two).verdicts.csv().splitlines()[1],
                         '1,"3.1, paragraph 2",Improved is clearer.,ours,undecided,0 / 0 / 2')
        self.assertIn("p 0.0625", lines[0])

    def test_a_claim_that_some_tests_support_and_others_contradict_is_mixed(self):
        for for_it, against, open_, verdict in (
                (2, 0, 0, "supported"), (0, 1, 1, "not supported"), (1, 1, 0, "mixed"),
                (1, 0, 1, "supported in part"), (0, 0, 2, "undecided")):
            tests = ["supported"] * for_it + ["not supported"] * against + ["undecided"] * open_
            with self.subTest(tests):
                self.assertEqual(verdicts.of_claim(tests), verdict)

    def test_each_algorithm_that_the_claim_may_be_of_has_its_verdict(self):
        turned = CLAIMS + CLAIMS[CLAIMS.index("      ours:"):].replace("ours", "theirs").replace(
            SIDES, "[{variant: GMapping, particles: 30}, {variant: improved, particles: 5}]")
        found = self.judge(turned).claims
        self.assertEqual([(claim.number, claim.algorithm) for claim, _, _ in found],
                         [(1, "ours"), (1, "theirs")])

    def test_a_former_key_is_refused_with_its_new_name(self):
        self.assertEqual(self.complaint("statement:", "says:"),
                         "claims.yaml:6: claims: 'says' is called 'statement' now")

    def test_costs_are_a_family_of_their_own(self):
        text = CLAIMS + """\
        - study: few_particles
          compare: [{variant: improved, particles: 5}, {variant: GMapping, particles: 30}]
          metrics: [cpu_s]
          expect: better
"""
        self.assertEqual(self.verdict(text), "supported")
        self.assertEqual([table.name for table in self.judge(text).tests],
                         ["claims", "claims_cost"])

    def test_claims_on_studies_that_are_not_reported_are_left_out(self):
        (self.results.folder / "other.yaml").write_text("")
        self.assertIsNone(self.judge(CLAIMS.replace("study: few_particles", "study: other")))

    def test_no_claims_without_a_file(self):
        self.assertIsNone(verdicts.judge_beside([self.measured()]))

    def test_mistakes_are_named_with_file_and_line(self):
        for old, new, complaint in (
                ("study: few_particles", "study: few_partcles",
                 "claims.yaml:9: study: no study 'few_partcles' in this folder; did you mean "
                 "'few_particles'?"),
                ("map_blur_m", "map_blurr_m",
                 "claims.yaml:11: metrics: unknown metric 'map_blurr_m'; did you mean 'map_blur_m'?"),
                ("map_blur_m", "updates",
                 "claims.yaml:11: metrics: of 'updates' neither more nor less is better"),
                ("expect: better", "expect: nice",
                 "claims.yaml:12: expect: expected 'better', 'not worse by 10 %' or 'not worse by "
                 "0.1' (in the metric's unit), found 'nice'"),
                ("source: Made up.\n", "", "claims.yaml:2: claims: 'source' is missing")):
            with self.subTest(new):
                self.assertEqual(self.complaint(old, new), complaint)
        self.assertEqual(self.complaint(CLAIMS[CLAIMS.index("      ours:"):], "      ours: []\n"),
                         "claims.yaml:8: ours: expected one test or more, found none")
        self.assertIn("claims.yaml:10: compare: ", self.complaint("particles: 5}", "particles: 7}"))


if __name__ == "__main__":
    unittest.main()
