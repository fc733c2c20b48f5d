#!/usr/bin/env python3
"""Writes the man page of a program and its completions for bash, zsh and fish, from what it prints for --help.

usage: describe.py PROGRAM SECTION FOLDER PAGES

PAGES is the folder in which the pages of the docs are installed.
"""

import sys
from pathlib import Path

import completions
from help_text import read_help, version_of
from man_page import man_page


def main(arguments):
    if len(arguments) != 5:
        print("usage: describe.py PROGRAM SECTION FOLDER PAGES", file=sys.stderr)
        return 2
    program, section, folder, pages = arguments[1], arguments[2], Path(arguments[3]), arguments[4]
    name = Path(program).name
    page = read_help(program, name)
    folder.mkdir(parents=True, exist_ok=True)
    texts = {
        f"{name}.{section}": man_page(page, section, version_of(program), pages),
        f"{name}.bash": completions.bash(page),
        f"_{name}": completions.zsh(page),
        f"{name}.fish": completions.fish(page),
    }
    for file, text in texts.items():
        (folder / file).write_text(text, encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv))
