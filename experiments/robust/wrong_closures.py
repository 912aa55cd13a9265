# SPDX-License-Identifier: BSD-3-Clause
"""Wrong loop closures for graphs that have none, as Suenderhauf and Protzel (2012) make them."""
import random


def add_wrong_closures(lines, policy, count, seed):
    """The lines of a .g2o file with `count` wrong loop closures, and the set of their (i, j).

    policy: random (between any two nodes), local (between nodes at most 20 steps apart) or grouped
    (ten between successive nodes of one place and of another, which agree with each other).
    They measure nearly the same pose, with the information of the first right loop closure.
    """
    draw = random.Random(f"{policy} {count} {seed}")
    edges = [line.split() for line in lines if line.startswith("EDGE_SE2 ")]
    ids = sorted({int(word) for words in edges for word in words[1:3]})
    information = next(words[6:] for words in edges if abs(int(words[1]) - int(words[2])) > 1)
    group = 10 if policy == "grouped" else 1
    wrong = {}
    while len(wrong) < count:
        i = draw.randrange(len(ids) - group)
        j = i + draw.randint(2, 20) if policy == "local" else draw.randrange(len(ids) - group)
        if abs(i - j) < 2 or j >= len(ids):
            continue
        pose = (draw.gauss(0, 0.3), draw.gauss(0, 0.3), draw.gauss(0, 0.17))
        for k in range(min(group, count - len(wrong))):
            noise = (0.02, 0.02, 0.01) if group > 1 else (0, 0, 0)
            wrong[ids[i + k], ids[j + k]] = [p + draw.gauss(0, n) if n else p
                                             for p, n in zip(pose, noise)]
    added = [" ".join(["EDGE_SE2", str(i), str(j), *(f"{v:.6f}" for v in pose), *information])
             for (i, j), pose in wrong.items()]
    return lines + added, set(wrong)
