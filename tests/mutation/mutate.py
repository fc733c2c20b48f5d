#!/usr/bin/env python3
"""Builds programs with deliberate faults, one at a time. Each must make its test fail.

usage: mutate.py [--list] [--check] [--all] [--only NAME]… [--shard K/N] [--build DIR] [ROOT]

--list        print the faults and exit.
--check       only check the list: the original text of each fault occurs once, and its test exists.
--all         try all faults, not only the usual ones. The environment variable PLATON_LONG does the same.
--only NAME   try only this fault; may be repeated.
--shard K/N   try only every Nth fault, starting with the Kth; K counts from 1.
--build DIR   an up-to-date Ninja build of the tree, by default build/release. Nothing is written there.

ROOT is the tree, by default the one of this file. The files that depend on the changed one are compiled with the commands
of the build, but at -O1, and linked into the test program that must catch the fault. Exit 1 if a fault survives, does not
compile or does not fit the tree, or if a test fails without a fault; 2 on wrong usage or without such a build.
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

MIN_USUAL_FAULTS = 50
TEST_SECONDS = 60
TEST_BYTES = 4 << 30


def programs_of_tests(root):
    """{Suite.Test: program}. A program has the name of its source file."""
    programs = {}
    for path in sorted((root / "tests").rglob("*_test.cpp")):
        for suite, test in re.findall(r"TEST(?:_[FP])?\((\w+),\s*(\w+)\)", path.read_text(encoding="utf-8")):
            programs[f"{suite}.{test}"] = path.stem
    return programs


def misfits(root):
    """Yields a sentence for each error in the list of faults."""
    names = [fault.name for fault in FAULTS]
    usual = sum(fault.usual for fault in FAULTS)
    if usual < MIN_USUAL_FAULTS:
        yield f"{usual} usual faults, fewer than {MIN_USUAL_FAULTS}"
    yield from (f"{name}: two faults have this name" for name in sorted(set(names)) if names.count(name) > 1)
    programs = programs_of_tests(root)
    for fault in FAULTS:
        path = root / fault.file
        found = path.read_text(encoding="utf-8").count(fault.original) if path.is_file() else 0
        if found != 1:
            yield f"{fault.name}: its original text occurs {found} times in {fault.file}, not once:\n    {fault.original}"
        if fault.original == fault.replaced:
            yield f"{fault.name}: changes nothing"
        if fault.test not in programs:
            yield f"{fault.name}: no test is called {fault.test}"


class Trial:
    """Runs the test of a fault with and without the fault."""

    def __init__(self, build, root):
        self._build = build
        self._root = root
        self._programs = programs_of_tests(root)

    def require_sound(self, faults):
        """Raises RuntimeError if a test fails without a fault: it would seem to catch every fault."""
        tests = sorted({(self._programs[fault.test], fault.test) for fault in faults})
        for program in sorted({program for program, _ in tests}):
            self._build.require_up_to_date(program)
        for program, test in tests:
            failure = self._failure(self._build.executable(program), test)
            if failure:
                raise RuntimeError(f"{program} {test} {failure} without a fault")

    def outcome(self, fault):
        """(how the test fails, or None if it passes; whether the program was built)"""
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
            return f"runs longer than {TEST_SECONDS} s"
        if result.returncode < 0:
            return f"is killed by signal {-result.returncode}"
        if b"Running 0 tests" in result.stdout:
            return "is not a test of this program"
        return "fails" if result.returncode != 0 else None


def limit_memory():
    """A fault may allocate memory without end."""
    resource.setrlimit(resource.RLIMIT_AS, (TEST_BYTES, TEST_BYTES))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))


def run(trial, faults):
    """Prints a line for each fault; returns the number of faults that were not caught."""
    trial.require_sound(faults)
    survivors = 0
    for fault in faults:
        start = time.monotonic()
        failure, built = trial.outcome(fault)
        survivors += failure is None
        verdict = f"{fault.test} {failure}" if failure else "SURVIVES" if built else "DOES NOT COMPILE"
        print(f"{fault.name:32} {verdict:72} {time.monotonic() - start:5.1f} s", flush=True)
    print(f"{len(faults) - survivors} of {len(faults)} faults are caught")
    return survivors


def shard_of(text):
    """(K, N) of --shard K/N."""
    match = re.fullmatch(r"([1-9]\d*)/([1-9]\d*)", text)
    if match is None or int(match[1]) > int(match[2]):
        raise argparse.ArgumentTypeError(f"'{text}' is not a shard K/N with 1 <= K <= N")
    return int(match[1]), int(match[2])


def chosen(names, everything):
    known = {fault.name: fault for fault in FAULTS}
    unknown = [name for name in names if name not in known]
    if unknown:
        raise ValueError(f"no fault is called {', '.join(unknown)}; --list prints the names")
    return [known[name] for name in names] or [fault for fault in FAULTS if fault.usual or everything]


def parse(arguments):
    parser = argparse.ArgumentParser(usage=__doc__.split("usage: ")[1].split("\n")[0])
    parser.add_argument("--list", action="store_true")
    parser.add_argument("--check", action="store_true")
    parser.add_argument("--all", action="store_true")
    parser.add_argument("--only", action="append", default=[])
    parser.add_argument("--shard", type=shard_of, default=(1, 1))
    parser.add_argument("--build", type=Path)
    parser.add_argument("root", nargs="?", type=Path, default=Path(__file__).resolve().parents[2])
    return parser.parse_args(arguments)


def main(arguments):
    options = parse(arguments)
    first, step = options.shard
    faults = chosen(options.only, options.all or "PLATON_LONG" in os.environ)[first - 1 :: step]
    if options.list:
        for fault in FAULTS:
            print(f"{fault.name:32} {fault.breaks} ({fault.file}; {fault.test}{'' if fault.usual else '; with --all'})")
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
