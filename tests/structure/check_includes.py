#!/usr/bin/env python3
"""Checks every #include of the product against the links of CMake's targets, which are the plan of what may include what.

usage: check_includes.py ROOT. Writes the table of the links into docs/architecture.md, and prints it. Configuring writes the
links to plan.json in the build folder: {parts: {target: {property: values}}, outside: {header or folder of headers: target}}.
"""

import json
import sys
from pathlib import Path

import source_text

PAGE = "docs/architecture.md"
MARK = "<!-- table: folders -->\n"
SHARED = {"exact", "physics", "game"}
MAY_USE = {"exact": set(), "physics": {"exact"}, "game": {"exact", "physics"}, "protocol": SHARED, "levels": SHARED | {"protocol"},
           "server": SHARED | {"protocol"}, "client": SHARED | {"protocol", "levels", "server"}}  # fmt: skip
# The servers inside the client, the levels and times that they have, and the program, which prepares them.
EMBEDDED_SERVER = {"local_server", "embedded_server", "shipped_levels", "main"}


class Plan:
    """Which part of the tree each target of the product has, and what it links."""

    def __init__(self, described):
        self.beginnings = {part: row["platon_beginnings"] for part, row in described["parts"].items()}
        self.owners = {name: part for part, names in self.beginnings.items() for name in names}
        self.outside = described["outside"]
        # {part: {target: whether the link is PUBLIC}}
        self.links = {part: {link: link in row["INTERFACE_LINK_LIBRARIES"] for kind in ("LINK_LIBRARIES", "INTERFACE_LINK_LIBRARIES")
                             for link in row[kind]} for part, row in described["parts"].items()}  # fmt: skip

    def owner(self, path):
        """The target that has a file of the product; None if none has."""
        return self.owners.get(max((name for name in self.owners if path.startswith(name)), key=len, default=None))

    def provider(self, header):
        """The target that must be linked to include a header; None if there is none."""
        folders = (header[: at + 1] for at, letter in enumerate(header) if letter == "/")
        return next((self.outside[name] for name in (header, *folders) if name in self.outside), None) or self.owner(path_of(header))

    def area(self, target):
        """A key of MAY_USE; None for what is not of this tree."""
        top, *inner = self.beginnings.get(target, [""])[0].split("/")
        return (inner[0] if top == "shared" else top) or None

    def fault_of_link(self, part, link):
        """Why the first may not link the second, whatever it includes; None if it may."""
        order, area = list(self.links), self.area(part)
        if self.area(link) not in {None, area} | MAY_USE[area]:
            return f"{part} links {link}: {area} may not use {self.area(link)}"
        later = link in order and order.index(link) >= order.index(part)
        return f"{part} links {link}, which CMake defines later" if later else None

    def fault_of_include(self, path, header):
        """Why a file may not include a header of a target that is not its own; None if it may."""
        part, target = self.owner(path), self.provider(header)
        if target not in self.links[part]:
            return f"{part} does not link {target}, which has {header}"
        if header.startswith("shared/") and self.area(part) not in SHARED:
            return f"{header} is private to shared/"
        alone = self.area(target) == "server" and self.area(part) == "client" and Path(path).stem not in EMBEDDED_SERVER
        return f"of the client, only the embedded server may include {header}" if alone else None


def read_plan(root, file=None):
    """The plan in `file`, or that of the newest build of the tree."""
    plans = [Path(file)] if file else sorted(root.glob("build/*/plan.json"), key=lambda path: path.stat().st_mtime)
    if not plans:
        raise ValueError("there is no build/*/plan.json: configure with cmake --preset release")
    for lists in (root / "CMakeLists.txt", *root.glob("*/CMakeLists.txt")):
        if lists.stat().st_mtime > plans[-1].stat().st_mtime:
            raise ValueError(f"{plans[-1]} is older than {lists}: configure again")
    return Plan(json.loads(plans[-1].read_text(encoding="utf-8")))


def path_of(header):
    """The path, from the root of the tree, of a file that is included as `header`."""
    return f"shared/include/{header}" if header.startswith("platon/") else header


def check_includes(plan, files, root):
    """Yields every #include that the links do not allow, and every link that no #include needs. `files`: {path: text}."""
    used = {part: {} for part in plan.links}  # {part: {target: whether a header includes it}}
    for path, text in files.items():
        part = plan.owner(path)
        if part is None:
            yield f"{path}:1: no target of CMake has this file"
        for line, header, quoted in source_text.includes_of(text) if part else ():
            target = plan.provider(header)
            if target is None and (quoted or not header.isidentifier()):
                yield f"{path}:{line}: {header} is neither a path from the root of the tree nor a platon_outside of CMakeLists.txt"
            elif target and header not in plan.outside and target in plan.links and not (root / path_of(header)).is_file():
                yield f"{path}:{line}: {header} does not exist"
            elif target not in (None, part):
                used[part][target] = used[part].get(target, False) or path.endswith(".h")
                if fault := plan.fault_of_include(path, header):
                    yield f"{path}:{line}: {fault}"
    for part, links in plan.links.items():
        place = plan.beginnings[part][0].split("/")[0] + "/CMakeLists.txt:1"
        for link, public in links.items():
            if link not in used[part]:
                yield f"{place}: {part} links {link}, of which it includes nothing"
            elif public != used[part][link]:
                yield f"{place}: {part} must link {link} {'PRIVATE: no header' if public else 'PUBLIC: a header'} of it includes that"
            if fault := plan.fault_of_link(part, link):
                yield f"{place}: {fault}"


def table(page, name):
    """The rows of the table under `<!-- table: name -->`, each a list of cells, without the head."""
    lines = page.partition(f"<!-- table: {name} -->\n")[2].partition("\n\n")[0].splitlines()
    if len(lines) < 3:
        raise ValueError(f"no table under '<!-- table: {name} -->'")
    return [[cell.strip() for cell in line.strip("|").split(" |")] for line in lines[2:]]


def with_table(plan, page):
    """The page with the table of the links. What its rows say in words stays."""
    words = {row[0]: (row[1], row[-1]) for row in table(page, "folders")}
    names = {part: [f"`{name[:-1] if name.endswith('/') else name + '*'}`" for name in plan.beginnings[part]] for part in plan.links}
    rows = ["| files | hold | link PUBLIC | link PRIVATE | may never |", "|---|---|---|---|---|"]
    for part, links in plan.links.items():
        hold, never = words.get(" ".join(names[part]), ("", ""))
        public, private = (" ".join(names.get(link, [link])[0] for link in links if links[link] == kind) for kind in (True, False))
        rows.append(f"| {' '.join(names[part])} | {hold} | {public} | {private} | {never} |")
    before, mark, after = page.partition(MARK)
    return before + mark + "\n".join(rows) + "\n\n" + after.partition("\n\n")[2]


def check_page(plan, page):
    """Yields a violation if the table of the page is not that of the links, or says nothing of a folder."""
    if with_table(plan, page) != page:
        yield f"{PAGE}:1: its table of folders is not that of the links: run python3 -B tests/structure/check_includes.py ."
    for row in table(page, "folders"):
        if not row[1]:
            yield f"{PAGE}:1: the row of {row[0]} does not say what they hold"


if __name__ == "__main__":
    page_file = Path(sys.argv[1]) / PAGE
    page_file.write_text(with_table(read_plan(Path(sys.argv[1])), page_file.read_text(encoding="utf-8")), encoding="utf-8")
    print(page_file.read_text(encoding="utf-8").partition(MARK)[2].partition("\n\n")[0])
