# SPDX-License-Identifier: BSD-3-Clause
"""Man pages and completion of a small program, or of the executables, in a temporary folder."""
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[3]
SCRIPT = ROOT / "experiments" / "packages" / "describe_executables.py"
sys.path[:0] = [str(SCRIPT.parent), str(ROOT / "experiments" / "docs")]

# All of them, from the build: none that is new goes untested.
EXECUTABLES = os.environ.get("GMAPPING_SPA_EXECUTABLES", "").split()

HELP = """#!/bin/sh
cat <<'END'
<?xml version="1.0"?>
<AllFlags><program>tool</program><usage>does things (Doe et al. 1999). More.
Usage: tool --size=S
       tool --list
Files may be gzipped.</usage>
<group><name>size</name><title>Size &amp; weight</title>
<flag><name>size</name><meaning>.5 is the size's best value in m; \\ is -1.
</meaning><default>0.050000000000000003</default><current>9</current><type>double</type></flag>
<flag><name>list</name><meaning>List them.</meaning>
<default>false</default><current>false</current><type>bool</type></flag>
<flag><name>no_limit</name><meaning>There is none.</meaning>
<default>true</default><current>true</current><type>bool</type></flag>
</group>
<group><name>files</name><title>Files</title>
<flag><name>log</name><meaning>Sensor log.</meaning>
<default></default><current></current><type>string</type></flag>
<flag><name>output_dir</name><meaning>Folder for results.</meaning>
<default></default><current></current><type>string</type></flag>
<flag><name>backend</name><meaning>What does it: spa, ceres (a, b or c), none, or the path of one.</meaning>
<default>spa</default><current>spa</current><type>string</type></flag>
</group>
</AllFlags>
END
"""


class DescribedTestCase(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def describe(self, *executables):
        """Returns the folder with man1 and completions."""
        described = self.folder / "described"
        subprocess.run([SCRIPT, "--version=1.2.3", "--data_folder=/data", f"--output={described}",
                        *executables], check=True)
        return described

    def describe_tool(self):
        tool = self.folder / "tool"
        tool.write_text(HELP)
        tool.chmod(0o755)
        return self.describe(tool)

    def describe_executables(self):
        if not EXECUTABLES:
            self.skipTest("no executables")
        binaries = pathlib.Path(os.environ["GMAPPING_SPA_BINARIES"])
        return self.describe(*(binaries / name for name in EXECUTABLES))
