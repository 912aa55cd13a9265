#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""What the view costs the SLAM on intel: CPU time, since wall time tells more of what else the machine
does. Runs without --view, with nobody who looks, and with a browser take turns; medians are printed."""
import os
import pathlib
import statistics
import subprocess
import unittest

import view_fixture
from view_memory_test import INTEL

ROUNDS = int(os.environ.get("GMAPPING_SPA_VIEW_ROUNDS", "3"))


def thread_s(pid):
    """CPU time of the thread that does the SLAM."""
    return int(pathlib.Path(f"/proc/{pid}/task/{pid}/schedstat").read_text().split()[0]) / 1e9


@view_fixture.NEEDS_BROWSER
@unittest.skipUnless(INTEL.exists(), f"no {INTEL}")
class ViewSlowDownTest(view_fixture.ViewTestCase):
    @classmethod
    def setUpClass(cls):
        cls.log = INTEL

    def end(self, process):
        """When it has printed its results, which is before it keeps the view: the CPU time of its
        thread and of all that it did."""
        process.stdout.readline()
        in_thread_s = thread_s(process.pid)
        process.terminate()
        process.stderr.close()
        process.stdout.close()
        _, status, usage = os.wait4(process.pid, 0)
        self.assertEqual(status, 0)
        process.returncode = 0
        return in_thread_s, usage.ru_utime + usage.ru_stime

    def run_viewed(self, *flags):
        program = view_fixture.Program(f"--log={self.log}", f"--output_dir={self.folder / 'out'}",
                                       "--view", "--view_keep", *flags)
        if "--view_wait" in flags:
            self.browser.call("/url", {"url": program.url})
        return self.end(program.process)

    def run_plain(self):
        before = os.times()
        subprocess.run([view_fixture.BINARIES / "gmapping_spa", f"--log={self.log}",
                        f"--output_dir={self.folder / 'out'}"], check=True, capture_output=True)
        after = os.times()
        used_s = (after.children_user + after.children_system - before.children_user
                  - before.children_system)
        return used_s, used_s

    def test_slam_is_slowed_down_by_less_than_five_percent(self):
        self.browser = self.open_browser("about:blank")
        kinds = {"without": self.run_plain, "unseen": self.run_viewed,
                 "seen": lambda: self.run_viewed("--view_wait")}
        times = {kind: [] for kind in kinds}
        for _ in range(ROUNDS):
            for kind, run in kinds.items():
                times[kind].append(run())
                print(kind, "CPU s of the thread and of the process:", times[kind][-1], flush=True)
        thread, process = ({kind: statistics.median(pair[k] for pair in pairs)
                            for kind, pairs in times.items()} for k in (0, 1))
        print("CPU s, medians of", ROUNDS, {
            kind: f"thread {thread[kind]:.2f}, process {process[kind]:.2f}" for kind in kinds})
        self.assertLess(thread["seen"], 1.05 * thread["unseen"])
        self.assertLess(process["unseen"], 1.05 * process["without"])


if __name__ == "__main__":
    unittest.main()
