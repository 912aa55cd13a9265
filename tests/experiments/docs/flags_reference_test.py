# SPDX-License-Identifier: BSD-3-Clause
"""The flags reference says what executables say, and pages cannot name flags that do not exist."""
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[3]
SCRIPT = ROOT / "experiments" / "docs" / "flags_reference.py"
sys.path.insert(0, str(SCRIPT.parent))
import flags_reference  # noqa: E402

HELP = """#!/bin/sh
cat <<'END'
<?xml version="1.0"?>
<AllFlags><program>tool</program><usage>does things.
Usage: tool --size=S</usage>
<group><name>size</name><title>Size &amp; weight</title>
<flag><name>size</name><meaning>Size in m, 1 | 2; &lt; 3.
</meaning><default>0.050000000000000003</default><current>9</current><type>double</type></flag>
</group>
<group><name>files</name><title>Files</title>
<flag><name>log</name><meaning>Sensor log.</meaning>
<default></default><current></current><type>string</type></flag>
</group>
</AllFlags>
END
"""


class FlagsReferenceTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.tool = self.folder / "tool"
        self.tool.write_text(HELP)
        self.tool.chmod(0o755)

    def run_script(self, *words):
        return subprocess.run([SCRIPT, *words], capture_output=True, text=True)

    def test_flags_stand_in_groups_with_their_defaults(self):
        page = self.run_script(self.tool).stdout
        self.assertIn("## tool\n\ndoes things.\n\nUsage: tool --size=S\n", page)
        self.assertIn("**Size & weight**\n\n| flag | type | default | meaning |\n|---|---|---|---|\n"
                      "| `--size` | double | `0.05` | Size in m, 1 \\| 2; &lt; 3. |\n", page)
        self.assertIn("**Files**\n\n| flag | type | default | meaning |\n|---|---|---|---|\n"
                      "| `--log` | string | (empty) | Sensor log. |\n", page)

    def test_a_page_that_names_an_unknown_flag_is_refused_with_its_line(self):
        page = self.folder / "page.md"
        page.write_text("`--size=1`, `--nosize` and `--flagfile=x`\n\nnot `--sise=2`\n")
        done = self.run_script("--check", page, "--", self.tool)
        self.assertEqual(done.returncode, 1)
        self.assertEqual(done.stderr,
                         f"{page}:3: expected a flag of an executable, found '--sise'\n")

    def test_a_page_that_names_known_flags_passes(self):
        page = self.folder / "page.md"
        page.write_text("`--size=1` and `--log`\n")
        self.assertEqual(self.run_script("--check", page, "--", self.tool).returncode, 0)

    def test_what_prints_no_help_is_an_error(self):
        done = self.run_script("/bin/true")
        self.assertEqual(done.returncode, 1)
        self.assertIn("expected the XML of --helpxml", done.stderr)

    @unittest.skipUnless("GMAPPING_SPA_BINARIES" in os.environ, "no executables")
    def test_every_flag_of_gmapping_spa_that_help_shows_has_a_line(self):
        tool = pathlib.Path(os.environ["GMAPPING_SPA_BINARIES"]) / "gmapping_spa"
        shown = subprocess.run([tool, "--help"], capture_output=True, text=True).stdout
        names = {line.split()[0].lstrip("-") for line in shown.splitlines()
                 if line.startswith("    -")}
        page = flags_reference.page_of([str(tool)])
        missing = {name for name in names if f"| `--{name}` |" not in page}
        self.assertGreater(len(names), 50)
        self.assertEqual(missing, set())


if __name__ == "__main__":
    unittest.main()
