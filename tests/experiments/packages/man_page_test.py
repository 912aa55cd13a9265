# SPDX-License-Identifier: BSD-3-Clause
"""Man pages say what executables say, in a form that man and apropos understand."""
import re
import shutil
import subprocess
import unittest

from described_programs import EXECUTABLES, DescribedTestCase
import examples


def shown(page):
    """The page as man shows it, and what groff has to say against it."""
    done = subprocess.run(["groff", "-man", "-Tascii", "-ww", "-P-c", page],
                          capture_output=True, text=True)
    return re.sub(r".\x08", "", done.stdout), done.stderr


@unittest.skipUnless(shutil.which("groff"), "groff is missing")
class ManPageTest(DescribedTestCase):
    def test_a_page_shows_names_defaults_and_meanings(self):
        text, warnings = shown(self.describe_tool() / "man1" / "tool.1")
        self.assertEqual(warnings, "")
        for line in ("       tool - does things (Doe et al. 1999)\n",
                     "SYNOPSIS\n       tool --size=S\n\n       tool --list\n",
                     "       tool does things (Doe et al. 1999). More.  Files may be gzipped.\n",
                     "   Size & weight\n       --size=X\n"
                     "              .5 is the size's best value in m; \\ is -1. Default: 0.05.\n",
                     "       --[no]list\n", "       --output_dir=DIR\n",
                     "       --backend=spa|ceres|none|FILE\n"):
            self.assertIn(line, text)

    def test_pages_of_executables_have_no_warnings(self):
        described = self.describe_executables()
        for name in EXECUTABLES:
            text, warnings = shown(described / "man1" / f"{name}.1")
            self.assertEqual(warnings, "")
            for title in ("NAME", "SYNOPSIS", "OPTIONS", "EXIT STATUS", "EXAMPLES", "SEE ALSO"):
                self.assertIn(f"\n{title}\n", text)
            if shutil.which("lexgrog"):
                subprocess.run(["lexgrog", described / "man1" / f"{name}.1"], check=True,
                               stdout=subprocess.DEVNULL)

    def test_examples_use_flags_that_there_are(self):
        described = self.describe_executables()
        for name in EXECUTABLES:
            text, _ = shown(described / "man1" / f"{name}.1")
            for what, command in examples.EXAMPLES[name]:
                for flag in re.findall(r"--(\w+)", command):
                    self.assertRegex(text, rf"\n       --(\[no\])?{flag}\b", msg=f"{name}: {what}")


if __name__ == "__main__":
    unittest.main()
