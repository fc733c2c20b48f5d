#!/usr/bin/env python3
"""Tests the script ./platon with stand-ins for cmake, ctest and the package manager, which record how they are called."""

import re
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]

# Each call is a line of $CALLS. The call that contains $FAILING fails.
STAND_IN = """#!/bin/sh
name=${0##*/}
echo "$name $*${PLATON_BRIEF:+, briefly}" >>"$CALLS"
case "$name $*" in *"${FAILING:-no call}"*) failed=1 ;; *) failed=0 ;; esac
case $name in
  ctest) echo "$((100 - failed * 50))% tests passed, $failed tests failed out of 2" ;;
  dpkg-query)
    shift 2
    for package; do [ "$package" = "$FAILING" ] || echo "$package installed"; done
    exit 0
    ;;
esac
[ $failed = 0 ] || exit 8
"""

STAND_INS = ("cmake", "ctest", "dpkg-query", "apt-get")
TOOLS = ("bash", "sh", "basename", "cat", "dirname", "env", "find", "grep", "id", "mktemp", "nproc", "python3", "rm", "sed",
         "tail", "tee")  # fmt: skip


class Script(unittest.TestCase):
    def setUp(self):
        self.folder = Path(tempfile.mkdtemp(prefix="platon-script-"))
        self.addCleanup(shutil.rmtree, self.folder)
        for tool in TOOLS:
            (self.folder / tool).symlink_to(shutil.which(tool))
        for name in STAND_INS:
            (self.folder / name).write_text(STAND_IN, encoding="utf-8")
            (self.folder / name).chmod(0o755)

    def run_platon(self, *arguments, failing="", **variables):
        """(exit code, output, calls of the stand-ins without those that ask for packages)"""
        calls = self.folder / "calls"
        calls.write_text("", encoding="utf-8")
        environment = {"PATH": str(self.folder), "CALLS": str(calls), "HOME": str(self.folder)} | variables
        if failing:
            environment["FAILING"] = failing
        result = subprocess.run([ROOT / "platon", *arguments], env=environment, stdin=subprocess.DEVNULL,
                                stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)  # fmt: skip
        called = [line for line in calls.read_text(encoding="utf-8").splitlines()
                  if line.split(" ")[0] in ("cmake", "ctest", "apt-get")]  # fmt: skip
        return result.returncode, result.stdout, called

    def assert_refused(self, arguments, sentence):
        code, output, called = self.run_platon(*arguments)
        self.assertEqual((code, output), (2, f"platon: {sentence}\n"))
        self.assertEqual(called, [])

    def assert_tests(self, arguments, *expected):
        """The calls after configuring, as regular expressions."""
        code, output, called = self.run_platon("test", *arguments)
        self.assertEqual(code, 0, output)
        self.assertEqual(len(called), len(expected), called)
        for call, pattern in zip(called, expected, strict=True):
            self.assertRegex(call, f"^{pattern}$")


class Usage(Script):
    def test_version_is_that_of_the_project(self):
        version = re.search(r"^project\(platon VERSION ([0-9.]+)", (ROOT / "CMakeLists.txt").read_text(), re.MULTILINE)[1]
        self.assertEqual(self.run_platon("--version"), (0, f"platon {version}\n", []))

    def test_help_names_every_command(self):
        commands = re.findall(r"^    ([a-z]+)\)", (ROOT / "platon").read_text().split("\nmain()")[1], re.MULTILINE)
        self.assertGreaterEqual(len(commands), 5)
        for option in ("help", "-h", "--help"):
            code, output, called = self.run_platon(option)
            self.assertEqual((code, called), (0, []))
            for command in commands:
                self.assertRegex(output, rf"(?m)^  {command}\b")

    def test_help_names_every_option_of_test(self):
        output = self.run_platon("help")[1]
        for option in ("--quick", "--all", "--release", "--fuzz", "--proof", "--machines", "--long", "--debug", "--asan", "--tsan", "--clang"):
            self.assertIn(option, output)

    def test_wrong_usage_is_refused(self):
        code, output, called = self.run_platon()
        self.assertEqual((code, called), (2, []))
        self.assertRegex(output, "^platon: no command given: .*\n$")
        self.assertRegex(self.run_platon("fly")[1], "^platon: no command 'fly': .*\n$")
        self.assertEqual(self.run_platon("fly")[0], 2)
        self.assert_refused(["join"], "join needs an address: ./platon join HOST[:PORT]")
        self.assert_refused(["package", "now"], "package has no options; see ./platon help")
        self.assert_refused(["reference", "pdf"], "reference has no options; see ./platon help")
        self.assert_refused(["bench", "--long"], "bench has no options but --quick, --network, --attacks, --frames and --tests; see ./platon help")
        self.assert_refused(["bench", "--frames", "--quick"], "bench --frames has no option but --write; see ./platon help")
        self.assert_refused(["bench", "--tests", "x"], "bench --tests has no option but --write; see ./platon help")
        self.assert_refused(["bench", "--network", "x"], "bench --network has no option but --quick; see ./platon help")

    def test_files_that_it_names_exist(self):
        text = (ROOT / "platon").read_text() + (ROOT / "tests/test_command.sh").read_text()
        named = re.findall(r"\$root/((?:tests|docs|deploy)/[\w/.]+\.\w+)", text)
        self.assertGreaterEqual(len(named), 4)
        for path in named:
            self.assertTrue((ROOT / path).is_file(), path)


