# SPDX-License-Identifier: BSD-3-Clause
"""In bash, flags, their values and names of files are completed."""
import subprocess
import unittest

from described_programs import EXECUTABLES, DescribedTestCase

# What readline does before it calls the function: words are split at blanks, and at = with spaces around it.
ASK = r"""
source "$1" || exit 1
program=$2; shift 2
COMP_WORDS=("$program" "$@"); COMP_CWORD=$#; COMPREPLY=()
word=${COMP_WORDS[COMP_CWORD]}; [[ $word == = ]] && word=
_gmapping_spa_complete "$program" "$word" "${COMP_WORDS[COMP_CWORD-1]}"
printf '%s\n' "${COMPREPLY[@]}"
"""


class CompletionTest(DescribedTestCase):
    def replies(self, described, program, *words):
        done = subprocess.run(["bash", "--norc", "-c", ASK, "ask",
                               described / "completions" / "gmapping_spa", program, *words],
                              cwd=self.folder, capture_output=True, text=True)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        return done.stdout.split()

    def test_flags_are_completed_and_refusals_on_demand(self):
        tool = self.describe_tool()
        self.assertEqual(self.replies(tool, "tool", "--"),
                         ["--backend=", "--flagfile=", "--help", "--helpfull", "--helpxml", "--list",
                          "--log=", "--no_limit", "--output_dir=", "--size=", "--version"])
        self.assertEqual(self.replies(tool, "tool", "--l"), ["--list", "--log="])
        self.assertEqual(self.replies(tool, "tool", "--no"), ["--no_limit", "--nolist", "--nono_limit"])
        self.assertEqual(self.replies(tool, "/some/where/tool", "--li"), ["--list"])

    def test_values_are_completed_after_an_equals_sign_or_a_blank(self):
        tool = self.describe_tool()
        for words in (["--backend", "="], ["-backend", "="], ["--backend", ""]):
            self.assertEqual(self.replies(tool, "tool", "--list", *words)[:3],
                             ["spa", "ceres", "none"])
        self.assertEqual(self.replies(tool, "tool", "--backend", "=", "sp"), ["spa"])
        # Where = is no word break.
        self.assertEqual(self.replies(tool, "tool", "--backend=c"), ["--backend=ceres"])
        self.assertEqual(self.replies(tool, "tool", "--list", "=", ""), ["true", "false"])
        self.assertEqual(self.replies(tool, "tool", "--size", "="), [])

    def test_files_and_folders_are_completed_where_such_are_meant(self):
        tool = self.describe_tool()
        (self.folder / "day.clf").touch()
        (self.folder / "days").mkdir()
        (self.folder / "cart.so").touch()
        self.assertCountEqual(self.replies(tool, "tool", "--log", "=", "da"), ["day.clf", "days"])
        self.assertEqual(self.replies(tool, "tool", "--output_dir", "=", "da"), ["days"])
        self.assertCountEqual(self.replies(tool, "tool", "--backend", "=", "c"), ["ceres", "cart.so"])

    def test_a_value_does_not_take_the_next_flag(self):
        tool = self.describe_tool()
        self.assertEqual(self.replies(tool, "tool", "--list", "--li"), ["--list"])
        self.assertEqual(self.replies(tool, "tool", "--log", "=", "x", "--li"), ["--list"])

    def test_every_executable_has_its_flags_and_a_file_for_bash_completion(self):
        described = self.describe_executables()
        for name in EXECUTABLES:
            self.assertTrue((described / "completions" / name).is_file())
            self.assertGreater(len(self.replies(described, name, "--")), 5)
        self.assertEqual(self.replies(described, "gmapping_spa", "--scan_matcher", "="),
                         ["hill_climbing", "gauss_newton"])
        self.assertEqual(self.replies(described, "optimize_graph", "--loss", "=", "d"), ["dcs"])

    def test_bash_knows_the_function_for_each_executable(self):
        described = self.describe_executables()
        done = subprocess.run(
            ["bash", "--norc", "-c", f"source {described}/completions/simulate && complete -p"],
            capture_output=True, text=True, check=True)
        self.assertEqual(len(done.stdout.splitlines()), len(EXECUTABLES))
        for name in EXECUTABLES:
            self.assertIn(f"complete -F _gmapping_spa_complete {name}\n", done.stdout)


if __name__ == "__main__":
    unittest.main()
