"""Relations (true motion between two scans) that follow their scans into a stressed log."""
import pathlib

import numpy as np

import carmen
import poses


def _key(stamp_s: float) -> str:
    return f"{stamp_s:.6f}"


def follow(log: carmen.Log, text: str, name: str) -> tuple[str, int, int]:
    """The relations in terms of the stressed log, how many there were and how many are left: both
    scans must be there. The earlier scan comes first in the text, and does so in the result."""
    stamps_s = {_key(scan.source_stamp_s): scan.stamp_s for scan in log.scans()}
    lines, count = [], 0
    for number, line in enumerate(text.splitlines(), 1):
        words = line.split()
        if not words or words[0].startswith("#"):
            continue
        count += 1
        try:
            i_s, j_s, x, y, _, _, _, theta = map(float, words)
        except ValueError as error:
            raise carmen.LogError(f"{name}:{number}: expected t1 t2 x y z roll pitch yaw, found "
                                  f"'{line}'") from error
        if _key(i_s) not in stamps_s or _key(j_s) not in stamps_s:
            continue
        new_i_s, new_j_s, i_T_j = stamps_s[_key(i_s)], stamps_s[_key(j_s)], np.array([x, y, theta])
        if (new_i_s < new_j_s) != (i_s < j_s):
            new_i_s, new_j_s, i_T_j = new_j_s, new_i_s, poses.inverse(i_T_j)
        x, y, theta = i_T_j
        lines.append(f"{new_i_s:.6f} {new_j_s:.6f} {x:.6f} {y:.6f} 0 0 0 {theta:.6f}\n")
    return "".join(lines), count, len(lines)


def rewrite(log: carmen.Log, source: pathlib.Path, output: pathlib.Path) -> tuple[int, int]:
    text, count, left = follow(log, carmen.read_text(source), str(source))
    carmen.write_text(output, text)
    return count, left
