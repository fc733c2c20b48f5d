#!/usr/bin/env python3
"""Reminds of the other side: the definitions of the C++ and those that are proved stand beside each other in the table of
shared/proof/README.md, with a sum of the tokens of each. Fails where one has changed since both were last compared, and where
a page names a theorem of a file that has none of this name.

usage: check_counterparts.py ROOT [--accept]

--accept writes the new sums into the table: do it after you have compared both sides.
"""

import hashlib
import re
import sys
from pathlib import Path

from check_proof import ProofError, without_comments

sys.path.append(str(Path(__file__).resolve().parents[1] / "structure"))
from source_text import code_of  # noqa: E402

TABLE = "shared/proof/README.md"
# | `Class::function` | `path/of/the.cpp` | `definition`, `another` | `file.v` | sum sum |
ROW = re.compile(r"^\| `(?P<function>[\w:<=>]+)` \| `(?P<source>[\w/.]+)` \| (?P<names>`\w+`(?:, `\w+`)*) \| `(?P<proof>\w+\.v)` \| "
                 r"(?P<sums>[0-9a-f]{6} [0-9a-f]{6}) \|$", re.MULTILINE)  # fmt: skip
PAGES = ("docs/exactness.md", "docs/proof.md", TABLE)
# [`theorem`, `another`](../shared/proof/file.v), or a row: | `file.v` | ... (`theorem`) ... | of the C++ |
NAMED = re.compile(r"\[(?P<linked>`\w+`(?:, `\w+`)*)\]\([\w./]*/(?P<target>\w+\.v)\)|^\| `(?P<file>\w+\.v)` \| (?P<states>[^|]*) \|", re.MULTILINE)
CLOSERS = {"(": ")", "{": "}"}


def end_of_bracket(text, opened):
    """The index behind the bracket that closes the one at `opened`."""
    depth = 0
    for index in range(opened, len(text)):
        depth += (text[index] == text[opened]) - (text[index] == CLOSERS[text[opened]])
        if depth == 0:
            return index + 1
    raise ProofError(f"a bracket is not closed: {text[opened:opened + 40]}")


def start_of_declaration(text, index):
    """Where the declaration begins in which a name stands: behind the last semicolon, brace, label or directive before it."""
    ends = [match.end() for match in re.finditer(r"[;{}]|\b(?:public|private|protected):|^[ \t]*#[^\n]*", text[:index], re.MULTILINE)]
    return ends[-1] if ends else 0


def cpp_definitions(text, name):
    """The text of each definition: of a function, which may have overloads, a type or a constant."""
    found = []
    for match in re.finditer(rf"(?<![\w:.>]){re.escape(name)}(?!\w)", text):
        begin, behind = start_of_declaration(text, match.start()), match.end()
        if constant := re.compile(r"\s*(?:=[^;]*|\{[^;{}]*\});").match(text, behind):
            found.append(text[begin:constant.end()])
            continue
        if text.startswith("(", behind):
            behind = end_of_bracket(text, behind)
        elif not re.search(r"\b(?:struct|class)\s+$", text[begin:match.start()]):
            continue
        if body := re.compile(r"[\s\w]*(?=\{)").match(text, behind):
            found.append(text[begin:end_of_bracket(text, body.end())])
    return found


def coq_definitions(text, name):
    return re.findall(rf"^(?:Definition|Fixpoint|Record|Inductive) {name}\b.*?\.(?=\s)", text, re.MULTILINE | re.DOTALL)


def defined(found, what):
    if not found:
        raise ProofError(f"{TABLE}: {what} is not defined: mend the table")
    return found


def sum_of(texts):
    tokens = re.findall(r"\w+|[^\w\s]", " ".join(texts))
    return hashlib.sha256(" ".join(tokens).encode()).hexdigest()[:6]


def sums_of(root, row):
    """The sums of both sides of a row of the table."""
    source = code_of((root / row["source"]).read_text(encoding="utf-8"), keep_strings=True)
    proof = without_comments((root / "shared/proof" / row["proof"]).read_text(encoding="utf-8"))
    definitions_there = defined(cpp_definitions(source, row["function"]), f"{row['function']} in {row['source']}")
    definitions = [
        text for name in re.findall(r"\w+", row["names"]) for text in defined(coq_definitions(proof, name), f"{name} in {row['proof']}")
    ]
    return sum_of(definitions_there), sum_of(definitions)


def changes(root, text):
    """Yields a sentence for each side that has changed."""
    for row in ROW.finditer(text):
        for now, before, side, other in zip(sums_of(root, row), row["sums"].split(), (f"{row['function']} in {row['source']}",
                                            f"{row['names']} in shared/proof/{row['proof']}"), (row["names"], row["function"]), strict=True):  # fmt: skip
            if now != before:
                yield f"{side} has changed: compare it with {other}, then run check_counterparts.py . --accept"


def unknown_theorems(root):
    """Yields a sentence for each theorem that a page names and its file does not have."""
    for page in PAGES:
        for named in NAMED.finditer((root / page).read_text(encoding="utf-8")):
            file = named["target"] or named["file"]
            theorems = re.findall(r"^Theorem (\w+)", (root / "shared/proof" / file).read_text(encoding="utf-8"), re.MULTILINE)
            for name in re.findall(r"`(\w+)`", named["linked"] or named["states"]):
                if (named["linked"] or "_" in name) and name not in theorems:
                    yield f"{page}: {name} is no theorem of shared/proof/{file}: mend the page"


def main(arguments):
    if len(arguments) not in (1, 2) or arguments[1:] not in ([], ["--accept"]):
        sys.exit(__doc__)
    root = Path(arguments[0]).resolve()
    table = root / TABLE
    text = table.read_text(encoding="utf-8")
    try:
        if arguments[1:]:
            accepted = ROW.sub(lambda row: f"{row[0][:row.start('sums') - row.start()]}{' '.join(sums_of(root, row))} |", text)
            table.write_text(accepted, encoding="utf-8")
            return
        found = [*changes(root, text), *unknown_theorems(root)]
    except ProofError as error:
        sys.exit(str(error))
    if found:
        sys.exit("\n".join(found))
    print(f"{len(ROW.findall(text))} definitions are as they were when they were compared with their proved counterparts")


if __name__ == "__main__":
    main(sys.argv[1:])
