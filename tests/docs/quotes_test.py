#!/usr/bin/env python3
"""Compares what a page says of another page, or of a list in the sources, with that page or list. Runs no program.

usage: quotes_test.py ROOT

Each error is a line `page: what`; exit 1 if there is any.
"""

import re
import sys
from pathlib import Path

import pages
from figures_test import Figures, FigureError, Sources, compare, joined, quoted

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "determinism/machines"))
from machine import MACHINES, Machine  # noqa: E402

SPEED = "docs/speed_vs_error.md"
NETCODE = "docs/netcode.md"
EXACTNESS = "docs/exactness.md"
DOWN = quoted(NETCODE, r"\| 16 \| (\d\.\d+) kB/s \|")
WORST_DOWN = quoted(NETCODE, r"\| down, a player of 16 \| [^|]* \| (\d\.\d+) kB/s")
WALKS = r"at most \d\.\d+ on one face, {} on several, {} in narrow places"


def share_of_ray(sources):
    [part] = quoted("client/scene/camera_target.cpp", r"kPartOfRay = ([\d.]+)")(sources)
    return [f"{100 * float(part):.0f}"]


def walks(place):
    """The largest distance from the ideal trajectory of the walks over edges."""
    marked = WALKS.format(*(r"(\d\.\d+)" if place == here else r"\d\.\d+" for here in range(2)))
    return quoted(EXACTNESS, marked)


QUOTES = [
    Figures("README.md", "**{} ×** | the step time of Box2D 2.4", quoted(SPEED, r"(\d\.\d+) times that of box2d-2.4")),
    Figures("README.md", "and {} × that of Chipmunk 7", quoted(SPEED, r"(\d\.\d+) times that of chipmunk-7.0")),
    Figures("README.md", "in {} % of the half seconds", quoted(SPEED, r"chipmunk-7.0 \(jammed in (\d+\.\d) % of")),
    Figures("README.md", "A Platon step takes {} × the time", quoted(SPEED, r"(\d\.\d+) times that of float64")),
    Figures("README.md", "**{} kB/s** | from the server to each of 16 players on a perfect connection", DOWN),
    Figures("README.md", "and {} kB/s on the worst", WORST_DOWN),
    Figures("README.md", "{} of {} limits are exceeded", joined(quoted(NETCODE, r"(\d+) of \d+ limits"), quoted(NETCODE, r"\d+ of (\d+) limits"))),
    Figures("README.md", "Over edges {} were measured, and {} in narrow places", joined(walks(0), walks(1))),
    Figures("README.md", "the camera leans by {} %", share_of_ray),
    Figures("docs/fleet.md", "a player of 16 is sent {} kB/s there, and {} kB/s on the worst", joined(DOWN, WORST_DOWN)),
]  # fmt: skip

WORDS = "no one two three four five six seven eight nine ten eleven twelve".split()
BUILDS = re.compile(r"\b(\w+) builds(?: of the simulation,)? for (\w+) architectures")
EMULATED = re.compile(r"\b(\w+)(?: of them)? emulated")
NUMBER = f"(?:{'|'.join(WORDS)})"
MACHINES_COMPARED = re.compile(rf"\b(?:bit|recordings|simulation|hash\w*)\b[^.|]*? (?:on|for) {NUMBER} machines|compares {NUMBER} machines|{NUMBER} machines are compared")
WITH_BUILDS = ("README.md", "CONTRIBUTING.md", "docs/architecture.md", "platon")


def counts_of(machines):
    """How many builds are compared, for how many architectures, and how many of these are emulated, in words."""
    architectures = {machine.what.split(",")[0] for machine in machines}
    emulated = {machine.what.split(",")[0] for machine in machines if any("qemu" in word for word in machine.runner)}
    return [WORDS[count] for count in (len(machines), len(architectures), len(emulated))]


def build_errors(page, text, machines):
    """The errors of what a text says about the builds that are compared."""
    builds, architectures, emulated = counts_of(machines)
    flat = " ".join(text.split())
    for found in BUILDS.finditer(flat):
        if [found[1].lower(), found[2]] != [builds, architectures]:
            yield f"{page}: '{found[0]}', but there are {builds} builds for {architectures} architectures"
    for found in EMULATED.finditer(flat) if BUILDS.search(flat) else ():
        if found[1] in WORDS and found[1] != emulated:
            yield f"{page}: '{found[0]}', but {emulated} architectures are emulated"
    for wrong in MACHINES_COMPARED.findall(flat):
        yield f"{page}: '{wrong}', but builds are compared, all of them on one machine"


# Pages whose steps a reader of a checkout runs as they are written.
OF_CHECKOUT = ("README.md", "docs/editor.md")
BLOCK = re.compile(r"^ *```.*?^ *```$", re.MULTILINE | re.DOTALL)   # also in a list


def step_errors(page, text):
    """The commands of a page that are not found in a checkout: programs without their folder."""
    for block in BLOCK.findall(text):
        for line in block.splitlines():
            if re.match(r"\s*platon-\w+ ", line):
                yield f"{page}: '{line.strip()}' is not found in a checkout: write ./platon or build/release/bin/"


def errors_of(root):
    sources = Sources(root, root)
    for quote in QUOTES:
        try:
            yield from compare(sources, quote, False)
        except FigureError as error:
            yield f"{quote.page}: '{quote.sentence}': {error}"
    texts = {str(page): text for page, text in pages.pages(root)} | {"platon": (root / "platon").read_text(encoding="utf-8")}
    for page, text in texts.items():
        yield from build_errors(page, text, list(MACHINES.values()))
    for page in OF_CHECKOUT:
        yield from step_errors(page, texts[page])
    for page in WITH_BUILDS:
        if not BUILDS.search(" ".join(texts[page].split())):
            yield f"{page}: does not say how many builds are compared"


def main(arguments):
    if len(arguments) != 1:
        print(__doc__, file=sys.stderr)
        return 2
    errors = list(errors_of(Path(arguments[0]).resolve()))
    for error in errors:
        print(error)
    return 1 if errors else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
