# SPDX-License-Identifier: BSD-3-Clause
"""The command: files as asked, the same bytes every time, complaints in one line."""
import subprocess
import unittest

import stress_test_case
from stress_test_case import STRESS

import carmen
import stresses


class StressLogTest(stress_test_case.StressTestCase):
    def run_tool(self, *words):
        return subprocess.run([STRESS / "stress_log.py", *words], capture_output=True, text=True)

    def make(self, name, *words):
        done = self.run_tool(f"--log={self.file}", f"--output={self.folder / name}", *words)
        self.assertEqual(done.returncode, 0, done.stderr)
        return self.folder / name

    def test_the_same_seed_makes_the_same_bytes(self):
        first = self.make("a.clf.gz", "--stress=noisy", "--seed=3").read_bytes()
        self.assertEqual(first, self.make("b.clf.gz", "--stress=noisy", "--seed=3").read_bytes())
        self.assertNotEqual(first, self.make("b.clf.gz", "--stress=noisy").read_bytes())
        self.assertNotEqual(first, self.make("b.clf.gz", "--stress=noisy", "--seed=3",
                                             "--size=2").read_bytes())

    def test_every_kind_makes_a_log_that_is_read_again(self):
        for kind in stresses.STRESSES:
            with self.subTest(kind):
                log = self.stressed(kind)
                carmen.write(log, self.folder / "out.clf")
                again = carmen.read(self.folder / "out.clf")
                self.assertEqual([r.line() for r in again.records],
                                 [r.line() for r in log.records])

    def test_relations_follow_and_only_the_first_scans_are_taken(self):
        (self.folder / "r").write_text("1000.0 1002.0 1 2 0 0 0 0.5\n1000.0 1020.0 1 2 0 0 0 1\n")
        log = carmen.read(self.make("a.clf", "--stress=reverse", "--first_scans=50",
                                    f"--relations={self.folder / 'r'}",
                                    f"--relations_output={self.folder / 'out'}"))
        self.assertEqual(len(log.scans()), 50)
        self.assertEqual(len(log.odometry()), 50)
        [line] = (self.folder / "out").read_text().splitlines()
        # From 999.95, the first ODOM, to 1004.9.
        self.assertTrue(line.startswith("1002.850000 1004.850000 "), line)
        self.assertTrue(line.endswith(" -0.500000"), line)

    def test_kinds_are_listed(self):
        self.assertEqual(self.run_tool("--list").stdout.split(), list(stresses.STRESSES))
        self.assertIn("20 single steps of the wheels", self.run_tool("--help").stdout)

    def test_what_is_wrong_is_told_in_one_line(self):
        out = f"--output={self.folder / 'x'}"
        for words, complaint in (
                ([f"--log={self.folder / 'no'}", "--stress=drop"], "No such file"),
                ([f"--log={self.file}", "--stress=dorp"], "invalid choice: 'dorp'"),
                ([f"--log={self.file}", "--stress=drop", "--size=0"], "a size above 0"),
                ([f"--log={self.file}", "--stress=drop", "--first_scans=1"], "2 or more"),
                ([f"--log={self.file}", "--stress=drop", "--relations=x"], "need each other")):
            done = self.run_tool(*words, out)
            self.assertNotEqual(done.returncode, 0)
            self.assertIn(complaint, done.stderr.splitlines()[-1])
            self.assertFalse((self.folder / "x").exists())


if __name__ == "__main__":
    unittest.main()
