#!/usr/bin/env python3
"""Draws faults at random lines of the product, and counts those that the tests catch.

usage: draw.py [--seed S] [--count N] [--only K]… [--lane LABEL]… [--narrow] [--everything] [--brief] [--list]
               [--seconds T] [--minutes M] [--least PERCENT] [--jobs N] [--json FILE] [--summary FILE] [--build DIR] [ROOT]

--seed S        the numbers that are drawn follow from it; by default today's date, as 20261231.
--count N       try the faults 1 to N, by default 60.
--only K        try only fault K; may be repeated.
--lane LABEL    run only tests with this label of ctest; may be repeated.
--narrow        run only the tests of the changed file and of its folder.
--everything    also run long tests, and those that need a display.
--brief         let tests repeat only as often as with `./platon test --all`.
--seconds T     without --everything, run no test that takes longer, by default 30 s.
--minutes M     begin no further fault after so many minutes of trials. The report says how many were tried.
--least PERCENT exit 1 if fewer are caught or explained, by default 92.
--jobs N        try so many faults at a time, by default one for each processor.
--json FILE     append each result as a line. Faults that the file has are not tried again.
--summary FILE  write the rate there, too.
--list          print the faults without trying them; those that do not compile, too.
--build DIR     a build with the preset `faults`, by default build/faults. It is made, or brought up to date.

A fault is a slip of sites.py at a line that is drawn from all product files, but those that draw. A fault that does not
compile, or compiles to the same code, is drawn again. The tests of the changed file and of its folder come first, then
all others that load the changed library, until one fails. Tests that fail without a fault are left out. equivalent.txt
explains faults that no test can catch. The same seed gives the same faults in the same tree.
"""

import argparse
import datetime
import json
import os
import random
import re
import sys
import threading
import time
from concurrent.futures import ThreadPoolExecutor
from dataclasses import asdict, dataclass
from pathlib import Path

from shared_build import BuildError, SharedBuild, update
from sites import OPERATORS, Finder
from test_suite import TestSuite
from trial import Trial

PRODUCT = ("shared", "protocol", "server", "client", "levels")
DRAWING = re.compile(r"client/(gl|scene|hud)/|levels/(picture|drawing)/|shared/(examples|package)/")
EQUIVALENT = Path(__file__).with_name("equivalent.txt")
DRAWS = 12  # for one fault, until it compiles to other code


@dataclass(frozen=True)
class Drawn:
    number: int
    file: str
    line: int
    operator: str
    original: str
    changed: str
    text: str  # of the whole changed file


def one_line(text):
    return " ".join(text.split())


def product_files(root, compiled):
    """Sources of libraries and the headers, but those that draw."""
    paths = (path.relative_to(root).as_posix() for folder in PRODUCT for path in sorted((root / folder).rglob("*.*")))
    for path in paths:
        if not DRAWING.match(path) and (path.endswith(".h") or path in compiled):
            yield path


class Faults:
    """All lines with a site in an order that the seed gives. Each fault has its own lines to draw from."""

    def __init__(self, texts, seed):
        self._seed = seed
        self._texts = texts
        self._sites = {}
        for file, text in texts.items():
            for site in Finder(text).sites():
                self._sites.setdefault((file, text.count("\n", 0, site.begin) + 1), []).append(site)
        self._lines = sorted(self._sites)
        random.Random(seed).shuffle(self._lines)

    def __len__(self):
        return len(self._lines) // DRAWS

    def drawn(self, number):
        """Yields the fault of this number, and those that replace it as long as they do not compile."""
        chance = random.Random(f"{self._seed} {number}")
        for place in self._lines[(number - 1) * DRAWS : number * DRAWS]:
            sites = self._sites[place]
            operator = chance.choice([name for name in OPERATORS if any(site.operator == name for site in sites)])
            site = chance.choice([site for site in sites if site.operator == operator])
            yield self._fault(number, *place, site)

    def _fault(self, number, file, line, site):
        text = self._texts[file]
        begin = text.rfind("\n", 0, site.begin) + 1
        end = text.find("\n", site.end)
        changed = text[begin : site.begin] + site.replaced + text[site.end : end]
        return Drawn(
            number, file, line, site.operator, one_line(text[begin:end]), one_line(changed), text[:begin] + changed + text[end:]
        )


def explained(path=EQUIVALENT):
    """{(file, original line, changed line): why}. Four lines for each, separated by empty lines; # begins a comment."""
    lines = [line for line in path.read_text(encoding="utf-8").splitlines() if not line.startswith("#")]
    entries = {}
    for part in "\n".join(lines).split("\n\n"):
        fields = part.strip().splitlines()
        if fields and len(fields) != 4:
            raise ValueError(f"{path}: an entry has not four lines: {fields[0]}")
        if fields:
            entries[fields[0], one_line(fields[1]), one_line(fields[2])] = fields[3]
    return entries


