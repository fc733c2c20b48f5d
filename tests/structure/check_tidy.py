#!/usr/bin/env python3
"""Runs clang-tidy with the checks of .clang-tidy on the C++ files that a change touches.

usage: check_tidy.py ROOT BUILD. The change is what differs from the merge base with origin/main, or on main itself from
the previous commit, with files not committed yet. A header is checked through the .cpp file of its name. At most
MAX_FILES are checked, or all of them if the environment has PLATON_LONG. BUILD holds compile_commands.json and the
generated headers. Exit 1 on any complaint, 77 (skipped) without git or a commit to compare with.
"""

import json
import os
import re
import shlex
import shutil
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

MAX_FILES = 10
# Options of GCC that clang does not know, and the precompiled header, which is GCC's.
DROPPED = ("-Winvalid-pch", "-fpch-preprocess", "-ffat-lto-objects", "-fno-lto", "-flto", "-Wno-restrict",
           "-Wno-stringop-overflow", "-Wno-subobject-linkage")  # fmt: skip
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


def changed_files(root, base):
    changed = git(root, "diff", "--name-only", "--diff-filter=d", base).splitlines()
    return changed + git(root, "ls-files", "--others", "--exclude-standard").splitlines()


def sources_of(changed, compiled):
    """The compiled files through which the changed ones are checked. Headers lie beside their sources, or in
    shared/include/platon."""
    sources = {str(Path(path.replace("shared/include/platon/", "shared/")).with_suffix(".cpp"))
               for path in changed if path.endswith((".h", ".cpp"))}  # fmt: skip
    return sorted(sources & set(compiled))


def sample(files, count):
    """`count` of the files, evenly spread."""
    return files if len(files) <= count else [files[index * len(files) // count] for index in range(count)]


def for_clang(command):
    """The compile command without what only GCC understands."""
    words = shlex.split(command)
    while not words[0].endswith(("c++", "g++")):
        words.pop(0)  # a launcher
    kept = []
    for index, word in enumerate(words):
        if word == "-include" or words[index - 1] == "-include" or word.split("=")[0] in DROPPED:
            continue
        kept.append(word)
    return shlex.join(kept)


def files_of(entry):
    """The source of a compile command, or the sources that it compiles together."""
    if not UNITY_FILE.fullmatch(Path(entry["file"]).name):
        return [entry["file"]]
    return re.findall(r'^#include "(.+)"$', Path(entry["file"]).read_text(encoding="utf-8"), re.MULTILINE)


def compile_commands(root, build):
    """{path relative to root: entry} of the build, fit for clang."""
    entries = {}
    for entry in json.loads((build / "compile_commands.json").read_text(encoding="utf-8")):
        if "-mgeneral-regs-only" in entry["command"]:
            continue  # shared/ compiled a second time, with an option that clang's standard headers do not survive
        for file in files_of(entry):
            command = for_clang(entry["command"].replace(entry["file"], file))
            entries[os.path.relpath(file, root)] = {"directory": entry["directory"], "file": file, "command": command}
    return entries


def complaints(root, database, path):
    command = ["clang-tidy", "-p", database, "--quiet", path]
    result = subprocess.run(command, cwd=root, capture_output=True, text=True)
    return result.stdout + result.stderr if result.returncode != 0 else ""


def check(root, build):
    """Prints what was checked; True if there were no complaints."""
    base = base_of(root)
    compiled = compile_commands(root, build)
    sources = sources_of(changed_files(root, base), compiled)
    checked = sources if "PLATON_LONG" in os.environ else sample(sources, MAX_FILES)
    print(f"compared with {base[:12]}: checking {len(checked)} of {len(sources)} changed files", *checked, sep="\n  ")
    with tempfile.TemporaryDirectory(prefix="platon-tidy-") as database:
        (Path(database) / "compile_commands.json").write_text(json.dumps(list(compiled.values())), encoding="utf-8")
        with ThreadPoolExecutor(os.cpu_count() or 1) as pool:
            found = list(pool.map(lambda path: complaints(root, database, path), checked))
    print("".join(found), end="")
    return not any(found)


def main(arguments):
    if len(arguments) != 3:
        print("usage: check_tidy.py ROOT BUILD", file=sys.stderr)
        return 2
    if shutil.which("clang-tidy") is None:
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
