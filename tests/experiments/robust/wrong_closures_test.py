# SPDX-License-Identifier: BSD-3-Clause
"""Wrong loop closures are as many as asked for, of their kind, and the same for the same seed."""
import unittest

import square_graph

from wrong_closures import add_wrong_closures


class WrongClosuresTest(unittest.TestCase):
    def setUp(self):
        self.clean, truth = square_graph.lines_and_truth()
        self.nodes = len(truth)

    def add(self, policy, count=30, seed=1):
        return add_wrong_closures(self.clean, policy, count, seed)

    def test_they_are_added_behind_the_graph(self):
        for policy in ("random", "local", "grouped"):
            lines, wrong = self.add(policy)
            self.assertEqual(lines[:len(self.clean)], self.clean)
            added = [line.split() for line in lines[len(self.clean):]]
            self.assertEqual(len(added), 30)
            self.assertEqual({(int(w[1]), int(w[2])) for w in added}, wrong)
            for words in added:
                self.assertEqual(" ".join(words[6:]), square_graph.INFORMATION)
                self.assertGreater(abs(int(words[1]) - int(words[2])), 1)
                self.assertLess(max(int(words[1]), int(words[2])), self.nodes)

    def test_local_ones_are_at_most_20_steps_long(self):
        _, wrong = self.add("local")
        self.assertLessEqual(max(abs(i - j) for i, j in wrong), 20)

    def test_grouped_ones_come_in_tens_that_agree(self):
        lines, _ = self.add("grouped")
        added = [[float(word) for word in line.split()[1:6]] for line in lines[len(self.clean):]]
        for first in range(0, 30, 10):
            group = added[first:first + 10]
            for k, (i, j, x, y, theta) in enumerate(group):
                self.assertEqual((i - k, j - k), tuple(group[0][:2]))
                self.assertLess(max(abs(x - group[0][2]), abs(y - group[0][3])), 0.2)

    def test_the_seed_decides(self):
        self.assertEqual(self.add("random", seed=3), self.add("random", seed=3))
        self.assertNotEqual(self.add("random", seed=3)[1], self.add("random", seed=4)[1])


if __name__ == "__main__":
    unittest.main()
