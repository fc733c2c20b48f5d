#!/usr/bin/env python3
"""Builds programs with deliberate faults, one at a time. Each must make its test fail.

usage: mutate.py [--list] [--check] [--all] [--only NAME]… [--jobs N] [--build DIR] [ROOT]

--list        print the faults and exit.
--check       only check the list: the original text of each fault occurs once, and its test exists.
--all         try all faults, not only the usual ones. The environment variable PLATON_LONG does the same.
--only NAME   try only this fault; may be repeated.
--jobs N      try so many faults at a time, by default one for each processor.
--build DIR   a build with the preset `faults`, by default build/faults. It is made, or brought up to date.

ROOT is the tree, by default the one of this file. The files that depend on the changed one are compiled with the commands
of the build, and the libraries linked that the test program loads. Exit 1 if a fault survives, does not compile or does
not fit the tree, or if a test fails without a fault; 2 on wrong usage or if the tree does not build.
"""

import argparse
import os
import re
import resource
import subprocess
import sys
import tempfile
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from faults import FAULTS
from shared_build import BuildError, SharedBuild, update

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
        for test in sorted({fault.test for fault in faults}):
            failure = self._failure(self._executable(test), test)
            if failure:
                raise RuntimeError(f"{test} {failure} without a fault")

    def _executable(self, test):
        return self._build.directory / "tests/bin" / self._programs[test]

    def outcome(self, fault):
        """(how the test fails, or None if it passes; whether everything was built)"""
        name = self._programs[fault.test]
        program = self._build.relative(self._executable(fault.test))
        with tempfile.TemporaryDirectory(prefix="platon-mutation-") as directory:
            overlay = Path(directory)
            broken = overlay / fault.file
            broken.parent.mkdir(parents=True)
            sound = (self._root / fault.file).read_text(encoding="utf-8")
            broken.write_text(sound.replace(fault.original, fault.replaced), encoding="utf-8")
            loaded = self._build.libraries_of(program)
            units = [unit for unit in self._build.objects_of(fault.file) if self._build.library_of(unit) in loaded]
            libraries = self._build.changed_libraries(fault.file, overlay, units)
            if libraries is None:
                return None, False
            executable = self._executable(fault.test)
            depends = self._build.depends(program, fault.file)
            if not libraries and not depends:
                raise RuntimeError(f"{fault.name} changes neither a shared library nor its test")
            if depends:
                executable = self._build.link_test(program, name, fault.file, overlay)
            return (self._failure(executable, fault.test, overlay), True) if executable else (None, False)

    def _failure(self, program, test, overlay=None):
        environment = {name: value for name, value in os.environ.items() if name not in ("PLATON_BRIEF", "PLATON_LONG")}
        if overlay:
            environment["LD_LIBRARY_PATH"] = str(overlay)
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


def run(trial, faults, jobs):
    """Prints a line for each fault; returns the number of faults that were not caught."""

    def caught(fault):
        start = time.monotonic()
        failure, built = trial.outcome(fault)
        verdict = f"{fault.test} {failure}" if failure else "SURVIVES" if built else "DOES NOT COMPILE"
        print(f"{fault.name:32} {verdict:72} {time.monotonic() - start:5.1f} s", flush=True)
        return failure is not None

    trial.require_sound(faults)
    with ThreadPoolExecutor(jobs) as pool:
        survivors = len(faults) - sum(pool.map(caught, faults))
    print(f"{len(faults) - survivors} of {len(faults)} faults are caught")
    return survivors


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
    parser.add_argument("--jobs", type=int, default=os.cpu_count() or 1)
    parser.add_argument("--build", type=Path)
    parser.add_argument("root", nargs="?", type=Path, default=Path(__file__).resolve().parents[2])
    return parser.parse_args(arguments)


def main(arguments):
    options = parse(arguments)
    faults = chosen(options.only, options.all or "PLATON_LONG" in os.environ)
    if options.list:
        for fault in FAULTS:
            print(f"{fault.name:32} {fault.breaks} ({fault.file}; {fault.test}{'' if fault.usual else '; with --all'})")
        return 0
    wrong = list(misfits(options.root))
    if wrong or options.check:
        print("\n".join(wrong + [f"{len(FAULTS)} faults, {len(wrong)} misfits"]))
        return 1 if wrong else 0
    root = options.root.resolve()
    directory = (options.build or root / "build/faults").resolve()
    update(directory, root, options.jobs)
    return 1 if run(Trial(SharedBuild(directory, root), root), faults, options.jobs) else 0


if __name__ == "__main__":
    try:
        sys.exit(main(sys.argv[1:]))
    except RuntimeError as error:
        print(error, file=sys.stderr)
        sys.exit(1)
    except (BuildError, ValueError) as error:
        print(error, file=sys.stderr)
        sys.exit(2)
