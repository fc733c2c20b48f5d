"""The generated part of a page of the docs."""

END = "<!-- end of measured -->"


class PageError(Exception):
    """The page lacks the markers of its generated part."""


def begin_of(command):
    return f"<!-- measured: by ./platon bench --{command}, do not edit by hand -->"


def with_part(text, part, command="network"):
    begin = begin_of(command)
    before, found, rest = text.partition(begin)
    _, end, after = rest.partition(END)
    if not found or not end:
        raise PageError(f"'{begin}' and '{END}' are missing")
    return f"{before}{begin}\n\n{part.strip()}\n\n{END}{after}"


def replace_part(page, part, command="network"):
    page.write_text(with_part(page.read_text(encoding="utf-8"), part, command), encoding="utf-8")
