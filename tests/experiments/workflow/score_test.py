# SPDX-License-Identifier: BSD-3-Clause
"""Scores: what evaluate_map prints becomes the metrics of a run."""
import unittest

import workflow_test_case  # noqa: F401: finds the workflow

import score
from metrics import METRICS

PRINTED = {
    "broken": True,
    "walls": {"in_sight": 40, "in_sight_m": 90.0, "missing": 4, "broken": 10, "gaps": 13,
              "gaps_m": 5.0, "doubled": 2, "doubled_m": 3.5},
    "ghost_walls": {"number": 6, "length_m": 7.5},
    "corners": {"in_sight": 50, "found": 45, "false": 3},
}
OBSTACLES = [
    {"surface_m": 6.0, "there": True, "complete": 1.0, "width_m": 0.05},
    {"surface_m": 0.6, "there": False, "complete": 0.25, "width_m": None},
    {"surface_m": 0.0, "there": False, "complete": None, "width_m": None},
]


class ScoreTest(unittest.TestCase):
    def test_counts_of_walls_and_corners_are_shares_of_those_in_sight(self):
        scores = score.flaws_of_map(PRINTED)
        self.assertEqual(scores, {
            "map_broken": 1.0, "map_ghost_walls": 6, "map_ghost_walls_m": 7.5,
            "map_doubled_walls_m": 3.5, "map_missing_walls": 0.1, "map_broken_walls": 0.25,
            "map_wall_gaps": 13, "map_corners_found": 0.9, "map_corners_false": 3})
        self.assertLessEqual(scores.keys(), METRICS.keys())

    def test_where_nothing_was_in_sight_there_is_no_share(self):
        nothing = {**PRINTED, "broken": None, "walls": {**PRINTED["walls"], "in_sight": 0},
                   "corners": {"in_sight": 0, "found": 0, "false": 0}}
        scores = score.flaws_of_map(nothing)
        for name in ("map_broken", "map_missing_walls", "map_broken_walls", "map_corners_found"):
            self.assertIsNone(scores[name])

    def test_obstacles_are_means_over_those_in_sight(self):
        scores = score.scores_of_obstacles(OBSTACLES)
        self.assertEqual(scores, {"obstacles_there": 0.5, "obstacles_complete": 0.625,
                                  "obstacles_blur_m": 0.05})
        self.assertLessEqual(scores.keys(), METRICS.keys())

    def test_without_obstacles_they_have_no_score(self):
        self.assertEqual(set(score.scores_of_obstacles([]).values()), {None})


if __name__ == "__main__":
    unittest.main()
