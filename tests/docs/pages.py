"""The pages of the docs and their parts."""

import re

FENCE = re.compile(r"^```.*?^```$", re.MULTILINE | re.DOTALL)
HEADING = re.compile(r"^#{1,6} (.+)$", re.MULTILINE)
LINK = re.compile(r"!?\[[^\]]*\]\(([^)\s]+)\)")
CODE = re.compile(r"`([^`\n]+)`")


def pages(root):
    """Every page as (path relative to root, text)."""
    for path in sorted([*root.glob("*.md"), *root.glob("docs/*.md")]):
        yield path.relative_to(root), path.read_text(encoding="utf-8")


def anchor_of(heading):
    """The anchor that GitHub makes of a heading."""
    return re.sub(r"[^\w\- ]", "", heading.replace("`", "").strip().lower()).replace(" ", "-")


def anchors(text):
    return {anchor_of(heading) for heading in HEADING.findall(FENCE.sub("", text))}


def links(text):
    return LINK.findall(FENCE.sub("", text))


def code_words(text):
    """Every word in `code` and in fenced blocks."""
    blocks = FENCE.findall(text)
    spans = CODE.findall(FENCE.sub("", text))
    return [word.strip(",;:()") for part in [*blocks, *spans] for word in part.split()]
