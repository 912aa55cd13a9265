# SPDX-License-Identifier: BSD-3-Clause
"""Relations stay true in a stressed log: moved on, turned round, or left out."""
import unittest

import numpy as np
import stress_test_case
from stress_test_case import SCANS, pose_of

import carmen
import poses
import relations


def true_relation(i, j):
    i_T_j = poses.between(np.array(pose_of(i)), np.array(pose_of(j)))
    return relations.Relation(relations.key(1000 + 0.1 * i), relations.key(1000 + 0.1 * j), i_T_j)


class RelationsTest(stress_test_case.StressTestCase):
    def setUp(self):
        super().setUp()
        named = range(0, SCANS, 5)
        self.chain = [true_relation(i, j) for i, j in zip(named, named[1:])]
        self.far = [true_relation(10, 250), true_relation(205, 15)]

    def poses_by_stamp(self, log):
        """True poses: those of the scans that were read."""
        return {relations.key(s.stamp_s): np.array(pose_of(round((s.source_stamp_s - 1000) * 10)))
                for s in log.scans()}

    def assert_true(self, followed, log):
        at = self.poses_by_stamp(log)
        for r in followed:
            np.testing.assert_allclose(r.i_T_j, poses.between(at[r.i], at[r.j]), atol=1e-9)

    def test_what_is_written_is_read(self):
        relations.write(self.far, self.folder / "r.relations.gz")
        [first, second] = relations.read(self.folder / "r.relations.gz")
        self.assertEqual((first.i, second.j), ("1001.000000", "1001.500000"))
        np.testing.assert_allclose(first.i_T_j, self.far[0].i_T_j, atol=1e-6)

    def test_all_of_an_untouched_log_stay(self):
        twice = [*self.chain, *self.far, self.far[0]]
        followed = relations.follow(self.before, twice)
        self.assertEqual([(r.i, r.j) for r in followed], [(r.i, r.j) for r in twice])
        self.assert_true(followed, self.before)

    def test_ends_move_on_to_scans_that_are_left(self):
        self.before.keep([s for k, s in enumerate(self.before.scans()) if k % 10 == 0])
        followed = relations.follow(self.before, [*self.chain, *self.far])
        self.assert_true(followed, self.before)
        pairs = [(r.i, r.j) for r in followed]
        self.assertEqual(len(set(pairs)), len(pairs))
        self.assertEqual(len(pairs), 29 + 2)
        self.assertIn(("1021.000000", "1002.000000"), pairs)

    def test_ends_that_would_move_far_are_left_out(self):
        self.before.keep([s for k, s in enumerate(self.before.scans()) if not 6 <= k < 90])
        followed = relations.follow(self.before, [true_relation(10, 250), *self.chain])
        self.assertNotIn("1025.000000", {r.j for r in followed if float(r.i) < 1010})
        self.assert_true(followed, self.before)

    def test_a_scan_without_a_way_on_loses_its_relations(self):
        self.before.keep(self.before.scans()[:200])
        self.assertEqual(relations.follow(self.before, self.far[:1]), [])

    def test_backwards_in_time_the_earlier_scan_comes_first(self):
        log = self.stressed("reverse")
        followed = relations.follow(log, [*self.chain, *self.far[:1]])
        self.assertEqual(len(followed), len(self.chain) + 1)
        self.assertTrue(all(float(r.i) < float(r.j) for r in followed))
        self.assert_true(followed, log)

    def test_scans_that_are_named_are_marked(self):
        relations.mark(self.before, self.far)
        self.assertEqual([k for k, s in enumerate(self.before.scans()) if s.is_in_relation],
                         [10, 15, 205, 250])

    def test_bad_lines_are_named(self):
        (self.folder / "r").write_text("# t1 t2\n1 2 3\n")
        with self.assertRaisesRegex(carmen.LogError, r"r:2: expected t1 t2 x y z.*found '1 2 3'"):
            relations.read(self.folder / "r")


if __name__ == "__main__":
    unittest.main()
