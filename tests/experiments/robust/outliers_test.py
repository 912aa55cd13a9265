# SPDX-License-Identifier: BSD-3-Clause
"""The study of wrong loop closures, on a small graph with the built executables."""
import contextlib
import csv
import gzip
import io
import os
import pathlib
import sys
import tempfile
import unittest
from unittest import mock

import square_graph
import yaml

import outliers

STUDY = {
    "clean_graph": "square.g2o.gz", "truth": "square.truth.gz",
    "policies": ["random", "local"], "counts": [10, 20], "draws": 2,
    "configurations": {"mixture": {"flags": "--loss=mixture"},
                       "none": {"flags": "--loss=none", "draws": 1, "max_count": 10},
                       "bad": {"flags": "--loss=bad", "draws": 1, "max_count": 0}},
    "recognized": {"graphs": ["square.g2o.gz"], "stamps": "stamps.gz", "truth": "truth.csv.gz"}}


class OutliersTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        lines, truth = square_graph.lines_and_truth()
        self.write("square.g2o.gz", lines)
        self.write("square.truth.gz", [f"{x} {y} {theta}" for x, y, theta in truth])
        self.write("stamps.gz", [str(k) for k in range(len(truth))])
        self.write("truth.csv.gz", [f"{k}, {x}, {y}, {t}" for k, (x, y, t) in enumerate(truth)])
        (self.folder / "study.yaml").write_text(yaml.safe_dump(STUDY))

    def write(self, name, lines):
        with gzip.open(self.folder / name, "wt") as file:
            file.write("\n".join(lines) + "\n")

    def run_study(self):
        arguments = ["outliers.py", str(self.folder / "study.yaml"), f"--graphs={self.folder}",
                     f"--bin={os.environ['GMAPPING_SPA_BINARIES']}", f"--output_dir={self.folder}/out"]
        with mock.patch.object(sys, "argv", arguments), contextlib.redirect_stdout(io.StringIO()):
            outliers.main()
        with (self.folder / "out" / "results.csv").open() as file:
            return list(csv.DictReader(file))

    def test_mixture_is_right_where_least_squares_is_not(self):
        rows = self.run_study()
        errors = {name: [float(r["error_m"]) for r in rows if r["configuration"] == name
                         and r["count"] not in ("", "0")] for name in ("mixture", "none")}
        self.assertEqual((len(errors["mixture"]), len(errors["none"])), (8, 2))
        self.assertLess(max(errors["mixture"]), 0.05)
        self.assertGreater(min(errors["none"]), 0.1)
        # One is right within its noise by chance: the robot is there in each round.
        self.assertLessEqual(sum(int(r["wrong_accepted"]) for r in rows
                                 if r["configuration"] == "mixture" and r["policy"] != "recognized"), 1)
        failed = [r for r in rows if r["configuration"] == "bad"]
        self.assertEqual({r["error_m"] for r in failed}, {""})
        table = (self.folder / "out" / "outliers.md").read_text()
        self.assertIn("| 20 random |", table)
        self.assertIn("1 failed", table)
        self.assertIn("not run", table)
        self.assertTrue((self.folder / "out" / "outliers.png").stat().st_size > 1000)

    def test_what_is_done_is_not_done_again(self):
        first = self.run_study()
        with mock.patch.object(outliers, "optimize", side_effect=AssertionError):
            self.assertEqual(self.run_study(), first)


if __name__ == "__main__":
    unittest.main()
