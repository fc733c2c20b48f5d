#!/usr/bin/env python3
"""Measures the length of every C++ function with universal-ctags.

usage: check_functions.py ROOT. No function may be longer than 80 lines; outside tests/ the median is at most 8 lines and
the 95th percentile at most 40. Exit 1 if a bound is exceeded, 77 (skipped) without universal-ctags.
"""

import json
import shutil
import subprocess
import sys
from pathlib import Path

MAX_LINES = 80
MAX_MEDIAN = 8
MAX_PERCENTILE_95 = 40
FOLDERS = ("shared", "protocol", "server", "client", "levels", "tests")


def function_lengths(ctags, root):
    """[(lines, path, name, first line)] of every function in the tree."""
    files = [p.relative_to(root).as_posix() for f in FOLDERS for p in (root / f).rglob("*") if p.suffix in (".h", ".cpp")]
    command = [ctags, "-L", "-", "--languages=C++", "--langmap=C++:.cpp.h", "--c++-kinds=f", "--fields=+ne",
               "--output-format=json", "-f", "-"]  # fmt: skip
    result = subprocess.run(command, cwd=root, input="\n".join(files), capture_output=True, text=True, check=True)
    tags = [json.loads(line) for line in result.stdout.splitlines()]
    return [(t["end"] - t["line"] + 1, t["path"], t["name"], t["line"]) for t in tags if "end" in t]


def percentile(lengths, percent):
    """The smallest length that at least `percent` per cent of the lengths do not exceed."""
    ordered = sorted(lengths)
    return ordered[max(0, -(-len(ordered) * percent // 100) - 1)]


def violations(functions):
    for lines, path, name, first in sorted(functions, reverse=True):
        if lines > MAX_LINES:
            yield f"{path}:{first}: {name} has {lines} lines, more than {MAX_LINES}"
    lengths = [lines for lines, path, _, _ in functions if not path.startswith("tests/")]
    if not lengths:
        yield "no function found outside tests/"
        return
    print(f"{len(lengths)} functions outside tests/: median {percentile(lengths, 50)}, "
          f"95th percentile {percentile(lengths, 95)}, longest {max(lengths)} lines")  # fmt: skip
    for percent, bound in ((50, MAX_MEDIAN), (95, MAX_PERCENTILE_95)):
        if percentile(lengths, percent) > bound:
            yield f"the {percent}th percentile of the function lengths is more than {bound} lines"


def main(arguments):
    if len(arguments) != 2:
        print("usage: check_functions.py ROOT", file=sys.stderr)
        return 2
    ctags = shutil.which("ctags-universal") or shutil.which("ctags")
    if ctags is None or "Universal" not in subprocess.run([ctags, "--version"], capture_output=True, text=True).stdout:
        print("skipped: universal-ctags is not installed")
        return 77
    found = list(violations(function_lengths(ctags, Path(arguments[1]))))
    for violation in found:
        print(violation)
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv))
