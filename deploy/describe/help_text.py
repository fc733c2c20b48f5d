"""What a program prints for --help, as parts."""

import re
import subprocess
from dataclasses import dataclass, field

TERM_WIDTH = 30  # columns of an option; a text that does not fit beside it begins in the next line
FLAGS = re.compile(r"^(?:(-\w)(?:,|$|(?= )))?(--[\w-]+)?")


@dataclass
class Entry:
    """An option, an argument or a command: `--port N` and what it does."""

    term: str
    text: str = ""

    @property
    def short(self):
        return FLAGS.match(self.term)[1]

    @property
    def long(self):
        return FLAGS.match(self.term)[2]

    @property
    def value(self):
        """The word for the value, such as FILE; empty for a flag."""
        rest = self.term[FLAGS.match(self.term).end() :].split("Excludes:")[0].split("Needs:")[0].split()
        return rest[0].partition(":")[0].partition("=")[0] if rest and rest[0] != "REQUIRED" else ""


@dataclass
class Help:
    """A page of help: of a program, or of one of its commands."""

    name: str
    summary: str
    usage: str
    groups: dict = field(default_factory=dict)  # {title: entries}
    commands: list = field(default_factory=list)  # the Help of each command
    verbatim: str = ""  # a page in another form, as it is

    def options(self):
        groups = (entries for title, entries in self.groups.items() if title not in ("Positionals", "Subcommands"))
        return [entry for entries in groups for entry in entries]


def _printed(*command):
    return subprocess.run(command, stdout=subprocess.PIPE, text=True, check=True, timeout=60).stdout


def _entries(lines):
    found = []
    for line in lines:
        if re.match(r"  \S", line):
            term, _, text = line[2:].partition("  ") if len(line) > TERM_WIDTH else (line[2:], "", "")
            found.append(Entry(term.strip(), text.strip()))
        elif line.strip():
            found[-1].text = f"{found[-1].text} {line.strip()}".strip()
    return found


def parse(name, text):
    """The parts of a page as CLI11 prints it; a page without `Usage:` is kept as it is."""
    if "\nUsage: " not in text:
        summary = text.partition("\n")[0].removeprefix(f"{name}: ")
        return Help(name, summary, "", verbatim=text.partition("\n")[2].strip("\n"))
    head, _, rest = text.partition("\nUsage: ")
    usage, _, body = rest.partition("\n")
    page = Help(name, head.removeprefix(f"{name}: ").strip(), usage)
    for part in re.split(r"\n(?=\S)", body):
        title, _, lines = part.strip("\n").partition("\n")
        if title:
            page.groups[title.rstrip(":")] = _entries(lines.split("\n"))
    return page


def read_help(program, name):
    """The help of a program and of its commands."""
    page = parse(name, _printed(program, "--help"))
    for command in page.groups.get("Subcommands", []):
        page.commands.append(parse(command.term, _printed(program, command.term, "--help")))
    return page


def version_of(program):
    return _printed(program, "--version").split()[-1]
