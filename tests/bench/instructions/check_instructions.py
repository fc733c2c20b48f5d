#!/usr/bin/env python3
"""Counts the instructions of Game::advance, also on a crowded level, and of the sweep under callgrind, and compares them
with expected.json.

usage: check_instructions.py [--accept] PROGRAM COMPILER. PROGRAM is platon-instruction-count; COMPILER, for example
"GNU 12.2.0 x86_64", is the key of the expected counts. Exit 1 if a count differs by more than 3 per cent, also downwards;
77 (skipped) if expected.json has no counts for the compiler. --accept writes the counts into expected.json.
"""

import json
import re
import subprocess
import sys
import tempfile
from pathlib import Path

EXPECTED = Path(__file__).resolve().parent / "expected.json"
TOLERANCE_PERCENT = 3
# Calls in the longer of two runs. The shorter makes none, so that the difference leaves out the start of the program.
CALLS = {"advance": 600, "crowded": 200, "sweep": 20}


def instructions(program, what, calls):
    """Instructions of one run of the program."""
    with tempfile.TemporaryDirectory(prefix="platon-callgrind-") as folder:
        command = ["valgrind", "--tool=callgrind", f"--callgrind-out-file={folder}/out", program, what, str(calls)]
        result = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    collected = re.search(r"Collected : (\d+)", result.stderr)
    if result.returncode != 0 or collected is None:
        raise RuntimeError(f"{' '.join(command)} fails:\n{result.stderr}")
    return int(collected[1])


def per_call(program, what):
    """Instructions of one call, rounded."""
    return round((instructions(program, what, CALLS[what]) - instructions(program, what, 0)) / CALLS[what])


def differences(counts, expected):
    """Yields a sentence for every count outside the tolerance."""
    for what, count in counts.items():
        percent = 100 * (count / expected[what] - 1)
        print(f"{what}: {count} instructions a call, {percent:+.2f} % of the expected {expected[what]}")
        if abs(percent) > TOLERANCE_PERCENT:
            yield f"{what} takes {percent:+.1f} % instructions, more than {TOLERANCE_PERCENT} % off"


def main(arguments):
    accept = arguments[1:2] == ["--accept"]
    if len(arguments) != 3 + accept:
        print(__doc__, file=sys.stderr)
        return 2
    program, compiler = arguments[1 + accept :]
    expected = json.loads(EXPECTED.read_text(encoding="utf-8"))
    if compiler not in expected and not accept:
        print(f"skipped: {EXPECTED.name} has no counts for {compiler}, only for {', '.join(expected)}")
        return 77
    counts = {what: per_call(program, what) for what in CALLS}
    if accept:
        expected[compiler] = counts
        EXPECTED.write_text(json.dumps(expected, indent=2) + "\n", encoding="utf-8")
        return 0
    found = list(differences(counts, expected[compiler]))
    for sentence in found:
        print(sentence)
    if found:
        print(f"if this is intended: in the root of the tree: python3 {Path(__file__).resolve()} --accept {program} '{compiler}'")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv))
