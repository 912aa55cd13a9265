# SPDX-License-Identifier: BSD-3-Clause
"""Scans that are missing, repeated, or come at another time."""
import numpy as np

import carmen
import poses
from registry import moving_stretches, odometry_of, set_odometry, stamps_of, stress


@stress
def freeze(log, rng, size):
    """10 times the scan stays the same, bit for bit, for 1 s while the wheels move on"""
    scans = log.scans()
    for first, last in moving_stretches(scans, rng, 10, 1.0 * size):
        for scan in scans[first + 1:last + 1]:
            scan.ranges_m = scans[first].ranges_m.copy()


@stress
def gaps(log, rng, size):
    """5 times there is no scan for 2 s while the robot moves"""
    scans = log.scans()
    lost = {i for first, last in moving_stretches(scans, rng, 5, 2.0 * size)
            for i in range(first, last + 1)}
    log.keep([scan for i, scan in enumerate(scans) if i not in lost])


def _one_each(log, distance_m):
    """Scans that relations name come up to a fifth early, and others as much late, so that enough
    relations are left."""
    scans = log.scans()
    steps = poses.steps_of(odometry_of(scans))
    travelled_m = np.concatenate([[0.0], np.cumsum(np.hypot(steps[:, 0], steps[:, 1]))])
    play_m = 0.2 * distance_m if any(scan.is_in_relation for scan in scans) else 0.0
    kept, last_m = [scans[0]], 0.0
    for scan, at_m in zip(scans, travelled_m):
        if at_m - last_m >= distance_m + (-play_m if scan.is_in_relation else play_m):
            kept.append(scan)
            last_m = at_m
    log.keep(kept)


@stress
def thin(log, rng, size):
    """a scan each 0.5 m of odometry (0.4 to 0.6 m where relations are to be kept)"""
    _one_each(log, 0.5 * size)


@stress
def thin1m(log, rng, size):
    """a scan each 1 m of odometry (0.8 to 1.2 m where relations are to be kept)"""
    _one_each(log, 1.0 * size)


@stress
def teleport(log, rng, size):
    """somebody carries the robot to where it is 60 s later (a third of the log if that is less):
    that time is cut out of the middle, and the wheels know nothing of it"""
    scans = log.scans()
    stamps_s, odometry = stamps_of(scans), odometry_of(scans)
    middle_s = (stamps_s[0] + stamps_s[-1]) / 2
    half_s = min(30 * size, (stamps_s[-1] - stamps_s[0]) / 6)
    begin_s, end_s = middle_s - half_s, middle_s + half_s
    before, after = np.searchsorted(stamps_s, [begin_s, end_s]) - [1, 0]
    there_T_here = poses.compose(odometry[before], poses.inverse(odometry[after]))
    odometry[after:] = poses.compose(there_T_here, odometry[after:])
    set_odometry(log, odometry)
    log.records = [r for r in log.records
                   if isinstance(r, carmen.Other) or not begin_s <= r.stamp_s < end_s]


def _set_stamp(record, stamp_s):
    """The logger's time, the last field, moves with it."""
    if len(record.rest) > 1:
        record.rest[-1] = f"{float(record.rest[-1]) + stamp_s - record.stamp_s:.6f}"
    record.stamp_s = stamp_s


def _timed(log):
    return [r for r in log.records if not isinstance(r, carmen.Other)]


@stress
def reverse(log, rng, size):
    """the log backwards in time: a robot that reverses"""
    timed = sorted(_timed(log), key=lambda r: r.stamp_s)
    ends_s = timed[0].stamp_s + timed[-1].stamp_s
    for record in timed:
        _set_stamp(record, ends_s - record.stamp_s)
    others = [r for r in log.records if isinstance(r, carmen.Other)]
    log.records = [*others, *reversed(timed)]


@stress
def jitter(log, rng, size):
    """time stamps are wrong by up to 20 ms"""
    for record in _timed(log):
        _set_stamp(record, record.stamp_s + 0.02 * size * rng.uniform(-1, 1))


@stress
def clock_restart(log, rng, size):
    """the clock restarts at zero once, in the middle third; before, it had run for a million
    seconds, so that no stamp is there twice"""
    stamps_s = stamps_of(log.scans())
    at_s = stamps_s[rng.integers(len(stamps_s) // 3, 2 * len(stamps_s) // 3 + 1)]
    begin_s = stamps_s[0]
    for record in _timed(log):
        restarted = record.stamp_s >= at_s
        _set_stamp(record, record.stamp_s - at_s if restarted else record.stamp_s - begin_s + 1e6)
