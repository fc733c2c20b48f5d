#!/usr/bin/env python3
"""Checks that every C++ file is formatted as .clang-format demands.

usage: check_format.py ROOT. Prints clang-format's complaints; exit 1 if there are any.
"""

import os
import shutil
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

FOLDERS = ("shared", "protocol", "server", "client", "levels", "tests")


def cpp_files(root):
    """Paths of all C++ files, relative to root."""
    found = (path for folder in FOLDERS for path in (root / folder).rglob("*") if path.suffix in (".h", ".cpp"))
    return sorted(path.relative_to(root).as_posix() for path in found)


def complaints(root, files):
    command = ["clang-format", "--dry-run", "-Werror", *files]
    result = subprocess.run(command, cwd=root, capture_output=True, text=True)
    return result.stderr if result.returncode != 0 else ""


def main(arguments):
    if len(arguments) != 2:
        print("usage: check_format.py ROOT", file=sys.stderr)
        return 2
    if shutil.which("clang-format") is None:
        print("clang-format is not installed: apt-get install clang-format")
        return 1
    root = Path(arguments[1])
    files = cpp_files(root)
    jobs = os.cpu_count() or 1
    with ThreadPoolExecutor(jobs) as pool:
        found = "".join(pool.map(lambda first: complaints(root, files[first::jobs]), range(min(jobs, len(files)))))
    print(found, end="")
    print(f"{len(files)} files; format one with clang-format -i FILE" if found else f"{len(files)} files")
    return 1 if found or not files else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv))
