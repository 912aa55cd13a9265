# SPDX-License-Identifier: BSD-3-Clause
"""The command: the same bytes every time, worlds that can be driven, complaints in one line."""
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[3]
SCRIPT = ROOT / "experiments" / "stress" / "random_world.py"
SIMULATE = pathlib.Path(os.environ["GMAPPING_SPA_BINARIES"]) / "simulate"
sys.path.insert(0, str(SCRIPT.parent))

from building_kinds import KINDS

FILES = ["simulate.flags", "world.path.yaml", "world.yaml"]
SMALL = {"office": 1, "corridors": 5, "hall": 6, "yard": 6}  # seeds by kind


class RandomWorldTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def run_tool(self, *words):
        return subprocess.run([SCRIPT, *words], capture_output=True, text=True)

    def make(self, name, *words):
        """The files by name."""
        done = self.run_tool(f"--output_dir={self.folder / name}", *words)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        return {file.name: file.read_bytes() for file in (self.folder / name).iterdir()}

    def test_the_same_seed_makes_the_same_bytes(self):
        first = self.make("a", "--seed=3", "--kind=office")
        self.assertEqual(sorted(first), FILES)
        self.assertEqual(first, self.make("b", "--seed=3", "--kind=office"))
        other = self.make("c", "--seed=4", "--kind=office")
        for name in FILES:
            self.assertNotEqual(first[name], other[name])

    def test_any_kind_is_the_default(self):
        self.assertEqual(self.make("a", "--seed=3"), self.make("b", "--seed=3", "--kind=any"))

    def test_a_robot_drives_every_kind_of_building(self):
        self.assertEqual(SMALL.keys(), KINDS.keys())
        for kind, seed in SMALL.items():
            made = self.make(kind, f"--seed={seed}", f"--kind={kind}", f"--simulate={SIMULATE}")
            self.assertLessEqual({"log.clf", "truth.tum", "truth.yaml"}, made.keys())
            self.assertGreater(made["truth.tum"].count(b"\n"), 200)

    def test_the_flag_file_makes_the_same_log(self):
        made = self.make("a", "--seed=6", "--kind=hall", f"--simulate={SIMULATE}")
        folder = self.folder / "a"
        subprocess.run([SIMULATE, f"--world={folder / 'world.yaml'}",
                        f"--flagfile={folder / 'simulate.flags'}",
                        f"--output_dir={self.folder / 'b'}"], check=True, capture_output=True)
        self.assertEqual((self.folder / "b" / "log.clf").read_bytes(), made["log.clf"])

    def test_kinds_are_listed(self):
        self.assertEqual(self.run_tool("--list").stdout.split(), [*KINDS, "any"])
        self.assertIn("one open hall with pillars", self.run_tool("--help").stdout)

    def test_what_is_wrong_is_told_in_one_line(self):
        out = f"--output_dir={self.folder / 'x'}"
        for words, complaint in (
                (["--seed=-1"], "expected a seed of 0 or more"),
                (["--seed=1", "--kind=hal"], "invalid choice: 'hal'"),
                (["--kind=hall"], "required: --seed"),
                (["--seed=1", "--kind=hall", "--simulate=/no/simulate"], "No such file")):
            done = self.run_tool(*words, out)
            self.assertNotEqual(done.returncode, 0)
            self.assertIn(complaint, done.stderr.splitlines()[-1])


if __name__ == "__main__":
    unittest.main()