class Packages(Script):
    def test_missing_packages_are_installed(self):
        code, output, called = self.run_platon("test", "--quick", failing="xvfb")
        self.assertEqual(code, 1)  # the stand-in of apt-get, too, fails on xvfb
        self.assertIn("platon: installing xvfb\n", output)
        self.assertIn("platon: apt-get could not install: xvfb\n", output)
        self.assertEqual(called[0], "apt-get update")
        self.assertEqual(called[1], "apt-get install -y --no-install-recommends xvfb")

    def test_without_apt_get_they_are_named(self):
        (self.folder / "apt-get").unlink()
        (self.folder / "cmake").unlink()
        code, output, called = self.run_platon("test")
        self.assertEqual((code, called), (1, []))
        self.assertRegex(output, "^platon: install these and try again: .*tool cmake, .*tool Xvfb.*\n$")


class Box2d3(Script):
    def test_what_is_no_checkout_is_refused(self):
        missing = self.folder / "missing"
        for folder in (missing, self.folder):
            code, output, called = self.run_platon("bench", "--quick", PLATON_BOX2D3=str(folder))
            self.assertEqual((code, called), (2, []))
            self.assertEqual(output, f"platon: PLATON_BOX2D3 names {folder}, which is not a checkout of Box2D 3: name one, or "
                             "unset PLATON_BOX2D3\n")  # fmt: skip

    def test_a_checkout_is_built_apart(self):
        (self.folder / "include/box2d").mkdir(parents=True)
        (self.folder / "include/box2d/id.h").touch()
        code, output, called = self.run_platon("bench", "--quick", failing="--build build/box2d3", PLATON_BOX2D3=str(self.folder))
        self.assertEqual(code, 1, output)  # before it would measure
        self.assertRegex(called[-2], rf"^cmake --fresh .* -DPLATON_BOX2D3={self.folder} -DBOX2D_AVX2=(ON|OFF)$")
        self.assertEqual(called[-1], "cmake --build build/box2d3")


