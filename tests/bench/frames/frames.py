#!/usr/bin/env python3
"""Measures what a frame costs, by platon-client --benchmark.

usage: frames.py ROOT [--write]. PLATON_BIN names the folder of the programs. Prints the table of docs/playing.md; --write
writes it there. Prints every limit that is exceeded; exit 1 if there is one.
"""

import json
import os
import subprocess
import sys
from pathlib import Path

sys.path.append(str(Path(__file__).resolve().parents[2] / "net/matrix"))

from page import replace_part, with_part  # noqa: E402
from processes import Failure, exit_code_of  # noqa: E402

COMMAND = "frames"
PAGE = "docs/playing.md"
COLUMNS = {"p50Ms": 1, "p99Ms": 1, "allCpuMs": 1, "ownCpuMs": 2, "drawCalls": 0}  # digits after the point

DEFAULT_MS = 1000 / 60  # of a frame in the quality that a first start chooses
BEST_MS = 1000 / 30  # of a frame in the quality `all`
OWN_CPU_MS = 1  # of a frame in any quality


def table(report, processors):
    """The generated part of the page."""
    heads = ["quality", *(f"`{column}`" for column in COLUMNS)]
    rows = [[f"`{frame['quality']}`", *(f"{frame[column]:.{digits}f}" for column, digits in COLUMNS.items())] for frame in report["frames"]]
    lines = [f"| {' | '.join(cells)} |" for cells in (heads, ["---"] * len(heads), *rows)]
    return "\n".join([f"On {report['driver']} with {processors} processors; the default is `{report['default']}`:", "", *lines])


def exceeded(report):
    """A line for each limit that the report exceeds."""
    lines = []
    for frame in report["frames"]:
        name = frame["quality"]
        limits = [("ownCpuMs", OWN_CPU_MS)]
        if name == "all":
            limits.append(("p50Ms", BEST_MS))
        if name == report["default"]:
            limits.append(("p50Ms", DEFAULT_MS))
        lines += [f"{column} of {name} is {frame[column]:.2f}, over {limit:.1f}" for column, limit in limits if frame[column] > limit]
    return lines


def measure(programs):
    words = [programs / "platon-client", "--offscreen", "--benchmark", "--json"]
    result = subprocess.run(words, capture_output=True, text=True)
    if result.returncode != 0:
        raise Failure(result.stderr.strip())
    return json.loads(result.stdout)


def run(root, writes, programs):
    page = root / PAGE
    with_part(page.read_text(encoding="utf-8"), "", COMMAND)  # fails before the run, not after it
    report = measure(programs)
    part = table(report, os.cpu_count())
    print(part)
    if writes:
        replace_part(page, part, COMMAND)
    return exceeded(report)


def main(arguments):
    if len(arguments) not in (1, 2) or arguments[1:] not in ([], ["--write"]) or "PLATON_BIN" not in os.environ:
        print(__doc__, file=sys.stderr)
        return 2
    programs = Path(os.environ["PLATON_BIN"])
    return exit_code_of(lambda: run(Path(arguments[0]).resolve(), arguments[1:] == ["--write"], programs))


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
