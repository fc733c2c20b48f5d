#!/usr/bin/env python3
"""Checks that what the docs name exists: linked files and headings, paths, tests, options, constants and members.

usage: names_test.py ROOT BUILD. Each error is a line `page: what`; exit 1 if there is any.
"""

import json
import re
import subprocess
import sys
from pathlib import Path

import pages

SOURCES = {".h", ".cpp", ".py", ".sh", ".txt", ".fbs", ".mjs"}
PATH = re.compile(r"(?:shared|protocol|server|client|levels|tests|docs|\.ci)/[\w./*-]*\w")
OPTION = re.compile(r"--[a-z][a-z-]+")
TEST = re.compile(r"[a-z0-9_]+_test")
MEMBER = re.compile(r"([A-Z]\w*)::([a-z]\w*)(?:\(.*\))?")
CONSTANT = re.compile(r"(?:[A-Z]\w*::)?(k[A-Z]\w+)")

# Options of the tools of others that the docs name.
FOREIGN_OPTIONS = {"--preset", "--build", "--target", "--from-file", "--now", "--format", "--read-only",
                   "--cap-drop", "--publish", "--volume", "--stop-timeout"}  # fmt: skip


def sources_of(root):
    """The text of all sources, without tests/docs, whose texts would prove themselves."""
    folders = ("shared", "protocol", "server", "client", "levels", "tests", "docs")
    files = [path for folder in folders for path in (root / folder).rglob("*") if path.suffix in SOURCES]
    texts = [path.read_text(encoding="utf-8") for path in [root / "platon", *files] if "tests/docs" not in path.as_posix()]
    return "\n".join(texts)


def members_of(root):
    """Of each class, the words of the files that define it."""
    members = {}
    for folder in ("shared", "protocol", "server", "client", "levels", "tests"):
        for path in (root / folder).rglob("*"):
            text = path.read_text(encoding="utf-8") if path.suffix in (".h", ".cpp") else ""
            for name in re.findall(r"^\s*(?:class|struct|enum class) (\w+)[^;]*$", text, re.MULTILINE):
                members.setdefault(name, set()).update(re.findall(r"\w+", text))
    return members


def known_tests(root, build):
    """Names of test files and of tests that ctest knows."""
    names = {path.stem for folder in ("*.cpp", "*.py") for path in (root / "tests").rglob(folder)}
    listed = subprocess.run(["ctest", "--show-only=json-v1"], cwd=build, capture_output=True, text=True, check=True)
    return names | {test["name"] for test in json.loads(listed.stdout)["tests"]}


def check_links(root, page, text):
    for link in pages.links(text):
        if link.startswith("http"):
            continue
        file, _, anchor = link.partition("#")
        target = (root / page).parent / file if file else root / page
        if not target.exists():
            yield f"the link {link} leads nowhere"
        elif anchor and anchor not in pages.anchors(target.read_text(encoding="utf-8")):
            yield f"{target.name} has no heading for the link {link}"


def check_words(root, words, sources, tests, members):
    for word in words:
        if PATH.fullmatch(word) and not list(root.glob(word)):
            yield f"the path {word} does not exist"
        if TEST.fullmatch(word) and word not in tests:
            yield f"there is no test {word}"
        option = OPTION.match(word)
        if option and option[0] not in FOREIGN_OPTIONS and option[0] not in sources:
            yield f"no source has the option {option[0]}"
        member = MEMBER.fullmatch(word)
        if member and member[2] not in members.get(member[1], ()):
            yield f"no class has the member {word}"
        constant = CONSTANT.fullmatch(word)
        if constant and not re.search(rf"\b{constant[1]}\b", sources):
            yield f"no source has the constant {word}"


def check_tree(root, build):
    sources, tests, members = sources_of(root), known_tests(root, build), members_of(root)
    for page, text in pages.pages(root):
        words = pages.code_words(text)
        for error in [*check_links(root, page, text), *check_words(root, words, sources, tests, members)]:
            yield f"{page}: {error}"


def main(arguments):
    if len(arguments) != 2:
        print(__doc__, file=sys.stderr)
        return 2
    errors = list(check_tree(*(Path(argument).resolve() for argument in arguments)))
    for error in errors:
        print(error)
    return 1 if errors else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
