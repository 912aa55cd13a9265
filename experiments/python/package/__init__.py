# SPDX-License-Identifier: BSD-3-Clause
"""2D lidar SLAM with interchangeable pose-graph back ends.

Scans and odometry go in as numpy arrays; poses, maps and pose graphs come out. Frames are named as in
world_T_robot, which maps coordinates of the robot to those of the world; units are m, rad and s.

    slam = gmapping_spa.Slam()
    for scan in gmapping_spa.CarmenLog("robot.clf.gz"):
        slam.add_scan(scan)
    slam.finish()
    slam.trajectory["world_T_robot"], slam.map.cells
"""

import enum

from gmapping_spa import _core
from gmapping_spa._core import *  # noqa: F403: all that it has
from gmapping_spa._core import __version__


class EdgeKind(enum.IntEnum):
    """What an edge of a pose graph comes from: the field `kind` of EDGE_DTYPE."""

    ODOMETRY = 0
    SCAN_MATCH = 1
    LOOP_CLOSURE = 2


class BeamStatus(enum.IntEnum):
    """What a beam says: the field `status` of BEAM_DTYPE."""

    HIT = 0
    NO_RETURN = 1
    INVALID = 2


__all__ = ["BeamStatus", "EdgeKind", *(name for name in dir(_core) if not name.startswith("_"))]
for _name in dir(_core):
    if isinstance(getattr(_core, _name), type):
        getattr(_core, _name).__module__ = __name__
del enum, _name
