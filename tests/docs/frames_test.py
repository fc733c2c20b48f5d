#!/usr/bin/env python3
"""Tests platon-client --frames, of which the pictures of the docs are made.

usage: frames_test.py PLATON-CLIENT ROOT
"""

import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

LEVEL = "tests/determinism/golden/levels/hexahedron.level"


class Frames(unittest.TestCase):
    client = None
    root = None

    def draw(self, folder, *options):
        command = [self.client, "--offscreen", "--demo", "--level", self.root / LEVEL, "--frames", folder, "--width", "160"]
        return subprocess.run([*command, *options], capture_output=True, text=True)

    def frames(self, *options):
        """The bytes of every frame by file name."""
        with tempfile.TemporaryDirectory() as folder:
            finished = self.draw(folder, *options)
            self.assertEqual(finished.returncode, 0, finished.stderr)
            return {path.name: path.read_bytes() for path in sorted(Path(folder).iterdir())}

    def test_the_same_options_give_the_same_frames(self):
        options = ("--seconds", "1", "--fps", "10", "--from", "1.5", "--players", "2")
        frames = self.frames(*options)
        self.assertEqual(list(frames), [f"{number:04}.png" for number in range(10)])
        self.assertEqual(frames, self.frames(*options))

    def test_the_player_moves(self):
        frames = list(self.frames("--seconds", "0.4", "--fps", "5", "--from", "3").values())
        self.assertEqual(len(frames), 2)
        self.assertNotEqual(frames[0], frames[1])

    def test_from_skips_frames(self):
        with_start = self.frames("--seconds", "1", "--fps", "1", "--from", "0")
        later = self.frames("--seconds", "1", "--fps", "1", "--from", "2")
        self.assertNotEqual(with_start, later)

    def test_a_folder_is_needed(self):
        finished = self.draw(self.root / "no_such_folder")
        self.assertEqual(finished.returncode, 2)
        self.assertIn("no_such_folder", finished.stderr)

    def test_the_demonstration_is_needed(self):
        with tempfile.TemporaryDirectory() as folder:
            command = [self.client, "--offscreen", "--level", self.root / LEVEL, "--frames", folder]
            finished = subprocess.run(command, capture_output=True, text=True)
        self.assertEqual(finished.returncode, 2)
        self.assertIn("--frames needs --offscreen, --demo and --level FILE", finished.stderr)


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    Frames.client, Frames.root = sys.argv[1], Path(sys.argv[2]).resolve()
    unittest.main(argv=sys.argv[:1])
