#!/usr/bin/env python3
"""Runs the simulation on several machines and compares their hashes.

Without --ticks, each machine verifies every recording in tests/determinism/golden. With --ticks N, 8 players with seeded
button presses play one level of each solid for N ticks on each machine; --drive is that of platon-sim run.
Exit 0 if all hashes are equal, 1 if one differs or a machine fails, 2 on wrong usage.
"""

import argparse
import json
import os
import subprocess
import sys
import time
from collections import Counter
from concurrent.futures import ThreadPoolExecutor, as_completed
from dataclasses import dataclass
from pathlib import Path

from machine import MACHINES, ROOT, MachineError

PLAYERS = 8
SOLIDS = ("tetrahedron", "hexahedron", "octahedron", "dodecahedron", "icosahedron")


@dataclass
class Outcome:
    """Result of one machine for one case; `fault` says why it has no valid hash."""

    hash: str = ""
    ticks: int = 0
    seconds: float = 0.0
    output: str = ""
    fault: str = ""


def cases_of(options):
    """[(name, arguments of platon-sim)] of the runs on each machine."""
    if options.ticks is None:
        files = sorted(options.golden.glob("*.recording"))
        return [(file.stem, ["verify", file, "--json"]) for file in files]
    settings = ["--players", PLAYERS, "--ticks", options.ticks, "--seed", options.seed]
    settings += ["--drive", options.drive, "--json"]
    solids = [options.golden / f"levels/{solid}.level" for solid in SOLIDS]
    return [(file.stem, ["run", file, *settings]) for file in solids]


def run(machine, builds, arguments):
    """Runs platon-sim once."""
    start = time.monotonic()
    done = subprocess.run(machine.command(builds, arguments), capture_output=True, text=True, errors="replace")
    outcome = Outcome(seconds=time.monotonic() - start, output=(done.stdout + done.stderr).strip())
    try:
        answer = json.loads(done.stdout)
        outcome.hash, outcome.ticks = str(answer["hash"]), int(answer["ticks"])
    except (ValueError, KeyError, TypeError):
        outcome.fault = "gave no hash"
    if done.returncode != 0:
        meaning = {1: "differs from the recording", 3: "finds the recording damaged"}
        outcome.fault = f"{meaning.get(done.returncode, 'fails')} (exit code {done.returncode})"
    return outcome


def run_all(machines, cases, builds, jobs):
    """{(machine, case): Outcome}; a process for each, and a line on stderr as each ends."""
    outcomes = {}
    with ThreadPoolExecutor(jobs) as pool:
        futures = {
            pool.submit(run, machine, builds, arguments): (machine.name, case)
            for machine in machines
            for case, arguments in cases
        }
        for future in as_completed(futures):
            machine, case = futures[future]
            outcome = outcomes[machine, case] = future.result()
            note = outcome.fault or outcome.hash
            progress(f"[{len(outcomes)}/{len(futures)}] {machine} {case}: {note}, {outcome.seconds:.1f} s")
    return outcomes


def expected(outcomes, case):
    """The most frequent hash of a case, at a tie that of the first machine; None if there is no hash."""
    hashes = Counter(outcome.hash for (_, of), outcome in outcomes.items() if of == case and not outcome.fault)
    return max(hashes, key=hashes.get) if hashes else None


def differences(outcomes):
    """Yields a sentence for each unexpected outcome."""
    for (machine, case), outcome in outcomes.items():
        hash_expected = expected(outcomes, case)
        if outcome.fault:
            yield f"{machine} {outcome.fault} on {case}; platon-sim printed: {outcome.output or 'nothing'}"
        elif outcome.hash != hash_expected:
            yield (f"{machine} differs on {case}: {outcome.hash} after {outcome.ticks} ticks, where most machines have "
                   f"{hash_expected}; platon-sim printed: {outcome.output}")  # fmt: skip


def _cell(outcome, hash_expected):
    if outcome.fault:
        return "FAILS"
    same = "" if outcome.hash == hash_expected else f"{outcome.hash} "
    return f"{same}{outcome.seconds:.1f} s"


def table(machines, cases, outcomes, built):
    """Markdown: a row for each case with the hash, and the seconds of each machine that has it, or its other hash."""
    names = [machine.name for machine in machines]
    rows = [["", "ticks", "hash", *names], ["---"] * (3 + len(names))]
    for case, _ in cases:
        hash_expected = expected(outcomes, case)
        ticks = max(outcomes[name, case].ticks for name in names)
        rows.append([case, str(ticks), hash_expected or "", *(_cell(outcomes[n, case], hash_expected) for n in names)])
    rows.append(["build", "", "", *(f"{built[name]:.1f} s" for name in names)])
    return "\n".join(f"| {' | '.join(row)} |" for row in rows)


def build_all(machines, options):
    """{machine: seconds of its build}"""
    built = {}
    for machine in machines:
        machine.check()
    for machine in machines:
        start = time.monotonic()
        machine.build(options.builds, options.jobs, options.launcher)
        built[machine.name] = time.monotonic() - start
        progress(f"{machine.name} ({machine.what}) is built, {built[machine.name]:.1f} s")
    return built


def progress(line):
    print(line, file=sys.stderr, flush=True)


def compare(machines, options):
    """Builds, runs and prints the table; returns the exit code."""
    cases = cases_of(options)
    if not cases:
        progress(f"nothing to compare: no recording in {options.golden}")
        return 1
    built = build_all(machines, options)
    outcomes = run_all(machines, cases, options.builds, options.jobs)
    print(table(machines, cases, outcomes, built))
    found = list(differences(outcomes))
    for sentence in found:
        print(sentence)
    print("some hashes differ" if found else f"{len(machines)} machines, {len(cases)} cases: all hashes are equal")
    return 1 if found else 0


def parsed(arguments):
    parser = argparse.ArgumentParser(prog="platon test --machines", description=__doc__)
    parser.add_argument("machines", nargs="*", metavar="MACHINE", help=f"of {', '.join(MACHINES)}; default: all")
    parser.add_argument("--ticks", type=int, metavar="N", help="play levels for N ticks instead of the recordings")
    parser.add_argument("--seed", type=int, default=1, metavar="S", help="with --ticks")
    parser.add_argument("--drive", choices=("play", "churn", "fling"), default="play", help="with --ticks")
    parser.add_argument("--jobs", type=int, default=os.cpu_count(), metavar="J", help="processes at a time")
    parser.add_argument("--builds", type=Path, default=ROOT / "build/machines", metavar="DIR")
    parser.add_argument("--launcher", default="", metavar="PROGRAM", help="runs the compilers, for example ccache")
    parser.add_argument("--golden", type=Path, default=ROOT / "tests/determinism/golden", metavar="DIR")
    options = parser.parse_args(arguments)
    if options.ticks is not None and options.ticks < 1:
        parser.error("--ticks needs a number of at least 1")
    if options.ticks is not None and len(options.machines) == 1:
        parser.error("--ticks compares machines with each other: name at least two")
    unknown = [name for name in options.machines if name not in MACHINES]
    if unknown:
        parser.error(f"no machine '{unknown[0]}'; the machines are {', '.join(MACHINES)}")
    return options


def main(arguments):
    options = parsed(arguments)
    machines = [MACHINES[name] for name in options.machines or MACHINES]
    try:
        return compare(machines, options)
    except MachineError as reason:
        progress(f"{reason}")
        return 1


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
