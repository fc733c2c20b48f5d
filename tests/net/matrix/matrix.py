#!/usr/bin/env python3
"""Measures the network code with real servers and bots over loopback, under simulated network conditions.

usage: matrix.py ROOT (--write | --quick | --corners). PLATON_BIN names the folder of the programs. --write runs
all cells and writes the tables of docs/netcode.md; --quick prints a shorter run; --corners runs a few short cells and
checks only what does not depend on the speed of the machine. Prints every limit that is exceeded; exit 1 if there is one.
"""

import os
import sys
from pathlib import Path

import cells
from gates import failures, judge
from measured import section, text_report
from page import replace_part, with_part
from processes import exit_code_of
from run_cells import Runner

LEVEL = "tests/determinism/golden/levels/icosahedron.level"
PLANS = {"--write": cells.FULL, "--quick": cells.QUICK, "--corners": cells.CORNERS}


def say(line):
    print(line, file=sys.stderr, flush=True)


def run(root, mode, programs):
    page = root / "docs/netcode.md"
    with_part(page.read_text(encoding="utf-8"), "")  # fails before the run, not after it
    together, alone, without_players = Runner(programs, root / LEVEL, say).plan(PLANS[mode])
    judged = list(judge(together + alone, without_players, timings=mode != "--corners"))
    if mode == "--write":
        replace_part(page, section(together, alone, without_players, judged))
    else:
        print(text_report(together + alone, without_players))
    return failures(judged)


def main(arguments):
    if len(arguments) != 2 or arguments[1] not in PLANS or "PLATON_BIN" not in os.environ:
        print(__doc__, file=sys.stderr)
        return 2
    programs = Path(os.environ["PLATON_BIN"])
    return exit_code_of(lambda: run(Path(arguments[0]).resolve(), arguments[1], programs))


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
