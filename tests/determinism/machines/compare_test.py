#!/usr/bin/env python3
"""Tests the comparison with a stand-in for platon-sim, which prints what the recording file contains."""

import contextlib
import io
import json
import os
import shutil
import sys
import tempfile
import unittest
from pathlib import Path
from unittest import mock

import compare
from machine import MACHINES, ROOT, Machine, MachineError, package_of

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
        self.assertRegex(text, r"\| r0 \| 7 \| a{16} \| \d+\.\d s \| \d+\.\d s \|")
        self.assertIn("[4/4] ", text)

    def test_a_different_hash(self):
        code, text = self.compared({"one": self.gives("a" * 16), "two": self.gives("a" * 16), "odd": self.gives("c" * 16)})
        self.assertEqual(code, 1)
        self.assertIn("odd differs on r0: cccccccccccccccc after 7 ticks, where most machines have aaaaaaaaaaaaaaaa", text)
        self.assertRegex(text, r"\| r0 \| 7 \| a{16} \|[^|]* s \|[^|]* s \| c{16} [\d.]+ s \|")

    def test_a_run_that_differs_from_the_recording(self):
        differs = ('{"ticks":7,"hash":"aaaaaaaaaaaaaaaa"} tick 5, entity 0, position', 1)
        code, text = self.compared({"one": self.gives("a" * 16), "odd": differs})
        self.assertEqual(code, 1)
        self.assertIn("odd differs from the recording (exit code 1) on r0; platon-sim printed: " + differs[0], text)
        self.assertEqual(self.compared({"only": self.gives("a" * 16, code=1)})[0], 1)

    def test_other_failures(self):
        for printed, sentence in (
            (("broken", 3), "odd finds the recording damaged (exit code 3) on r0; platon-sim printed: broken"),
            (("", 99), "odd fails (exit code 99) on r0; platon-sim printed: nothing"),
            (("hello", 0), "odd gave no hash on r0; platon-sim printed: hello"),
            (("[]", 0), "odd gave no hash on r0; platon-sim printed: []"),
        ):
            code, text = self.compared({"odd": printed, "one": self.gives("a" * 16)})
            self.assertEqual(code, 1, text)
            self.assertIn(sentence, text)

    def test_nothing_to_compare_is_a_failure(self):
        code, text = self.compared()
        self.assertEqual(code, 1)
        self.assertIn("nothing to compare", text)


class Cases(unittest.TestCase):
    def test_one_level_of_each_solid(self):
        cases = compare.cases_of(compare.parsed(["--ticks", "9", "--seed", "4"]))
        self.assertEqual(len(cases), 5)
        for name, arguments in cases:
            self.assertEqual(arguments[0], "run")
            self.assertEqual(arguments[1], ROOT / f"tests/determinism/golden/levels/{name}.level")
            self.assertTrue(arguments[1].exists())
            self.assertEqual(arguments[2:], ["--players", 8, "--ticks", 9, "--seed", 4, "--drive", "play", "--json"])

    def test_unknown_machine(self):
        with self.assertRaises(SystemExit) as stop, contextlib.redirect_stderr(io.StringIO()) as stderr:
            compare.parsed(["vax"])
        self.assertEqual(stop.exception.code, 2)
        self.assertIn("no machine 'vax'", stderr.getvalue())


class Needs(unittest.TestCase):
    def test_every_need_has_a_package(self):
        for machine in MACHINES.values():
            for probe in machine.needs:
                self.assertTrue(package_of(probe), probe)

    def test_missing_tools_are_named_with_their_packages(self):
        with mock.patch.dict(os.environ, {"PATH": ""}), self.assertRaises(MachineError) as reason:
            MACHINES["s390x"].build("nowhere", 1, "")
        self.assertIn("s390x-linux-gnu-g++, qemu-s390x", str(reason.exception))
        self.assertIn("g++-s390x-linux-gnu qemu-user", str(reason.exception))

    def test_a_failing_build_shows_its_output(self):
        broken = Machine("broken", "", (), ("-DCMAKE_CXX_COMPILER=no-such-compiler",))
        folder = tempfile.mkdtemp(prefix="platon-machines-")
        self.addCleanup(shutil.rmtree, folder)
        with self.assertRaisesRegex(MachineError, "(?s)broken: configure failed:.*no-such-compiler"):
            broken.build(folder, 1, "")


if __name__ == "__main__":
    unittest.main()
