#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""The page's memory does not grow, however long it looks at one run after the other: a minute, or
GMAPPING_SPA_VIEW_MINUTES. Prints what it measured."""
import os
import pathlib
import statistics
import time
import unittest

import view_fixture

MINUTES = float(os.environ.get("GMAPPING_SPA_VIEW_MINUTES", "1"))
DATA = pathlib.Path(os.environ.get("GMAPPING_SPA_DATA", view_fixture.ROOT.parent / "shared/data"))
INTEL = DATA / "carmen" / "intel.clf.gz"


@view_fixture.NEEDS_BROWSER
@unittest.skipUnless(INTEL.exists(), f"no {INTEL}")
class ViewMemoryTest(view_fixture.ViewTestCase):
    @classmethod
    def setUpClass(cls):
        cls.log = INTEL

    def heap_mb(self, browser):
        browser.call("/goog/cdp/execute", {"cmd": "HeapProfiler.collectGarbage", "params": {}})
        usage = browser.call("/goog/cdp/execute", {"cmd": "Runtime.getHeapUsage", "params": {}})
        return (usage["usedSize"] + usage.get("backingStorageSize", 0)) / 2 ** 20

    def test_memory_of_the_page_does_not_grow(self):
        program = self.start()
        browser = self.open_browser(program.url)
        measured, scans = [], 0
        end = time.monotonic() + 60 * MINUTES
        while time.monotonic() < end or len(measured) < 3:
            self.assertEqual(program.wait(300), 0)
            browser.wait_for("gmapping_spa_view.connection_state === 'lost'", 120)
            measured.append(self.heap_mb(browser))
            scans += browser.run("return gmapping_spa_view.runs[0].frame.figures[1]")
            program = self.start(port=program.port)
            browser.wait_for("gmapping_spa_view.runs[0]?.frame?.phase === 'running'", 120)
        third = -(-len(measured) // 3)
        first, last = statistics.median(measured[:third]), statistics.median(measured[-third:])
        print(f"{len(measured)} runs, {scans} scans: heap and buffers {first:.1f} MB in the first third, "
              f"{last:.1f} MB in the last, {max(measured):.1f} MB at most")
        self.assertLess(last, 1.2 * first + 2)


if __name__ == "__main__":
    unittest.main()
