# SPDX-License-Identifier: BSD-3-Clause
"""Relations (true motion between two scans) that follow their scans into a stressed log."""
import dataclasses
import pathlib

import numpy as np

import carmen
import poses

# As far as an end of a relation may move, from scan to scan that relations name.
MAX_MOVES = 5


@dataclasses.dataclass(frozen=True)
class Relation:
    i: str  # time stamp of a scan of the log that was read
    j: str
    i_T_j: np.ndarray


def key(stamp_s: float) -> str:
    """A time stamp as relations name scans by it."""
    return f"{stamp_s:.6f}"


def read(file: pathlib.Path) -> list[Relation]:
    relations = []
    for number, line in enumerate(carmen.read_text(file).splitlines(), 1):
        words = line.split()
        if not words or words[0].startswith("#"):
            continue
        try:
            i_s, j_s, x, y, _, _, _, theta = map(float, words)
        except ValueError as error:
            raise carmen.LogError(f"{file}:{number}: expected t1 t2 x y z roll pitch yaw, found "
                                  f"'{line}'") from error
        relations.append(Relation(key(i_s), key(j_s), np.array([x, y, theta])))
    return relations


def mark(log: carmen.Log, relations: list[Relation]) -> None:
    """Tells the scans that relations name."""
    named = {stamp for relation in relations for stamp in (relation.i, relation.j)}
    for scan in log.scans():
        scan.is_in_relation = key(scan.source_stamp_s) in named


def follow(log: carmen.Log, relations: list[Relation]) -> list[Relation]:
    """In terms of the stressed log's time stamps, the earlier scan first if it was. An end whose
    scan is gone moves on to the next scan that is named, by the relation that joins the two; what
    cannot be moved so is left out."""
    new_stamps = {key(scan.source_stamp_s): key(scan.stamp_s) for scan in log.scans()}
    steps = _steps_to_next(relations)
    followed, pairs = [], set()
    for relation in relations:
        start = _move(relation.i, steps, new_stamps)
        end = _move(relation.j, steps, new_stamps)
        if start is None or end is None or start[0] == end[0]:
            continue
        (i, i_T_start), (j, j_T_end) = start, end
        # Several may move onto the same pair of scans: one of them will do.
        if (i, j) in pairs and (i, j) != (relation.i, relation.j):
            continue
        pairs.add((i, j))
        start_T_end = poses.compose(poses.between(i_T_start, relation.i_T_j), j_T_end)
        followed.append(_in_order(i, j, start_T_end, new_stamps))
    return followed


def _steps_to_next(relations: list[Relation]) -> dict[str, tuple[str, np.ndarray]]:
    """From each scan that is named to the one after it, where a relation joins them."""
    named = sorted({s for r in relations for s in (r.i, r.j)}, key=float)
    after = dict(zip(named, named[1:]))
    return {r.i: (r.j, r.i_T_j) for r in reversed(relations) if after.get(r.i) == r.j}


def _move(stamp: str, steps, kept) -> tuple[str, np.ndarray] | None:
    """The first scan from here on that is kept, and its pose relative to the one that was named."""
    pose = np.zeros(3)
    for _ in range(MAX_MOVES + 1):
        if stamp in kept:
            return stamp, pose
        if stamp not in steps:
            return None
        stamp, step = steps[stamp]
        pose = poses.compose(pose, step)
    return None


def _in_order(i: str, j: str, i_T_j: np.ndarray, new_stamps: dict[str, str]) -> Relation:
    new_i, new_j = new_stamps[i], new_stamps[j]
    if (float(new_i) < float(new_j)) == (float(i) < float(j)):
        return Relation(new_i, new_j, i_T_j)
    return Relation(new_j, new_i, poses.inverse(i_T_j))


def write(relations: list[Relation], file: pathlib.Path) -> None:
    carmen.write_text(file, "".join(
        f"{r.i} {r.j} {r.i_T_j[0]:.6f} {r.i_T_j[1]:.6f} 0 0 0 {r.i_T_j[2]:.6f}\n"
        for r in relations))
