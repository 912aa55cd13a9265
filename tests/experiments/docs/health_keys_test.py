# SPDX-License-Identifier: BSD-3-Clause
"""The questions tell what every key of a run's health means."""
import pathlib
import re
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[3]
PAGE = ROOT / "experiments" / "docs" / "faq.md"


def keys_in(pattern, *sources):
    """What the first group of the pattern finds in sources of C++."""
    return {key for source in sources for key in re.findall(pattern, source.read_text())}


class HealthKeysTest(unittest.TestCase):
    def test_every_key_has_its_line(self):
        frontend = list((ROOT / "frontend").rglob("*.cc"))
        record = ROOT / "experiments" / "apps" / "health_record.cc"
        check = ROOT / "frontend" / "sensor" / "odometry_check.cc"
        keys = (keys_in(r'(?:Report|Mark)\(\s*"(\w+)"', *frontend)
                | keys_in(r'(?m)(?:^    \{|emplace\()"(\w+)"', record)
                | keys_in(r'\{"(\w+_\w+)", OdometryFault', check))
        rows = [line.split("|")[1] for line in PAGE.read_text().splitlines() if line[:3] == "| `"]
        told = {key for row in rows for key in re.findall(r"`(\w+)`", row)}
        self.assertGreater(len(keys), 30)
        self.assertEqual(keys, told)


if __name__ == "__main__":
    unittest.main()
