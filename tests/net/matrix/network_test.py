#!/usr/bin/env python3
"""Tests that each limit of the network code can be exceeded, and fails the run then, without servers and bots."""

import contextlib
import io
import unittest

from cells import FULL, Cell
from gates import GATES, WITHOUT_PLAYERS, failures, judge
from processes import Failure, exit_code_of

GOOD = {
    "failed": 0, "connectMs": 30, "downBytesPerSecond": 1700, "upBytesPerSecond": 1200, "mispredictedPer1000Ticks": 0,
    "missedInputsPer1000Ticks": 0, "hashMismatches": 0, "resyncs": 0, "resumes": 0, "longestDatagramBytes": 1180,
    "cpuPercent": 0.5, "memoryBytes": 9e6, "p99Us": 300, "roundOver": 0,
}  # fmt: skip
EMPTY = {"startMs": 9, "idlePercent": 0.02, "leftPercent": 0.03}


def result(cell, **changes):
    return GOOD | {"cell": cell} | changes


def exceeded(cell, empty=None, timings=True, **changes):
    return failures(judge([result(cell, **changes)], empty or EMPTY, timings))


class Gates(unittest.TestCase):
    def assert_just_fails(self, cell, key, most, step=0.001, timings=True):
        self.assertEqual(exceeded(cell, timings=timings, **{key: most}), [], key)
        found = exceeded(cell, timings=timings, **{key: most + step})
        self.assertEqual(len(found), 1, f"{key}: {found}")
        self.assertIn(cell.name, found[0])

    def test_each_limit_in_cells_to_which_it_applies(self):
        cell = Cell()
        self.assert_just_fails(cell, "downBytesPerSecond", 3000)
        for players in (4, 64, 256):
            self.assert_just_fails(Cell(players=players), "downBytesPerSecond", 6000)
        self.assert_just_fails(cell, "upBytesPerSecond", 1500)
        self.assert_just_fails(cell, "longestDatagramBytes", 1200, 1)
        self.assert_just_fails(Cell(10, 200, 100), "missedInputsPer1000Ticks", 1)
        self.assert_just_fails(Cell(2, 50, 20), "mispredictedPer1000Ticks", 5)
        for key in ("hashMismatches", "resyncs", "failed", "roundOver"):
            self.assert_just_fails(Cell(20, 200, 100), key, 0, 1)
        self.assert_just_fails(Cell(10, 200, 100), "resumes", 0, 1)
        self.assert_just_fails(cell, "connectMs", 300)
        self.assert_just_fails(Cell(0, 50, 20), "connectMs", 700 + 2000 / 60)
        self.assert_just_fails(cell, "cpuPercent", 1)
        self.assert_just_fails(Cell(players=64), "cpuPercent", 3)
        self.assert_just_fails(Cell(players=256), "cpuPercent", 10)
        self.assert_just_fails(Cell(players=256), "p99Us", 4000, 1)
        self.assert_just_fails(cell, "memoryBytes", 16e6, 1)

    def test_servers_without_players(self):
        for key, most in (("idlePercent", 0.1), ("leftPercent", 0.1), ("startMs", 20)):
            self.assertEqual(exceeded(Cell(), EMPTY | {key: most}), [])
            self.assertEqual(len(exceeded(Cell(), EMPTY | {key: most + 0.01})), 1, key)

    def test_timings_are_judged_only_on_request(self):
        slow = {"connectMs": 9000, "cpuPercent": 90, "p99Us": 90000, "memoryBytes": 1e9, "mispredictedPer1000Ticks": 900}
        self.assertEqual(exceeded(Cell(2, 50, 0), EMPTY | {"startMs": 900}, timings=False, **slow), [])
        self.assert_just_fails(Cell(), "downBytesPerSecond", 3000, timings=False)

    def test_the_full_run_has_a_cell_for_every_gate(self):
        everything = FULL.together + FULL.alone
        for gate in GATES:
            self.assertTrue(any(gate.applies(cell) for cell in everything), gate.what)
        self.assertGreater(FULL.starts, 0)
        self.assertEqual(len(WITHOUT_PLAYERS), 3)


class ExitCodes(unittest.TestCase):
    def test_a_limit_that_is_exceeded_and_a_program_that_fails_give_1(self):
        def fail():
            raise Failure("platon-server did not start")

        with contextlib.redirect_stdout(io.StringIO()):
            self.assertEqual([exit_code_of(run) for run in (lambda: [], lambda: ["up"], fail)], [0, 1, 1])


if __name__ == "__main__":
    unittest.main()
