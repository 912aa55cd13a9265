# SPDX-License-Identifier: BSD-3-Clause
"""The example runs, and its picture is one."""

import pathlib
import subprocess
import sys
import tempfile
import unittest

EXAMPLE = pathlib.Path(__file__).resolve().parents[3] / "experiments/python/example.py"

try:
    import matplotlib
except ImportError:
    matplotlib = None


@unittest.skipIf(matplotlib is None, "matplotlib is not there")
class ExampleTest(unittest.TestCase):
    def test_draws_what_it_says(self):
        with tempfile.TemporaryDirectory() as folder:
            picture = pathlib.Path(folder) / "map.png"
            done = subprocess.run([sys.executable, EXAMPLE, picture], capture_output=True, text=True)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertTrue(picture.read_bytes().startswith(b"\x89PNG"))
        error = done.stdout.split("absolute trajectory error: ")[1].split()[0]
        self.assertLess(float(error), 0.05)
        self.assertIn("loop closed", done.stdout)


if __name__ == "__main__":
    unittest.main()
