#!/usr/bin/env python3
"""The page of all levels, docs/levels.md: what each asks of a player, and its picture.

usage: levels_page.py PLATON-LEVEL ROOT [--check]

The ideas are the comments between the title and the solid of each level file; the figures are those of the recorded ways
in levels/data/ways. --check compares the page with what would be written, and exits with 1 if it differs.
"""

import json
import subprocess
import sys
from pathlib import Path

PAGE = "docs/levels.md"
INTRODUCTION = (
    "# Levels\n\n"
    "The game has {count} levels, in the order in which a server plays them: {solids}. {several} of them need two players. "
    "*The pictures show each level whole, and the sentences tell its idea. Play first.*\n\n"
    "Each level states how many crossings of edges every way to its goal needs, which `platon-level solve "
    "--without-crossing` proves. Some state which keys and plates every way uses (`# needs:`), which `platon-level solve "
    "--without` proves: with the doors that they open shut, nobody gets to the goal. The other figures are those of an easy way, which `tests/levels/record.sh` finds and "
    "records, and which `platon-level solve --recorded` replays: presses of buttons; turns of down, which are returns to a "
    "face with another up; the ticks, of 60 a second, for which the tightest jump may be pressed; and the difficulty, which "
    "rises on each solid; the last levels are in the order in which they were drawn. Each press counts 1, each turn 4, and each tick that the tightest jump has less than 12 counts 1. "
    "`./platon test -L levels` checks all of this. [level_format.md](level_format.md) describes the files and the "
    "pictures.\n"
)
COLUMNS = "| players | crossings needed | needs | on an easy way | presses | turns of down | tightest jump | seconds | difficulty |"


class PageError(Exception):
    """The page cannot be made."""


def facts_of(tool, root, level):
    """The facts of the recorded way of a level."""
    recording = root / f"levels/data/ways/{level.stem}.recording"
    command = [str(tool), "solve", str(level), "--recorded", str(recording), "--json"]
    done = subprocess.run(command, capture_output=True, text=True)
    if done.returncode != 0:
        raise PageError(done.stderr.strip())
    return json.loads(done.stdout)


def head_of(level):
    """Title, players, crossings and idea of a level: what its text says before the solid."""
    head = {"players": "1", "crossings": "0", "needs": "–", "idea": []}
    for line in level.read_text(encoding="utf-8").splitlines():
        if not line.strip():
            continue
        if not line.startswith("#"):
            head["solid"] = line.split()[0].lower()
            break
        word, _, value = line[1:].strip().partition(":")
        if word in ("title", "author", "players", "crossings", "needs"):
            head[word] = value.strip()
        else:
            head["idea"].append(line[1:].strip())
    return head


def section(tool, root, level):
    head, facts = head_of(level), facts_of(tool, root, level)
    slack = "–" if facts["slack"] is None else f"{facts['slack']} ticks"
    row = [head["players"], head["crossings"], head["needs"], facts["crossings"], facts["presses"], facts["turns"], slack,
           f"{facts['ticks'] / 60:.1f}", facts["difficulty"]]
    title = head["title"]
    article = "an" if head["solid"][0] in "io" else "a"
    return "\n".join((
        f"### {level.stem[:2]} {title}", "", " ".join(head["idea"]), "", COLUMNS, "|" + "---|" * len(row),
        "| " + " | ".join(map(str, row)) + " |", "",
        f"![{title}: {article} {head['solid']} from two sides, and its net](pictures/level_{level.stem}.png)", ""))


def heading(folder):
    """What is common to the levels of a folder: their solid, or that they were drawn by following editor.md."""
    return "Drawn in the editor" if folder.name == "drawn" else folder.name.capitalize()


def counted(levels):
    """How many levels there are in each folder, in order."""
    folders = {}
    for level in levels:
        folders.setdefault(level.parent, []).append(level)
    return ", ".join(f"{heading(folder).lower()} {len(found)}" for folder, found in folders.items())


def page(tool, root):
    levels = sorted(root.glob("levels/data/*/*.level"), key=lambda path: path.name)
    several = sum(head_of(level)["players"] != "1" for level in levels)
    parts = [INTRODUCTION.format(count=len(levels), solids=counted(levels), several=several)]
    folder = None
    for level in levels:
        if level.parent != folder:
            folder = level.parent
            parts.append(f"## {heading(folder)}\n")
        parts.append(section(tool, root, level))
    return "\n".join(parts)


def write(tool, root):
    """Writes the page and returns its file."""
    file = root / PAGE
    file.write_text(page(tool, root), encoding="utf-8")
    return file


def main(arguments):
    check = arguments[2:] == ["--check"]
    if len(arguments) != (3 if check else 2):
        print(__doc__, file=sys.stderr)
        return 2
    tool, root = Path(arguments[0]).resolve(), Path(arguments[1]).resolve()
    try:
        if not check:
            print(write(tool, root))
            return 0
        if (root / PAGE).read_text(encoding="utf-8") == page(tool, root):
            return 0
    except (PageError, OSError) as error:
        print(f"levels_page.py: {error}", file=sys.stderr)
        return 1
    print(f"{PAGE} is not that of the levels: run ./platon pictures", file=sys.stderr)
    return 1


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
