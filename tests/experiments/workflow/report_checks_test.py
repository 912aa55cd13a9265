#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
import unittest

import report_fixture
import report_verdicts_test
from report import checks
from study import StudyError


class ChecksTest(report_fixture.ResultsTestCase):
    def check(self, study=report_fixture.STUDY, claims=report_verdicts_test.CLAIMS):
        self.results.study_file.write_text(study)
        (self.results.folder / "claims.yaml").write_text(claims)
        checks.check([self.results.load()])

    def test_good_study_and_claims_pass(self):
        self.check()

    def test_study_without_claims_passes(self):
        checks.check([self.results.study])

    def test_comparison_with_more_than_one_partner_is_refused(self):
        with self.assertRaisesRegex(StudyError, "few_particles.yaml: .* found 2"):
            self.check(study=report_fixture.STUDY.replace(
                "[{variant: improved}, {variant: GMapping}]",
                "[{variant: improved, particles: 5}, {variant: GMapping}]"))

    def test_claim_with_a_mistake_is_refused(self):
        with self.assertRaisesRegex(StudyError, "claims.yaml:11: .*did you mean 'map_blur_m'"):
            self.check(claims=report_verdicts_test.CLAIMS.replace("map_blur_m", "map_blr_m"))


if __name__ == "__main__":
    unittest.main()
