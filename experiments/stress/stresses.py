# SPDX-License-Identifier: BSD-3-Clause
"""All kinds of stress; importing them registers them."""
import zlib

import numpy as np

import beam_stresses  # noqa: F401
import carmen
import people  # noqa: F401
import stream_stresses  # noqa: F401
import wheel_stresses  # noqa: F401
from registry import STRESSES

__all__ = ["STRESSES", "apply"]


def apply(log: carmen.Log, kind: str, seed: int, size: float = 1.0) -> None:
    """Changes the log; the same seed does the same to the same log, and another for each kind."""
    rng = np.random.default_rng([seed, zlib.crc32(kind.encode())])
    STRESSES[kind].apply(log, rng, size)
