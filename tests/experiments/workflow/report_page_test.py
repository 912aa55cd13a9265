#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""The page in a real browser: no complaint in its console, no request, and tables that sort."""
import json
import shutil
import subprocess
import tempfile
import unittest
import urllib.request

import report_fixture
import report_verdicts_test

MISSING = [name for name in ("chromium", "chromedriver") if shutil.which(name) is None]
ARGUMENTS = ["--headless", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run",
             "--disable-background-networking", "--disable-component-update", "--disable-sync",
             "--window-size=1280,1000"]


class Browser:
    """Chromium behind chromedriver, spoken to as the WebDriver standard says."""

    def __init__(self, profile):
        self.driver = subprocess.Popen(
            ["chromedriver", "--port=0"], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL,
            text=True)
        port = next(line.split("on port ")[1].strip(" .\n") for line in self.driver.stdout
                    if "successfully on port " in line)
        self.url = f"http://127.0.0.1:{port}/session"
        try:
            session = self.call("", {"capabilities": {"alwaysMatch": {
                "goog:chromeOptions": {
                    "binary": shutil.which("chromium"),
                    "args": [*ARGUMENTS, f"--user-data-dir={profile}"]},
                "goog:loggingPrefs": {"browser": "ALL", "performance": "ALL"}}}})
        except OSError:
            self.driver.kill()
            raise
        self.url += f"/{session['sessionId']}"

    def call(self, path, body=None, method="POST"):
        request = urllib.request.Request(
            self.url + path, method=method, headers={"Content-Type": "application/json"},
            data=None if body is None else json.dumps(body).encode())
        # Not through a proxy: the driver is on this machine.
        opener = urllib.request.build_opener(urllib.request.ProxyHandler({}))
        with opener.open(request) as answer:
            return json.load(answer)["value"]

    def run(self, script):
        return self.call("/execute/sync", {"script": script, "args": []})

    def click(self, selector):
        element = self.call("/element", {"using": "css selector", "value": selector})
        self.call(f"/element/{next(iter(element.values()))}/click", {})

    def log(self, kind):
        return self.call("/se/log", {"type": kind})

    def close(self):
        self.call("", method="DELETE")
        self.driver.kill()
        self.driver.wait()
        self.driver.stdout.close()


@unittest.skipIf(MISSING, f"no {' and no '.join(MISSING)}")
class PageTest(report_fixture.SharedResultsTestCase):
    @classmethod
    def spoil(cls):
        (cls.results.folder / "claims.yaml").write_text(report_verdicts_test.CLAIMS)
        cls.results.fail(cls.results.run("improved", 5, 2))

    def setUp(self):
        profile = tempfile.TemporaryDirectory(ignore_cleanup_errors=True)
        self.addCleanup(profile.cleanup)
        self.browser = Browser(profile.name)
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
