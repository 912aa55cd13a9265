# SPDX-License-Identifier: BSD-3-Clause
"""CARMEN logs as records that can be changed; what is not understood is kept as it stands."""
import dataclasses
import gzip
import pathlib

import numpy as np

import poses

NO_RETURN_FROM_M = 40.0  # no lidar of these logs sees so far indoors
SICK_NO_RETURN_M = 81.91


class LogError(Exception):
    """What is wrong with a log, in one line."""


@dataclasses.dataclass
class Scan:
    """FLASER or ROBOTLASER1. `beams` are the seven fields before the ranges of a ROBOTLASER1."""
    ranges_m: np.ndarray
    odom_T_laser: np.ndarray
    odom_T_robot: np.ndarray
    stamp_s: float
    source_stamp_s: float  # of the log that was read: relations name scans by it
    rest: list[str]  # host and logger's time
    beams: list[str] | None = None
    remissions: list[str] = dataclasses.field(default_factory=list)
    speeds: list[str] = dataclasses.field(default_factory=list)
    is_in_relation: bool = False  # a relation names it: better kept, to be scored by

    def angles_rad(self) -> np.ndarray:
        """Of the beams, in the frame of the laser; for FLASER by the number of beams."""
        n = len(self.ranges_m)
        if self.beams:
            start, span, step = (float(self.beams[i]) for i in (1, 2, 3))
            return start + np.arange(n) * (step or span / max(n - 1, 1))
        # 180 and 360 beams leave out the last one, at 90 deg.
        return -np.pi / 2 + np.arange(n) * np.pi / (n if n in (180, 360) else max(n - 1, 1))

    def line(self) -> str:
        ranges = " ".join(map(repr, self.ranges_m.tolist()))
        n = len(self.ranges_m)
        pose = f"{_pose(self.odom_T_laser)} {_pose(self.odom_T_robot)}"
        end = _join(f"{self.stamp_s:.6f}", *self.rest)
        if self.beams is None:
            return f"FLASER {n} {ranges} {pose} {end}"
        remissions = _join(str(len(self.remissions)), *self.remissions)
        return _join("ROBOTLASER1", *self.beams, f"{n} {ranges}", remissions, pose, *self.speeds,
                     end)


@dataclasses.dataclass
class Odometry:
    """ODOM."""
    odom_T_robot: np.ndarray
    speeds: list[str]  # linear, angular, acceleration
    stamp_s: float
    rest: list[str]

    def line(self) -> str:
        return _join("ODOM", _pose(self.odom_T_robot), *self.speeds, f"{self.stamp_s:.6f}",
                     *self.rest)


@dataclasses.dataclass
class Other:
    """Comments, parameters and what else there is."""
    text: str

    def line(self) -> str:
        return self.text


class Log:
    """Records in the order of the file."""

    def __init__(self, records: list[Scan | Odometry | Other]):
        self.records = records

    def scans(self) -> list[Scan]:
        """In the order of their time stamps, which need not be that of the file."""
        return sorted((r for r in self.records if isinstance(r, Scan)), key=lambda r: r.stamp_s)

    def odometry(self) -> list[Odometry]:
        return [r for r in self.records if isinstance(r, Odometry)]

    def keep(self, scans: list[Scan]) -> None:
        """Leaves out all other scans."""
        kept = {id(scan) for scan in scans}
        self.records = [r for r in self.records if not isinstance(r, Scan) or id(r) in kept]

    def no_return_m(self) -> float:
        """How this log writes a beam that nothing came back from: its most frequent reading of 40 m
        or more (81.83, 81.91, 50.0, 51.06 in known logs); 81.91, as SICK does, if it has none."""
        far = np.concatenate([s.ranges_m[s.ranges_m >= NO_RETURN_FROM_M] for s in self.scans()])
        if not far.size:
            return SICK_NO_RETURN_M
        values, counts = np.unique(far, return_counts=True)
        return float(values[np.argmax(counts)])

    def robot_T_laser(self) -> np.ndarray:
        """Where the laser is: what PARAM says, else what all FLASER agree on, else the middle."""
        said = {}
        for record in self.records:
            words = record.text.split() if isinstance(record, Other) else []
            if len(words) > 2 and words[0] == "PARAM" and words[1] in _MOUNTING:
                said[words[1]] = float(words[2])
        if said:
            return np.array([said.get(name, 0.0) for name in _MOUNTING])
        found = np.array([poses.between(s.odom_T_robot, s.odom_T_laser) for s in self.scans()])
        found[:, 2] = poses.wrap(found[:, 2])
        middle = np.median(found, axis=0)
        return middle if np.all(np.abs(found - middle) < 1e-2) else np.zeros(3)


_MOUNTING = ["robot_frontlaser_offset", "robot_frontlaser_side_offset",
             "robot_frontlaser_angular_offset"]


def read_text(file: pathlib.Path) -> str:
    """Of a file that may be gzipped."""
    content = file.read_bytes()
    try:
        return (gzip.decompress(content) if content[:2] == b"\x1f\x8b" else content).decode()
    except (OSError, EOFError, UnicodeDecodeError) as error:
        raise LogError(f"{file}: {error}") from error


def write_text(file: pathlib.Path, text: str) -> None:
    """Gzipped if the name ends with .gz; the same text is the same bytes."""
    content = text.encode()
    if file.suffix == ".gz":
        content = gzip.compress(content, compresslevel=6, mtime=0)
    file.write_bytes(content)


def read(file: pathlib.Path) -> Log:
    records = []
    for number, line in enumerate(read_text(file).removeprefix("\ufeff").splitlines(), 1):
        words = line.split()
        kind = words[0] if words else ""
        try:
            if kind in _PARSERS:
                records.append(_PARSERS[kind](words))
                continue
        except (ValueError, IndexError) as error:
            raise LogError(f"{file}:{number}: expected a {kind} record, found another") from error
        if kind == "RAWLASER1":
            raise LogError(f"{file}:{number}: expected FLASER or ROBOTLASER1, found RAWLASER1")
        records.append(Other(line))
    log = Log(records)
    if len(log.scans()) < 2:
        raise LogError(f"{file}: expected two scans or more, found {len(log.scans())}")
    return log


def write(log: Log, file: pathlib.Path) -> None:
    write_text(file, "".join(f"{record.line()}\n" for record in log.records))


def _flaser(words: list[str]) -> Scan:
    n = int(words[1])
    ranges, after = np.array(words[2:2 + n], float), words[2 + n:]
    return _scan(ranges, after, after[6:], [], None, [])


def _robot_laser(words: list[str]) -> Scan:
    n = int(words[8])
    ranges, after = np.array(words[9:9 + n], float), words[9 + n:]
    m = int(after[0])
    remissions, after = after[1:1 + m], after[1 + m:]
    return _scan(ranges, after, after[11:], after[6:11], words[1:8], remissions)


def _scan(ranges_m, after, end, speeds, beams, remissions) -> Scan:
    stamp_s = float(end[0])
    return Scan(ranges_m, np.array(after[:3], float), np.array(after[3:6], float), stamp_s,
                stamp_s, end[1:], beams, remissions, speeds)


def _odometry(words: list[str]) -> Odometry:
    return Odometry(np.array(words[1:4], float), words[4:7], float(words[7]), words[8:])


_PARSERS = {"FLASER": _flaser, "ROBOTLASER1": _robot_laser, "ODOM": _odometry}


def _pose(pose: np.ndarray) -> str:
    return f"{pose[0]:.6f} {pose[1]:.6f} {pose[2]:.6f}"


def _join(*words: str) -> str:
    return " ".join(words)
