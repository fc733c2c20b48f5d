#!/usr/bin/env python3
"""Builds the simulation with deliberate faults, one at a time, and demands that a test fails by each.

usage: mutate.py [--list] [--check] [--all] [--only NAME]… [--build DIR] [ROOT]

--list        prints the faults and stops.
--check       only makes sure that the faults fit the tree: the original text of each occurs once, its test is there.
--all         all faults, not only the usual ones; so does the environment variable PLATON_LONG.
--only NAME   this fault alone; may be repeated.
--build DIR   where the tree is built, up to date and by Ninja; default: build/release. Nothing is written there.

ROOT is the tree, by default the one that this file is in. The file that has the fault is compiled by the commands of
the build, and linked into the program of the test that must catch it. Exit 1 when a fault survives, does not compile
or does not fit, or when a test fails without any fault; 2 on wrong usage or without such a build.
"""

import argparse
import os
import re
import resource
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from faults import FAULTS
from ninja_build import BuildError, NinjaBuild

LEAST_FAULTS = 20
TEST_SECONDS = 60
TEST_BYTES = 4 << 30


def programs_of_tests(root):
    """Of each Suite.Test the program that has it, which is called as its file."""
    programs = {}
    for path in sorted((root / "tests").rglob("*_test.cpp")):
        for suite, test in re.findall(r"TEST(?:_[FP])?\((\w+),\s*(\w+)\)", path.read_text(encoding="utf-8")):
            programs[f"{suite}.{test}"] = path.stem
    return programs


def misfits(root):
    """What is wrong with the list of faults itself, in words."""
    names = [fault.name for fault in FAULTS]
    usual = sum(fault.usual for fault in FAULTS)
    if usual < LEAST_FAULTS:
        yield f"{usual} usual faults are fewer than {LEAST_FAULTS}"
    yield from (f"{name}: this name is there twice" for name in sorted(set(names)) if names.count(name) > 1)
    programs = programs_of_tests(root)
    for fault in FAULTS:
        path = root / fault.file
        found = path.read_text(encoding="utf-8").count(fault.original) if path.is_file() else 0
        if found != 1:
            yield f"{fault.name}: its text occurs {found} times in {fault.file}, not once:\n    {fault.original}"
        if fault.original == fault.replaced:
            yield f"{fault.name}: changes nothing"
        if fault.test not in programs:
            yield f"{fault.name}: there is no test {fault.test}"


class Trial:
    """Runs the test of a fault, out of the build and with the fault."""

    def __init__(self, build, root):
        self._build = build
        self._root = root
        self._programs = programs_of_tests(root)

    def require_sound(self, faults):
        """A test that fails without any fault would seem to catch all of them."""
        tests = sorted({(self._programs[fault.test], fault.test) for fault in faults})
        for program in sorted({program for program, _ in tests}):
            self._build.require_up_to_date(program)
        for program, test in tests:
            failure = self._failure(self._build.executable(program), test)
            if failure:
                raise RuntimeError(f"{program} {test}, without any fault: {failure}")

    def outcome(self, fault):
        """How the test fails by the fault, in words, or None when it passes; and whether it was built at all."""
        with tempfile.TemporaryDirectory(prefix="platon-mutation-") as directory:
            overlay = Path(directory)
            broken = overlay / fault.file
            broken.parent.mkdir(parents=True)
            sound = (self._root / fault.file).read_text(encoding="utf-8")
            broken.write_text(sound.replace(fault.original, fault.replaced), encoding="utf-8")
            program = self._build.with_overlay(self._programs[fault.test], fault.file, overlay)
            return (self._failure(program, fault.test), True) if program else (None, False)

    def _failure(self, program, test):
        environment = {name: value for name, value in os.environ.items() if name != "PLATON_LONG"}
        command = [program, f"--gtest_filter={test}:*/{test}/*", "--gtest_brief=1"]
        try:
            result = subprocess.run(
                command,
                cwd=self._root,
                env=environment,
                stdout=subprocess.PIPE,
                stderr=subprocess.STDOUT,
                timeout=TEST_SECONDS,
                preexec_fn=limit_memory,
            )
        except subprocess.TimeoutExpired:
            return f"hangs for {TEST_SECONDS} s"
        if result.returncode < 0:
            return f"dies by signal {-result.returncode}"
        if b"Running 0 tests" in result.stdout:
            return "is no test of this program"
        return "fails" if result.returncode != 0 else None


def limit_memory():
    """A fault may ask for memory without end."""
    resource.setrlimit(resource.RLIMIT_AS, (TEST_BYTES, TEST_BYTES))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))


def run(trial, faults):
    """Prints the table; returns how many faults were not caught."""
    trial.require_sound(faults)
    left = 0
    for fault in faults:
        start = time.monotonic()
        failure, built = trial.outcome(fault)
        left += failure is None
        verdict = f"{fault.test} {failure}" if failure else "SURVIVES" if built else "DOES NOT COMPILE"
        print(f"{fault.name:32} {verdict:72} {time.monotonic() - start:5.1f} s", flush=True)
    print(f"{len(faults) - left} of {len(faults)} faults are caught")
    return left


def chosen(names, everything):
    known = {fault.name: fault for fault in FAULTS}
    unknown = [name for name in names if name not in known]
    if unknown:
        raise ValueError(f"no fault is called {', '.join(unknown)}; --list names them")
    return [known[name] for name in names] or [fault for fault in FAULTS if fault.usual or everything]


def parse(arguments):
    parser = argparse.ArgumentParser(usage=__doc__.split("usage: ")[1].split("\n")[0])
    parser.add_argument("--list", action="store_true")
    parser.add_argument("--check", action="store_true")
    parser.add_argument("--all", action="store_true")
    parser.add_argument("--only", action="append", default=[])
    parser.add_argument("--build", type=Path)
    parser.add_argument("root", nargs="?", type=Path, default=Path(__file__).resolve().parents[2])
    return parser.parse_args(arguments)


def main(arguments):
    options = parse(arguments)
    faults = chosen(options.only, options.all or "PLATON_LONG" in os.environ)
    if options.list:
        for fault in FAULTS:
            print(f"{fault.name:32} {fault.breaks} ({fault.file}; {fault.test}{'' if fault.usual else '; at length'})")
        return 0
    wrong = list(misfits(options.root))
    if wrong or options.check:
        print("\n".join(wrong + [f"{len(FAULTS)} faults, {len(wrong)} misfits"]))
        return 1 if wrong else 0
    build = NinjaBuild(options.build or options.root / "build" / "release", options.root)
    return 1 if run(Trial(build, options.root), faults) else 0


if __name__ == "__main__":
    try:
        sys.exit(main(sys.argv[1:]))
    except RuntimeError as error:
        print(error, file=sys.stderr)
        sys.exit(1)
    except (BuildError, ValueError) as error:
        print(error, file=sys.stderr)
        sys.exit(2)
