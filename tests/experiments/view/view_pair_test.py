#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Finished runs in a real browser: one, and two side by side. With GMAPPING_SPA_SCREENSHOTS, a folder,
it leaves pictures there to look at."""
import os
import pathlib
import subprocess
import unittest

import view_fixture

SCREENSHOTS = os.environ.get("GMAPPING_SPA_SCREENSHOTS")
VIEW = "gmapping_spa_view"


@view_fixture.NEEDS_BROWSER
class ViewPairTest(view_fixture.ViewTestCase):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        for name, flags in (("optimized", []), ("plain", ["--backend=none"])):
            subprocess.run([view_fixture.BINARIES / "gmapping_spa", f"--log={cls.log}", *flags,
                            f"--output_dir={cls.shared / name}"], check=True, capture_output=True)

    def begin(self, *folders):
        self.program = self.show(*folders)
        self.browser = self.open_browser(self.program.url)
        self.browser.wait_for(f"{VIEW}.runs.length === {len(folders)} && {VIEW}.runs.every((r) => r.frame)")

    def test_finished_run_shows_its_results(self):
        self.begin(self.shared / "optimized")
        poses, nodes, candidates, accepted = self.browser.run(f"""
            const run = {VIEW}.runs[0];
            return [run.trajectory.length / 4, run.nodes.length / 4, run.candidates.length,
                    run.candidates.filter((c) => c.verdict === 'accepted').length];""")
        self.assertEqual(poses, 621)
        table = (self.shared / "optimized" / "loop_closures.csv").read_text().splitlines()
        self.assertEqual(candidates, len(table) - 1)
        self.assertEqual(accepted, sum(line.endswith(",accepted") for line in table))
        graph = (self.shared / "optimized" / "graph.g2o").read_text()
        self.assertEqual(nodes, graph.count("VERTEX_SE2"))
        # Stamps of nodes are those of their scans.
        stamps = self.browser.run(f"return {VIEW}.runs[0].nodes.filter((_, i) => i % 4 === 3)")
        told = {int(row[column]): float(row[column + 2]) for row in
                (line.split(",") for line in table[1:]) for column in (0, 1)}
        self.assertGreater(len(told), 5)
        for node, stamp in told.items():
            self.assertAlmostEqual(stamps[node], stamp, 2)
        self.assertTrue(self.browser.run("return document.getElementById('pause').hidden"))
        self.assertEqual(self.browser.log("browser"), [])

    def test_two_runs_share_the_camera_and_the_time(self):
        self.begin(self.shared / "optimized", self.shared / "plain")
        self.assertEqual(self.browser.run("return document.querySelectorAll('.pane canvas').length"), 2)
        self.browser.press("+++")
        self.browser.press("\ue012")  # left
        self.browser.press("[[[[[[[[[[")
        self.browser.wait_for("document.getElementById('time_note').textContent.includes('faded')")
        if SCREENSHOTS:
            self.browser.screenshot(pathlib.Path(SCREENSHOTS) / "pair.png")
        self.assertEqual(self.browser.run(f"return {VIEW}.run.name"), str(self.shared / "optimized"))
        self.browser.press("o")
        self.browser.wait_for(f"{VIEW}.run.name.endsWith('plain')")
        self.assertEqual(self.browser.log("browser"), [])
        self.program.process.terminate()
        self.assertEqual(self.program.wait(), 0)


if __name__ == "__main__":
    unittest.main()
