#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""The page in a real browser: no complaint in its console, no request, and tables that sort."""
import json
import pathlib
import sys
import tempfile
import unittest

import report_fixture
import report_verdicts_test

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[3] / "experiments" / "view"))
import browser


@unittest.skipIf(browser.MISSING, f"no {' and no '.join(browser.MISSING)}")
class PageTest(report_fixture.SharedResultsTestCase):
    @classmethod
    def spoil(cls):
        (cls.results.folder / "claims.yaml").write_text(report_verdicts_test.CLAIMS)
        cls.results.fail(cls.results.run("improved", 5, 2))

    def setUp(self):
        profile = tempfile.TemporaryDirectory(ignore_cleanup_errors=True)
        self.addCleanup(profile.cleanup)
        self.browser = browser.Browser(profile.name)
        self.addCleanup(self.browser.close)
        self.url = (self.results.folder / "report" / "index.html").as_uri()
        self.browser.call("/url", {"url": self.url})

    def column(self, table, column):
        return self.browser.run(
            f"return [...document.querySelectorAll('#{table} tbody tr')]"
            f".map(row => row.children[{column}].textContent)")

    def test_console_is_silent_and_no_request_leaves_the_page(self):
        self.browser.click("details summary")
        self.assertEqual(self.browser.log("browser"), [])
        requested = self.requested()
        self.assertIn(self.url, requested)
        self.assertEqual([u for u in requested if not u.startswith("data:") and u != self.url], [])

    def requested(self):
        """What the page asked for; the browser's own first tab asks too."""
        events = [json.loads(entry["message"])["message"]
                  for entry in self.browser.log("performance")]
        return [event["params"]["request"]["url"] for event in events
                if event["method"] == "Network.requestWillBeSent"
                and event["params"]["documentURL"] == self.url]

    def test_complaints_and_requests_of_a_broken_page_would_be_seen(self):
        self.browser.run("document.body.append(Object.assign(new Image(), "
                         "{src: 'http://127.0.0.1:9/picture.png'}))")
        self.browser.run("setTimeout(() => { throw new Error('broken'); }, 0)")
        self.browser.run("return 0")
        self.assertIn("broken", json.dumps(self.browser.log("browser")))
        self.assertIn("http://127.0.0.1:9/picture.png", self.requested())

    def test_pictures_are_drawn(self):
        widths = self.browser.run(
            "return [...document.images].map(i => i.complete ? i.naturalWidth : 0)")
        self.assertEqual(len(widths), 9)
        self.assertTrue(all(widths))

    def test_tables_sort_by_number_both_ways(self):
        table = "few_particles_overview"
        head = f"#{table} th:nth-child(3) button"
        self.assertEqual(self.column(table, 2), ["30", "5", "30", "5"])
        self.browser.click(head)
        self.assertEqual(self.column(table, 2), ["5", "5", "30", "30"])
        self.browser.click(head)
        self.assertEqual(self.column(table, 2), ["30", "30", "5", "5"])

    def test_values_that_are_missing_stay_last(self):
        self.browser.run("document.querySelectorAll('details').forEach(d => d.open = true)")
        table = "few_particles_runs"
        heads = self.browser.run(
            f"return [...document.querySelectorAll('#{table} th')].map(h => h.textContent)")
        column = heads.index("map_blur_m")
        for descending in (False, True):
            self.browser.click(f"#{table} th:nth-child({column + 1}) button")
            *numbers, last = self.column(table, column)
            self.assertEqual(last, "–")
            numbers = [float(number) for number in numbers]
            self.assertEqual(numbers, sorted(numbers, reverse=descending))
            self.assertEqual(len(numbers), 23)

    def test_page_is_not_wider_than_the_window(self):
        self.browser.run("document.querySelectorAll('details').forEach(d => d.open = true)")
        self.assertLessEqual(*self.browser.run(
            "return [document.documentElement.scrollWidth, window.innerWidth]"))


if __name__ == "__main__":
    unittest.main()
