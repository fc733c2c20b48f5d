#!/usr/bin/env python3
"""Runs clang-tidy with the checks of .clang-tidy on the lines of C++ that a change touches, by clang-tidy-diff.

usage: check_tidy.py ROOT BUILD. The change is what differs from the merge base with origin/main, or on main itself from
the previous commit, with files not committed yet. At most MAX_FILES are checked, or all of them if the environment has
PLATON_LONG. BUILD holds compile_commands.json and the generated headers. Exit 1 on any complaint, 77 (skipped) without git
or a commit to compare with.
"""

import json
import os
import re
import shlex
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

MAX_FILES = 10
# As CMake names a file that includes several sources.
UNITY_FILE = re.compile(r"unity_\d+_cxx\.cxx")


class Skipped(Exception):
    """Why nothing can be checked."""


def git(root, *arguments):
    """Output of a git command; None if it fails."""
    result = subprocess.run(["git", *arguments], cwd=root, capture_output=True, text=True)
    return result.stdout.strip() if result.returncode == 0 else None


def base_of(root):
    """The commit that the tree is compared with."""
    head = git(root, "rev-parse", "HEAD")
    if head is None:
        raise Skipped("this is not a git repository with a commit")
    base = git(root, "merge-base", "HEAD", "origin/main")
    if base is None or base == head:
        base = git(root, "rev-parse", "--verify", "--quiet", "HEAD~1")
    if base is None:
        raise Skipped("there is no commit to compare with: neither origin/main nor the previous one is here")
    return base


def changes(root, base):
    """{path: the changed lines, as a diff} of C++ files. All lines of a file that git does not know are changed."""
    diff = git(root, "diff", "-U0", "--no-ext-diff", "--diff-filter=d", "--dst-prefix=b/", base, "--", "*.cpp", "*.h")
    parts = {re.search(r"(?m)^\+\+\+ b/(.*)$", part): part for part in re.split(r"(?m)^(?=diff --git )", diff)}
    changed = {name[1]: part for name, part in parts.items() if name}
    for path in git(root, "ls-files", "--others", "--exclude-standard", "*.cpp", "*.h").splitlines():
        lines = (root / path).read_text(encoding="utf-8").count("\n")
        changed[path] = f"+++ b/{path}\n@@ -0,0 +1,{lines} @@"
    return changed


def files_of(entry):
    """The source of a compile command, or the sources that it compiles together."""
    if not UNITY_FILE.fullmatch(Path(entry["file"]).name):
        return [entry["file"]]
    return re.findall(r'^#include "(.+)"$', Path(entry["file"]).read_text(encoding="utf-8"), re.MULTILINE)


def compile_commands(build):
    """{file: entry} of the build. A command keeps what clang needs to parse the file: the build may have been made by GCC,
    with options and precompiled headers that clang does not know."""
    entries = {}
    for entry in json.loads((build / "compile_commands.json").read_text(encoding="utf-8")):
        words = shlex.split(entry["command"])
        kept = [word for before, word in zip([""] + words, words)
                if word.startswith(("-D", "-I", "-isystem", "-std=")) or before == "-isystem"]  # fmt: skip
        for file in files_of(entry):
            entries[file] = {"directory": entry["directory"], "file": file, "arguments": ["c++", *kept, "-c", file]}
    return entries


def sample(files, count):
    """`count` of the files, evenly spread."""
    return files if len(files) <= count else [files[index * len(files) // count] for index in range(count)]


def check(root, build):
    """Prints what was checked; True if there were no complaints. clang-tidy takes the command of a header from the most
    similar source."""
    base = base_of(root)
    commands = compile_commands(build)
    changed = {path: part for path, part in changes(root, base).items() if path.endswith(".h") or str(root / path) in commands}
    checked = sample(sorted(changed), len(changed) if "PLATON_LONG" in os.environ else MAX_FILES)
    print(f"compared with {base[:12]}: checking {len(checked)} of {len(changed)} changed files", *checked, sep="\n  ")
    with tempfile.TemporaryDirectory(prefix="platon-tidy-") as database:
        (Path(database) / "compile_commands.json").write_text(json.dumps(list(commands.values())), encoding="utf-8")
        command = ["clang-tidy-diff", "-p1", "-path", database, "-j", str(os.cpu_count() or 1), "-quiet"]
        diff = "".join(changed[path] + "\n" for path in checked)
        result = subprocess.run(command, cwd=root, input=diff, capture_output=True, text=True)
    found = re.sub(r"(?m)^\d+ warnings? generated\.$|^\n", "", result.stdout + result.stderr).strip()
    print(found or "no complaints")
    # clang-tidy-diff exits with 0 whatever clang-tidy finds.
    return result.returncode == 0 and not re.search(r"error:|Error while processing|Failed:", found)


def main(arguments):
    if len(arguments) != 3:
        print("usage: check_tidy.py ROOT BUILD", file=sys.stderr)
        return 2
    if shutil.which("clang-tidy-diff") is None:
        print("clang-tidy is not installed: apt-get install clang-tidy")
        return 1
    if shutil.which("git") is None:
        print("skipped: git is not installed")
        return 77
    try:
        return 0 if check(Path(arguments[1]).resolve(), Path(arguments[2]).resolve()) else 1
    except Skipped as reason:
        print(f"skipped: {reason}")
        return 77


if __name__ == "__main__":
    sys.exit(main(sys.argv))
