"""The generated part of docs/netcode.md."""

BEGIN = "<!-- measured: by ./platon bench --network, do not edit by hand -->"
END = "<!-- end of measured -->"


class PageError(Exception):
    """The page lacks the markers of its generated part."""


def with_part(text, part):
    before, begin, rest = text.partition(BEGIN)
    _, end, after = rest.partition(END)
    if not begin or not end:
        raise PageError(f"'{BEGIN}' and '{END}' are missing")
    return f"{before}{BEGIN}\n\n{part.strip()}\n\n{END}{after}"


def replace_part(page, part):
    page.write_text(with_part(page.read_text(encoding="utf-8"), part), encoding="utf-8")
