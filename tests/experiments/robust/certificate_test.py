# SPDX-License-Identifier: BSD-3-Clause
"""The study of certificates, on two small graphs with the built executables."""
import contextlib
import gzip
import io
import json
import math
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest
from unittest import mock

import square_graph

import certificate


def wound_ring(nodes=12):
    """A ring whose poses turn twice on the way around: a local minimum."""
    turn, x, y, lines = 2 * math.pi / nodes, 0.0, 0.0, []
    for k in range(nodes):
        lines.append(f"VERTEX_SE2 {k} {x} {y} {2 * k * turn}")
        lines.append(f"EDGE_SE2 {k} {(k + 1) % nodes} 1 0 {turn} 100 0 0 100 0 100")
        x, y = x + math.cos(2 * k * turn), y + math.sin(2 * k * turn)
    return lines


BIN = pathlib.Path(os.environ["GMAPPING_SPA_BINARIES"])
BACK_ENDS = subprocess.run([BIN / "optimize_graph", "--list_backends"], capture_output=True,
                           text=True, check=True).stdout.splitlines()


class CertificateTest(unittest.TestCase):
    @unittest.skipUnless("ceres" in BACK_ENDS, "the build has no Ceres")
    def test_tables_tell_optima_from_local_minima(self):
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            graphs = {"square": square_graph.lines_and_truth()[0], "ring": wound_ring()}
            for graph, lines in graphs.items():
                with gzip.open(folder / f"{graph}.g2o.gz", "wt") as file:
                    file.write("\n".join(lines) + "\n")
            arguments = ["certificate.py", f"--bin={BIN}",
                         f"--output_dir={folder}/out", "--repeats=1",
                         *(str(folder / f"{graph}.g2o.gz") for graph in graphs)]
            with mock.patch.object(sys, "argv", arguments), \
                    contextlib.redirect_stdout(io.StringIO()):
                certificate.main()
            results = json.loads((folder / "out" / "certificate.json").read_text())
            self.assertEqual(list(results), list(graphs))
            certified = (folder / "out" / "certified.md").read_text().splitlines()
            self.assertEqual(len(certified), 4)
            self.assertTrue(all("| optimal, to " in line for line in certified[2:]))
            escaped = (folder / "out" / "escaped.md").read_text().splitlines()
            self.assertEqual(len(escaped), 3)
            self.assertIn("| ring |", escaped[2])
            self.assertIn("| not proved |", escaped[2])
            self.assertIn("| optimal, to ", escaped[2])

    def test_what_fails_ends_it(self):
        with self.assertRaisesRegex(SystemExit, "no such file|cannot|No such"):
            certificate.optimize("/nowhere.g2o", "", BIN)


if __name__ == "__main__":
    unittest.main()
