#!/usr/bin/env python3
"""Tests the limits, the cells, repeated attempts and the written page, without servers and bots."""

import contextlib
import io
import unittest

import measured
import page
from cells import CORNERS, FULL, QUICK, Cell
from gates import GATES, WITHOUT_PLAYERS, failures, judge, max_connect_ms, worst
from processes import Failure, exit_code_of
from run_cells import Runner, combined

GOOD = {
    "connected": 16, "failed": 0, "connectMs": 30, "rttMs": 16, "downBytesPerSecond": 1700, "upBytesPerSecond": 1200,
    "correctionsPer1000Ticks": 0, "maxCorrectionSubunits": 1024, "mispredictedPer1000Ticks": 0,
    "missedInputsPer1000Ticks": 0, "hashMismatches": 0, "resyncs": 0, "resumes": 0, "longestDatagramBytes": 1180,
    "cpuPercent": 0.5, "memoryBytes": 9e6, "p50Us": 100, "p99Us": 300, "longestUs": 900, "ticks": 1500, "roundOver": 0,
    "waitPercent": 1, "errors": "",
}  # fmt: skip
EMPTY = {"startMs": 9, "starts": 9, "atOnce": 6, "idlePercent": 0.02, "leftPercent": 0.03}


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
        self.assert_just_fails(cell, "connectMs", 300)
        self.assert_just_fails(cell, "cpuPercent", 1)
        self.assert_just_fails(Cell(players=64), "cpuPercent", 3)
        self.assert_just_fails(Cell(players=256), "cpuPercent", 10)
        self.assert_just_fails(Cell(players=256), "p99Us", 4000, 1)
        self.assert_just_fails(cell, "memoryBytes", 16e6, 1)

    def test_limits_are_ignored_in_other_cells(self):
        self.assertEqual(exceeded(Cell(20), missedInputsPer1000Ticks=500, connectMs=9000), [])
        self.assertEqual(exceeded(Cell(2, 50, 100), mispredictedPer1000Ticks=100), [])
        self.assertEqual(exceeded(Cell(players=128), downBytesPerSecond=9000), [])

    def test_joining_may_take_five_round_trips(self):
        slow = Cell(0, 50, 20)
        self.assertAlmostEqual(max_connect_ms(slow), 700 + 2000 / 60)
        self.assert_just_fails(slow, "connectMs", max_connect_ms(slow))

    def test_the_worst_verdict(self):
        results = [result(Cell(failed), failed=failed) for failed in (0, 1, 3, 2)]
        found = next(found for gate, found in judge(results, EMPTY, True) if gate.key == "failed")
        self.assertEqual(worst(found).value, 3)

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


class Cells(unittest.TestCase):
    def test_options_of_the_conditions(self):
        self.assertEqual(Cell(2, 0, 20).condition_options, ["--loss", "2", "--jitter", "20"])
        self.assertEqual(Cell().condition_options, [])

    def test_processes(self):
        self.assertEqual(Cell(players=64, hollow=56).groups, [(56, True), (8, False)])
        self.assertEqual(Cell().groups, [(16, False)])

    def test_the_matrix(self):
        self.assertEqual(len(set(FULL.together)), 36)
        for plan in (FULL, QUICK, CORNERS):
            for cell in plan.together + plan.alone:
                self.assertGreater(cell.seconds, cell.settle + 3)
                self.assertGreater(cell.players, cell.hollow, "no bot simulates the game")

    def test_hollow_and_playing_bots_are_combined(self):
        hollow = GOOD | {"connected": 48, "hashMismatches": None, "resyncs": None, "downBytesPerSecond": 100, "failed": 1,
                         "longestDatagramBytes": 1199, "missedInputsPer1000Ticks": None}  # fmt: skip
        found = combined([hollow, GOOD | {"failed": 2, "missedInputsPer1000Ticks": 0.5}])
        self.assertEqual((found["connected"], found["failed"], found["longestDatagramBytes"]), (64, 3, 1199))
        self.assertEqual(found["downBytesPerSecond"], (48 * 100 + 16 * 1700) / 64)
        self.assertEqual((found["missedInputsPer1000Ticks"], found["hashMismatches"]), (0.5, 0))

    def test_no_bot_connected(self):
        found = combined([GOOD | {"connected": 0, "failed": 16}])
        self.assertEqual((found["failed"], found["downBytesPerSecond"]), (16, 0))


class Attempts(unittest.TestCase):
    def waits_of(self, *waits):
        """(wait of the result, number of runs)"""
        left = list(waits)
        runner = Runner(None, None, lambda line: None)
        runner._try = lambda cell: result(cell, waitPercent=left.pop(0))
        return runner.cell(Cell())["waitPercent"], len(waits) - len(left)

    def test_a_cell_is_run_again_when_the_machine_was_busy(self):
        self.assertEqual(self.waits_of(30, 0, 0), (30, 1))
        self.assertEqual(self.waits_of(31, 2, 0), (2, 2))
        self.assertEqual(self.waits_of(40, 50, 0), (40, 2))


class Page(unittest.TestCase):
    def section(self, **changes):
        alone = [result(cell) for cell in FULL.alone]
        together = [result(FULL.together[0]), result(FULL.together[1], **changes)]
        return measured.section(together, alone, EMPTY, list(judge(together + alone, EMPTY, True)))

    def test_claims_success_only_without_failures(self):
        self.assertIn("limits are kept.", self.section())
        self.assertNotIn("**no**", self.section())
        text = self.section(upBytesPerSecond=1600)
        self.assertRegex(text, r"1 of \d+ limits are exceeded: up, a player\.")
        self.assertIn("| up, a player | ≤ 1.5 kB/s | 1.60 kB/s (16 players, loss 0 %, delay 50 ms, jitter 0 ms) | **no**", text)
        self.assertNotIn("limits are kept.", text)

    def test_names_the_cells_that_were_disturbed(self):
        self.assertIn("cells that were still disturbed: none.", self.section())
        self.assertIn("cells that were still disturbed: 16 players, loss 0 %, delay 50 ms, jitter 0 ms (39 %).", self.section(waitPercent=39.1))

    def test_peers_are_compared_with_the_numbers_of_the_run(self):
        self.assertIn("| 16 | 1.70 kB/s | 15.7 kB/s (9.2 ×) | 0.50 % | 6.3 % (12.6 ×) |", self.section())

    def test_only_the_part_between_the_marks_is_replaced(self):
        begin = page.begin_of("network")
        text = f"before\n{begin}\nold\n{page.END}\nafter\n"
        once = page.with_part(text, "new")
        self.assertEqual(once, f"before\n{begin}\n\nnew\n\n{page.END}\nafter\n")
        self.assertEqual(page.with_part(once, "new"), once)
        with self.assertRaises(page.PageError):
            page.with_part("no marks", "new")


class ExitCodes(unittest.TestCase):
    def assert_ends(self, run, code, text):
        output = io.StringIO()
        with contextlib.redirect_stdout(output):
            self.assertEqual(exit_code_of(run), code)
        self.assertEqual(output.getvalue(), text)

    def test_a_limit_that_is_exceeded_and_a_program_that_failed_are_told_apart(self):
        def fail():
            raise Failure("platon-server did not start")

        self.assert_ends(lambda: [], 0, "")
        self.assert_ends(lambda: ["up", "down"], 1, "exceeded: up\nexceeded: down\n")
        self.assert_ends(fail, 1, "failed: platon-server did not start\n")


if __name__ == "__main__":
    unittest.main()