class Tests(Script):
    CONFIGURE = r"cmake --preset release -DBUILD_TESTING=ON -DPLATON_LONG=OFF -DPLATON_FUZZ_SECONDS=0"
    BUILD = "cmake --build --preset release"
    CTEST = r"ctest --preset release --parallel \d+"

    def test_plain_is_the_first_lane_of_all(self):
        self.assert_tests([], self.CONFIGURE, self.BUILD + " --target all_tests", self.CTEST + r" -L \^all\$, briefly")

    def test_a_selection_is_of_all_tests(self):
        self.assert_tests(["-V"], self.CONFIGURE, self.BUILD, self.CTEST + " -V")
        self.assert_tests(["--long"], self.CONFIGURE.replace("LONG=OFF", "LONG=ON"), self.BUILD, self.CTEST)

    def test_options_in_any_order(self):
        long = self.CONFIGURE.replace("LONG=OFF", "LONG=ON")
        for arguments in (["-L", "hard", "--long"], ["--long", "-L", "hard"]):
            self.assert_tests(arguments, long, self.BUILD, self.CTEST + " -L hard")
        asan = [call.replace("release", "asan-ubsan") for call in (self.CONFIGURE, self.BUILD, self.CTEST)]
        self.assert_tests(["-V", "--asan", "-j", "1"], asan[0], asan[1], asan[2] + " -V -j 1")
        for preset in ("debug", "tsan", "clang"):
            calls = [call.replace("release", preset) for call in (self.CONFIGURE, self.BUILD, self.CTEST)]
            self.assert_tests([f"--{preset}"], *calls)

    def test_files_are_built_and_run_alone(self):
        one = (self.CONFIGURE, self.BUILD + " --target game_test", self.CTEST + r" -R \^\(game_test\)\$")
        for name in ("game", "game_test", "game_test.cpp", "tests/shared/game/game_test.cpp", "shared/game/game.cpp"):
            self.assert_tests([name], *one)
        self.assert_tests(["game", "-V", "world"], self.CONFIGURE, self.BUILD + " --target game_test world_test",
                          self.CTEST + r" -V -R \^\(game_test\|world_test\)\$")  # fmt: skip

    def test_quick(self):
        self.assert_tests(["--quick"], self.CONFIGURE, self.BUILD + " --target quick_tests", self.CTEST + r" -L \^quick\$, briefly")

    def test_fuzz(self):
        for arguments, seconds in ((["--fuzz"], 60), (["--fuzz", "5"], 5), (["--fuzz", "-V"], 60)):
            options = " -V" if "-V" in arguments else ""
            self.assert_tests(arguments, self.CONFIGURE.replace("SECONDS=0", f"SECONDS={seconds}"),
                              self.CTEST + r" -L \^fuzz\$" + options)  # fmt: skip

    def test_a_proof_needs_coq(self):
        code, _, called = self.run_platon("test", "--proof", failing="coq")
        self.assertEqual(code, 1)
        self.assertIn("apt-get install -y --no-install-recommends coq", called)

    def test_wrong_options_are_refused(self):
        self.assert_refused(["test", "--lnog"], "test has no option '--lnog', nor has ctest; see ./platon help")
        self.assert_refused(["test", "-L"], "test: ctest's option -L needs a value")
        self.assert_refused(["test", "no_such"], "no test file no_such_test.cpp in tests/; a test without a file of its own "
                            "is run by -R '^NAME$'")  # fmt: skip
        self.assert_refused(["test", "--all", "game"], "test --all runs a fixed set of tests: name no test files with it")
        self.assert_refused(["test", "--release", "--tsan"],
                            "test --release chooses the presets itself: name none with it")  # fmt: skip
        self.assert_refused(["test", "--asan", "--all"], "test --all chooses the presets itself: name none with it")
        self.assert_refused(["test", "--proof", "-V"], "test --proof checks the whole proof: give nothing with it but a seed")
        self.assert_refused(["test", "--fuzz", "--debug"],
                            "test --fuzz builds with clang and sanitizers: name no preset with it")  # fmt: skip

    def test_failures_give_1(self):
        for failing in ("cmake --preset", "cmake --build", "ctest"):
            for arguments in ([], ["--quick"], ["game"]):
                self.assertEqual(self.run_platon("test", *arguments, failing=failing)[0], 1, (failing, arguments))


class Lanes(Script):
    def assert_lanes(self, option, builds, runs):
        code, output, called = self.run_platon("test", option)
        self.assertEqual(code, 0, output)
        self.assertEqual([call for call in called if call.startswith("cmake --build")],
                         [f"cmake --build --preset {build}" for build in builds])  # fmt: skip
        self.assertEqual([re.sub(r" --parallel \d+", "", call) for call in called if call.startswith("ctest")],
                         [f"ctest --preset {run}" for run in runs])  # fmt: skip
        return output

    def test_release_runs_every_test(self):
        self.assert_lanes("--release",
                          ["release", "asan-ubsan --target sanitized_tests", "tsan --target threads_tests"],
                          ["release", "asan-ubsan -L ^sanitized$", "tsan -L ^threads$"])  # fmt: skip

    def test_each_lane_builds_and_runs_its_tests(self):
        output = self.assert_lanes("--all",
                                   ["release --target all_tests", "asan-ubsan --target outside_tests",
                                    "tsan --target threads_tests"],
                                   [f"{run}, briefly" for run in
                                    ("release -L ^all$", "asan-ubsan -L ^outside$", "tsan -L ^threads$")])  # fmt: skip
        lines = output.splitlines()
        for line, lane in zip(lines[-4:-1], ("release", "address-and-undefined", "threads"), strict=True):
            self.assertRegex(line, rf"^lane {lane}: 100% tests passed, 0 tests failed out of 2, in \d+ s$")
        self.assertEqual(lines[-1], "100% tests passed, 0 tests failed out of 6")

    def test_all_lanes_run_when_one_fails(self):
        for failing, lane, summary in (
            ("ctest --preset asan-ubsan", -3, "50% tests passed, 1 tests failed out of 2"),
            ("cmake --build --preset release", -4, "0% tests passed, 1 tests failed out of 1: the build failed"),
            ("cmake --preset tsan", -2, "0% tests passed, 1 tests failed out of 1: the build failed"),
        ):
            code, output, called = self.run_platon("test", "--all", failing=failing)
            lines = output.splitlines()
            self.assertEqual(code, 1)
            self.assertIn(summary, lines[lane])
            self.assertRegex(lines[-1], r"^8[03]% tests passed, 1 tests failed out of [56]$")
            self.assertEqual(sum(call.startswith("cmake --preset") for call in called), 3)


if __name__ == "__main__":
    sys.exit(unittest.main())
