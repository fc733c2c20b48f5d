#!/usr/bin/env python3
"""Tests that each limit of the attacks can be exceeded."""

import sys
import unittest
from pathlib import Path

sys.path.append(str(Path(__file__).resolve().parent.parent / "matrix"))

from attack_run import Result  # noqa: E402
from attack_table import exceeded  # noqa: E402


def result(name="empty", **changes):
    values = dict(sent=200000, dropped=0, answered_ratio=0.0, amplification=None, missed=0.0, disconnected=0, desyncs=0, join=90.0, p50=0.2, p99=1.0,
                  longest=2.0, growth=0, cpu=5.0, wait=0.0)  # fmt: skip
    return Result(attack={"name": name, "does": "nothing", "proves": False, "ipv6": False, "amplifies": False}, **(values | changes))


class AttacksTest(unittest.TestCase):
    def only(self, **changes):
        lines = exceeded([result("none"), result(**changes)])
        self.assertEqual(len(lines), 1, lines)
        return lines[0]

    def test_a_result_within_all_limits_exceeds_none(self):
        at_limits = result(missed=1.0, join=2000.0, p99=8.0, growth=1 << 20, dropped=2000, answered_ratio=1.0, amplification=4.0)
        self.assertEqual(exceeded([result("none"), at_limits]), [])

    def test_each_limit_has_a_sentence(self):
        self.assertEqual(self.only(missed=1.5), "empty: 1.50 missed inputs per 1000 ticks, without an attack 0.00")
        self.assertEqual(self.only(disconnected=1), "empty: 1 players disconnected, 0 desyncs")
        self.assertEqual(self.only(desyncs=2), "empty: 0 players disconnected, 2 desyncs")
        self.assertEqual(self.only(join=None), "empty: a newcomer does not join within 2000 ms")
        self.assertEqual(self.only(join=2001.0), "empty: a newcomer does not join within 2000 ms")
        self.assertEqual(self.only(p99=8.5), "empty: p99 of a tick 8.5 ms, more than 8")
        self.assertEqual(self.only(growth=3 << 20), "empty: memory grew by 3072 KiB")
        self.assertEqual(self.only(dropped=4000), "empty: only 98.0 % reached the server")
        self.assertEqual(self.only(answered_ratio=1.01), "empty: more bytes answered than asked")
        self.assertEqual(self.only(amplification=4.1), "empty: sent back 4.1 times the bytes of the attacker, more than 4")

    def test_without_timings_only_what_holds_on_any_machine_is_checked(self):
        slow = result(missed=9.0, join=None, p99=99.0, growth=9 << 20, dropped=100000)
        self.assertEqual(exceeded([result("none"), slow], timings=False), [])
        self.assertEqual(len(exceeded([result("none"), result(disconnected=1, answered_ratio=2.0)], timings=False)), 2)


if __name__ == "__main__":
    unittest.main()
