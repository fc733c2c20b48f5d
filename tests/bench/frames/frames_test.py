#!/usr/bin/env python3
"""Checks the limits of ./platon bench --frames."""

import unittest

from frames import exceeded


def report(p50=(5, 8, 12, 30), own=0.5, default="high"):
    names = ["low", "medium", "high", "all"]
    return {"default": default, "frames": [{"quality": name, "p50Ms": ms, "ownCpuMs": own} for name, ms in zip(names, p50)]}


class FramesTest(unittest.TestCase):
    def test_within_the_limits_nothing_is_exceeded(self):
        self.assertEqual(exceeded(report()), [])
        self.assertEqual(exceeded(report(p50=(16, 17, 18, 33), default="low")), [])

    def test_the_default_holds_60_pictures_a_second(self):
        self.assertEqual(exceeded(report(p50=(17, 18, 19, 30), default="low")), ["p50Ms of low is 17.00, over 16.7"])

    def test_everything_on_holds_30_pictures_a_second(self):
        self.assertEqual(exceeded(report(p50=(5, 8, 12, 34))), ["p50Ms of all is 34.00, over 33.3"])

    def test_the_program_itself_takes_at_most_a_millisecond(self):
        lines = [f"ownCpuMs of {name} is 1.10, over 1.0" for name in ("low", "medium", "high", "all")]
        self.assertEqual(exceeded(report(own=1.1)), lines)


if __name__ == "__main__":
    unittest.main()
