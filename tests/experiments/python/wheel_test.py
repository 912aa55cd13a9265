# SPDX-License-Identifier: BSD-3-Clause
"""The wheel installs into a new environment and works there, without the build."""

import os
import pathlib
import subprocess
import sys
import tempfile
import unittest
import zipfile

ROOT = pathlib.Path(__file__).resolve().parents[3]
BUILD = pathlib.Path(os.environ["GMAPPING_SPA_BUILD"])

try:
    import ensurepip
except ImportError:
    ensurepip = None

SCRIPT = """
import gmapping_spa as gs, numpy as np
assert "site-packages" in gs.__file__, gs.__file__
nodes, edges = np.zeros(2, gs.NODE_DTYPE), np.zeros(1, gs.EDGE_DTYPE)
nodes["id"], edges["j"], edges["i_T_j"], edges["information"] = [0, 1], 1, (1, 2, 0.5), np.eye(3)
for back_end in gs.list_backends():
    assert "site-packages" in back_end["path"], back_end
    gs.optimize(gs.PoseGraph(nodes, edges), back_end["name"])
slam = gs.Slam()
slam.add_scan(gs.LaserScan(0.0, np.full(180, 5.0)))
print(gs.optimize(gs.PoseGraph(nodes, edges))[0].nodes["world_T_node"][1].round(3).tolist())
"""


class WheelTest(unittest.TestCase):
    def make(self, folder):
        done = subprocess.run(
            [sys.executable, ROOT / "experiments/python/make_wheel.py", "--version=0.1.0",
             f"--package={BUILD}/python/gmapping_spa", f"--license={ROOT}/LICENSE",
             f"--output_dir={folder}"], check=True, capture_output=True, text=True)
        return pathlib.Path(done.stdout.strip())

    def test_the_same_files_give_the_same_bytes(self):
        with tempfile.TemporaryDirectory() as a, tempfile.TemporaryDirectory() as b:
            self.assertEqual(self.make(a).read_bytes(), self.make(b).read_bytes())

    def test_holds_what_typing_needs(self):
        with tempfile.TemporaryDirectory() as folder, zipfile.ZipFile(self.make(folder)) as wheel:
            self.assertIsNone(wheel.testzip())
            self.assertLessEqual({"gmapping_spa/py.typed", "gmapping_spa/__init__.pyi"},
                                 set(wheel.namelist()))

    @unittest.skipIf(ensurepip is None, "python3-venv is not there")
    def test_installs_and_works(self):
        environment = {k: v for k, v in os.environ.items() if k != "PYTHONPATH"}
        with tempfile.TemporaryDirectory() as folder:
            subprocess.run([sys.executable, "-m", "venv", "--system-site-packages", f"{folder}/venv"],
                           check=True, env=environment)
            python = f"{folder}/venv/bin/python"
            subprocess.run([python, "-m", "pip", "install", "--no-index", "--no-deps", "--quiet",
                            self.make(folder)], check=True, env=environment)
            done = subprocess.run([python, "-c", SCRIPT], cwd=folder, env=environment,
                                  capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(done.stdout.strip(), "[1.0, 2.0, 0.5]")


if __name__ == "__main__":
    unittest.main()
