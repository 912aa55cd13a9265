# SPDX-License-Identifier: BSD-3-Clause
"""A whole log: the bytes of the executable."""

import os
import pathlib
import unittest

from executable import expect_the_same_bytes

import gmapping_spa as gs

DEFAULT_DATA = pathlib.Path(__file__).resolve().parents[4] / "shared/data"
DATA = pathlib.Path(os.environ.get("GMAPPING_SPA_DATA", DEFAULT_DATA))


@unittest.skipUnless((DATA / "carmen").is_dir(), f"{DATA} is not there")
class RealLogTest(unittest.TestCase):
    def test_the_same_bytes_on_intel(self):
        log = next((DATA / "carmen").glob("intel*"))
        expect_the_same_bytes(self, log, ["--seed=1"], gs.SlamOptions(seed=1))


if __name__ == "__main__":
    unittest.main()
