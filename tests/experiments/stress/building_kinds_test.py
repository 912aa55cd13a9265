# SPDX-License-Identifier: BSD-3-Clause
"""Every kind of building lies in its outline, and is what its description says."""
import pathlib
import sys
import unittest

import numpy as np

ROOT = pathlib.Path(__file__).resolve().parents[3]
sys.path.insert(0, str(ROOT / "experiments" / "stress"))

import building_kinds
import floor_plan
from building_kinds import KINDS

SEEDS = range(20)


class BuildingKindsTest(unittest.TestCase):
    def test_all_kinds_have_something_in_their_outline_to_see(self):
        for name, kind in KINDS.items():
            for seed in SEEDS:
                with self.subTest(name, seed=seed):
                    plan = kind.draw(np.random.default_rng(seed))
                    low, high = np.array(floor_plan.corners_of(plan.outline)).min(axis=0), np.array(
                        floor_plan.corners_of(plan.outline)).max(axis=0)
                    self.assertTrue((high - low > 8).all() and (high - low < 95).all())
                    self.assertGreater(len(plan.walls) + len(plan.discs), 4)
                    for wall in plan.walls:
                        x, y = (wall[0] + wall[2]) / 2, (wall[1] + wall[3]) / 2
                        self.assertTrue(low[0] <= x <= high[0] and low[1] <= y <= high[1])

    def test_all_kinds_say_what_they_are(self):
        self.assertEqual(list(KINDS), ["office", "corridors", "hall", "yard"])
        for kind in KINDS.values():
            self.assertGreater(len(kind.meaning.split()), 5)

    def test_the_seed_decides(self):
        for kind in KINDS.values():
            first, again, other = (kind.draw(np.random.default_rng(seed)) for seed in (1, 1, 2))
            self.assertEqual(first, again)
            self.assertNotEqual(first, other)

    def test_doors_of_corridors_are_at_regular_distances(self):
        for seed in SEEDS:
            plan = building_kinds.corridors(np.random.default_rng(seed))
            walls = [w for w in plan.walls if 0.09 < w[4] < 0.11 and w[2] - w[0] < 4]  # no door
            y = max((w[1] for w in walls), key=[w[1] for w in walls].count)
            row = [w for w in walls if w[1] == y]
            doors = sorted({round(w[0], 6) for w in row
                            if any(abs(w[0] - 1.5 - other[2]) < 1e-9 for other in row)})
            self.assertGreater(len(doors), 7)
            np.testing.assert_allclose(np.diff(doors, n=2), 0, atol=1e-5)

    def test_a_yard_has_no_walls_around(self):
        plan = building_kinds.yard(np.random.default_rng(1))
        self.assertLess(max(np.hypot(w[2] - w[0], w[3] - w[1]) for w in plan.walls), 14.1)


if __name__ == "__main__":
    unittest.main()