class Report:
    """Prints and keeps the results."""

    def __init__(self, seed, reasons, file):
        self._seed = seed
        self._reasons = reasons
        self._file = file
        self._lock = threading.Lock()
        self.results = self._kept()

    def _kept(self):
        if self._file is None or not self._file.is_file():
            return {}
        lines = map(json.loads, self._file.read_text(encoding="utf-8").splitlines())
        return {result["number"]: result for result in lines if result["seed"] == self._seed}

    def add(self, fault, result, seconds):
        entry = {name: value for name, value in asdict(fault).items() if name != "text"}
        why = self._reasons.get((fault.file, fault.original, fault.changed))
        verdict = "caught" if result["test"] else "explained" if why else "survived"
        entry = {"seed": self._seed, **entry, "verdict": verdict, **result, "why": why, "seconds": round(seconds, 1)}
        with self._lock:
            self.results[fault.number] = entry
            if self._file:
                with self._file.open("a", encoding="utf-8") as file:
                    file.write(json.dumps(entry, ensure_ascii=False) + "\n")
            print(described(entry), flush=True)

    def rate(self, numbers):
        """The share that is caught or explained, per cent, and a line that says it."""
        found = [self.results[number]["verdict"] for number in numbers if number in self.results]
        counts = {verdict: found.count(verdict) for verdict in ("caught", "explained", "survived")}
        rate = 100 * (1 - counts["survived"] / len(found)) if found else 0.0
        summary = (
            f"seed {self._seed}: {counts['caught']} caught, {counts['explained']} explained, {counts['survived']} survived "
            f"of {len(found)} faults: {rate:.1f} %"
        )
        return rate, summary


def described(entry):
    how = f"{entry['test']} {entry['how']} ({entry['stage']})" if entry["test"] else entry["why"] or entry["verdict"].upper()
    return (
        f"{entry['seed']}/{entry['number']} {entry['file']}:{entry['line']} {entry['operator']}: {how}\n"
        f"  - {entry['original']}\n  + {entry['changed']}"
    )


def parse(arguments):
    parser = argparse.ArgumentParser(usage=__doc__.split("usage: ")[1].split("\n\n")[0])
    parser.add_argument("--seed", type=int, default=int(datetime.date.today().strftime("%Y%m%d")))
    parser.add_argument("--count", type=int, default=60)
    parser.add_argument("--only", type=int, action="append", default=[])
    parser.add_argument("--lane", action="append", default=[])
    parser.add_argument("--narrow", action="store_true")
    parser.add_argument("--everything", action="store_true")
    parser.add_argument("--brief", action="store_true")
    parser.add_argument("--list", action="store_true")
    parser.add_argument("--seconds", type=float, default=30)
    parser.add_argument("--minutes", type=float, default=float("inf"))
    parser.add_argument("--least", type=float, default=92)
    parser.add_argument("--jobs", type=int, default=os.cpu_count() or 1)
    parser.add_argument("--json", type=Path)
    parser.add_argument("--summary", type=Path)
    parser.add_argument("--build", type=Path)
    parser.add_argument("root", nargs="?", type=Path, default=Path(__file__).resolve().parents[2])
    return parser.parse_args(arguments)


def chosen_tests(suite, options):
    """The tests that may catch a fault: those that pass without one, soon enough."""
    tests = [test for test in suite.tests if not options.lane or test.labels & set(options.lane)]
    if not options.everything:
        tests = [test for test in tests if not any("on_display.sh" in word for word in test.command)]
    longest = 600 if options.everything else options.seconds
    failing = suite.measure(tests, options.jobs, longest)
    for test in failing:
        print(f"left out: {test.name} {suite.failure_without_fault(test)} without a fault")
    return [test for test in tests if suite.is_sound(test) and suite.seconds(test) <= longest]


def main(arguments):
    options = parse(arguments)
    root = options.root.resolve()
    directory = (options.build or root / "build" / "faults").resolve()
    update(directory, root, options.jobs)
    build = SharedBuild(directory, root)
    texts = {file: (root / file).read_text(encoding="utf-8") for file in product_files(root, build.compiled)}
    faults = Faults(texts, options.seed)
    numbers = options.only or range(1, options.count + 1)
    if not all(1 <= number <= len(faults) for number in numbers):
        raise ValueError(f"the tree has faults 1 to {len(faults)}")
    if options.list:
        for number in numbers:
            fault = next(faults.drawn(number))
            print(f"{number} {fault.file}:{fault.line} {fault.operator}\n  - {fault.original}\n  + {fault.changed}")
        return 0
    report = Report(options.seed, explained(), options.json)
    suite = TestSuite(build, root, options.brief)
    tests = chosen_tests(suite, options)
    print(f"seed {options.seed}, {len(tests)} tests", flush=True)
    trial = Trial(build, suite, tests, options.narrow)
    end = time.monotonic() + 60 * options.minutes

    def attempt(number):
        start = time.monotonic()
        if start > end:
            return
        found = trial.result(faults.drawn(number))
        if found:
            report.add(*found, time.monotonic() - start)

    with ThreadPoolExecutor(options.jobs) as pool:
        list(pool.map(attempt, [number for number in numbers if number not in report.results]))
    rate, summary = report.rate(numbers)
    print(summary)
    if options.summary:
        options.summary.write_text(summary + "\n", encoding="utf-8")
    return 0 if rate >= options.least else 1


if __name__ == "__main__":
    try:
        sys.exit(main(sys.argv[1:]))
    except (BuildError, ValueError) as error:
        print(error, file=sys.stderr)
        sys.exit(2)
