#!/usr/bin/env python3
"""Tests that the comparison can fail, with a stand-in for platon-sim, which prints what the recording file contains."""

import contextlib
import io
import json
import shutil
import sys
import tempfile
import unittest
from pathlib import Path

import compare
from machine import Machine

STAND_IN = """
import json, sys
from pathlib import Path
program, command, file = sys.argv[1:4]
text, code = json.loads(Path(file).read_text())[Path(program).parents[1].name]
print(text)
sys.exit(code)
"""


class StandIn(Machine):
    def build(self, builds, jobs, launcher):
        pass


class Comparison(unittest.TestCase):
    def setUp(self):
        self.folder = Path(tempfile.mkdtemp(prefix="platon-machines-"))
        self.addCleanup(shutil.rmtree, self.folder)
        (self.folder / "stand_in.py").write_text(STAND_IN, encoding="utf-8")

    def compared(self, *recordings):
        """(exit code, output) for recordings given as {machine: (output of platon-sim, its exit code)}."""
        for number, printed in enumerate(recordings):
            (self.folder / f"r{number}.recording").write_text(json.dumps(printed), encoding="utf-8")
        names = recordings[0] if recordings else ["one"]
        runner = (sys.executable, str(self.folder / "stand_in.py"))
        machines = [StandIn(name, "", (), (), runner) for name in names]
        options = compare.parsed(["--golden", str(self.folder), "--builds", str(self.folder), "--jobs", "2"])
        out = io.StringIO()
        with contextlib.redirect_stdout(out), contextlib.redirect_stderr(out):
            code = compare.compare(machines, options)
        return code, out.getvalue()

    @staticmethod
    def gives(hash_, code=0):
        return json.dumps({"ticks": 7, "hash": hash_}), code

    def test_equal_hashes(self):
        a, b = self.gives("a" * 16), self.gives("b" * 16)
        code, text = self.compared({"one": a, "two": a}, {"one": b, "two": b})
        self.assertEqual(code, 0, text)
        self.assertIn("2 machines, 2 cases: all hashes are equal", text)

    def test_a_different_hash(self):
        code, text = self.compared({"one": self.gives("a" * 16), "two": self.gives("a" * 16), "odd": self.gives("c" * 16)})
        self.assertEqual(code, 1)
        self.assertIn("odd differs on r0: cccccccccccccccc after 7 ticks, where most machines have aaaaaaaaaaaaaaaa", text)

    def test_a_run_that_fails_or_gives_no_hash(self):
        for printed, sentence in (
            (self.gives("a" * 16, code=1), "odd differs from the recording (exit code 1) on r0"),
            (("", 99), "odd fails (exit code 99) on r0; platon-sim printed: nothing"),
            (("[]", 0), "odd gave no hash on r0; platon-sim printed: []"),
        ):
            code, text = self.compared({"one": self.gives("a" * 16), "odd": printed})
            self.assertEqual(code, 1, text)
            self.assertIn(sentence, text)

    def test_nothing_to_compare_is_a_failure(self):
        code, text = self.compared()
        self.assertEqual(code, 1)
        self.assertIn("nothing to compare", text)


if __name__ == "__main__":
    unittest.main()
