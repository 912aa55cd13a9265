#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
import pathlib
import subprocess
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[3]
TABLE = "Caption\n\n| A | B |\n| --- | --- |\n| ours | 1 |\n| theirs | 2 |\n"


class UpdateReadmeTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.readme = pathlib.Path(folder.name) / "README.md"
        self.table = pathlib.Path(folder.name) / "table.md"
        self.readme.write_text("Before\n<!-- results begin -->\nold\n<!-- results end -->\nAfter\n")
        self.table.write_text(TABLE)

    def update(self, *words):
        return subprocess.run(
            [ROOT / "experiments/workflow/update_readme.py", self.readme, *words],
            capture_output=True, text=True)

    def test_the_table_replaces_what_stands_between_the_marks(self):
        self.assertEqual(self.update("results", self.table).returncode, 0)
        self.assertEqual(self.readme.read_text(), "Before\n<!-- results begin -->\n" + TABLE +
                         "<!-- results end -->\nAfter\n")

    def test_rows_are_those_that_contain_the_text(self):
        self.update("results", self.table, "--rows=| ours")
        self.assertIn("| ours | 1 |", self.readme.read_text())
        self.assertNotIn("theirs", self.readme.read_text())

    def test_a_mark_or_a_row_that_is_not_there_is_an_error_and_changes_nothing(self):
        before = self.readme.read_text()
        for words, complaint in ((("result", self.table), "expected one '<!-- result begin -->'"),
                                 (("results", self.table, "--rows=his"), "no row contains 'his'")):
            done = self.update(*words)
            self.assertEqual(done.returncode, 1)
            self.assertIn(complaint, done.stderr)
            self.assertEqual(len(done.stderr.splitlines()), 1)
        self.assertEqual(self.readme.read_text(), before)


if __name__ == "__main__":
    unittest.main()
