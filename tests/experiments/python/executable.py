# SPDX-License-Identifier: BSD-3-Clause
"""SLAM in Python beside that of the executable."""

import os
import pathlib
import subprocess
import tempfile

import numpy as np

import gmapping_spa as gs

BINARIES = pathlib.Path(os.environ["GMAPPING_SPA_BINARIES"])


def slam_of(scans, options=None, backend=None):
    slam = gs.Slam(options or gs.SlamOptions(), backend)
    for scan in scans:
        slam.add_scan(scan)
    slam.finish()
    return slam


def expect_the_same_bytes(test, log, flags, options):
    """Of trajectory, graph and map."""
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        command = [BINARIES / "gmapping_spa", f"--log={log}", f"--output_dir={folder}/exe", *flags]
        subprocess.run(command, check=True, capture_output=True)
        scans = list(gs.CarmenLog(log))
        slam = slam_of(scans, options)
        # The executable writes poses in the order of the log, whose scans came in the order of time.
        in_log = np.argsort([scan.index for scan in scans])
        gs.write_tum(folder / "trajectory.tum", slam.trajectory[in_log])
        gs.write_g2o(folder / "graph.g2o", slam.graph)
        slam.map.write(folder / "map.yaml")
        for name in ("trajectory.tum", "graph.g2o", "map.pgm", "map.yaml"):
            test.assertEqual((folder / name).read_bytes(), (folder / "exe" / name).read_bytes(), name)
