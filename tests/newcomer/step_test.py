#!/usr/bin/env python3
"""Tests step.py, and what it runs: platon-client --offscreen --step.

usage: step_test.py PLATON-CLIENT
"""

import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

STEP = Path(__file__).with_name("step.py")


class Step(unittest.TestCase):
    client = None

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        self.player = self.folder / ("long" * 30) / "player"  # a socket cannot have this path

    def step(self, *arguments):
        return subprocess.run([sys.executable, "-B", STEP, *arguments], capture_output=True, text=True, cwd=self.folder)

    def start(self):
        started = self.step("start", self.player, self.client, "--width", "480")
        self.assertEqual((started.returncode, started.stdout), (0, "ok\n"), started.stderr)
        self.addCleanup(self.step, "stop", self.player)

    def do(self, *commands):
        done = self.step("do", self.player, *commands)
        return done.returncode, done.stdout.splitlines()

    def picture(self, name):
        return (self.folder / name).read_bytes()

    def test_plays_the_first_level_over_several_calls(self):
        self.start()
        self.assertEqual(self.do("wait 1", "shot title.png", "tap enter", "wait 3", "shot start.png", "press d")[0], 0)
        self.assertEqual(self.do("shot same.png", "wait 0.5", "shot later.png", "release d")[0], 0)
        self.assertNotEqual(self.picture("title.png"), self.picture("start.png"))
        self.assertEqual(self.picture("start.png"), self.picture("same.png"), "the game goes on between calls")
        self.assertNotEqual(self.picture("same.png"), self.picture("later.png"))

    def test_a_wrong_command_loses_nothing(self):
        self.start()
        code, answers = self.do("wait 1", "jump", "wait 1")
        self.assertEqual(code, 1)
        self.assertEqual((answers[0], answers[2]), ("wait 1: ok 1.02", "wait 1: ok 2.02"))
        self.assertIn("error: 'jump' is no command: give press KEY", answers[1])

    def test_keeps_what_the_player_has_chosen_in_its_folder(self):
        self.start()
        self.do("tap f11", "wait 2")
        self.assertEqual(self.step("stop", self.player).returncode, 0)
        self.assertIn("fullscreen on", (self.player / "config/platon/settings").read_text())

    def test_tells_that_no_game_runs_or_that_one_does(self):
        self.player.mkdir(parents=True)
        none = self.step("do", self.player, "wait 1")
        self.assertEqual(none.returncode, 1)
        self.assertIn("start one with: step.py start", none.stderr)
        self.start()
        again = self.step("start", self.player, self.client)
        self.assertEqual(again.returncode, 1)
        self.assertIn("end it with: step.py stop", again.stderr)

    def test_tells_why_the_game_does_not_start(self):
        failed = self.step("start", self.player, self.client, "--level", "/no/such.level", "--demos")
        self.assertEqual(failed.returncode, 1)
        self.assertIn("--demos", failed.stderr)

    def test_the_end_of_the_input_ends_the_game(self):
        command = [self.client, "--offscreen", "--step", "--width", "480"]
        ended = subprocess.run(command, input="wait 0.5\nwait 0.5", capture_output=True, text=True, timeout=60,
                               env=dict(os.environ, HOME=str(self.folder)))
        self.assertEqual((ended.returncode, ended.stdout), (0, "ready\nok 0.52\nok 1.02\n"), ended.stderr)


if __name__ == "__main__":
    Step.client = sys.argv.pop(1)
    unittest.main()
