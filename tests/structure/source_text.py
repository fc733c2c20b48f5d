"""C++ text without comments and strings."""

import re

_TOKEN = re.compile(
    r"""
    (?P<comment>//[^\n]*|/\*.*?\*/)
  | (?P<raw>(?:u8|[uUL])?R"(?P<mark>[^()\\\s]{0,16})\(.*?\)(?P=mark)")
  | (?P<string>"(?:\\.|[^"\\\n])*")
  | (?P<number>\d(?:'?[\w.])*)
  | (?P<character>'(?:\\.|[^'\\\n])+')
  | (?P<word>(?:std::)?[A-Za-z_]\w*)
    """,
    re.VERBOSE | re.DOTALL,
)

_INCLUDE = re.compile(r'^[ \t]*#[ \t]*include[ \t]*(?P<open>[<"])(?P<name>[^>"\n]+)[>"]', re.MULTILINE)

_INCLUDE_LINE = re.compile(r"^[ \t]*#[ \t]*include[^\n]*", re.MULTILINE)


def _blank(text):
    return re.sub(r"[^\n]", " ", text)


def code_of(text, keep_strings=False):
    """The text with comments replaced by blanks, and strings too unless kept. Lines and columns stay the same."""

    def replaced(match):
        kind = match.lastgroup if match.lastgroup != "mark" else "raw"
        dropped = kind == "comment" or (not keep_strings and kind in ("raw", "string"))
        return _blank(match.group()) if dropped else match.group()

    return _TOKEN.sub(replaced, text)


def line_of(text, offset):
    """The 1-based line of an offset."""
    return text.count("\n", 0, offset) + 1


def includes_of(text):
    """Yields (line, header, quoted) of every #include outside comments."""
    code = code_of(text, keep_strings=True)
    for match in _INCLUDE.finditer(code):
        yield line_of(code, match.start("open")), match["name"], match["open"] == '"'


def words_of(code):
    """Yields (offset, word) of every identifier and number in the result of code_of, except in #include lines. Names
    of the standard library keep a written `std::`."""
    without_includes = _INCLUDE_LINE.sub(lambda match: _blank(match.group()), code)
    for match in _TOKEN.finditer(without_includes):
        if match.lastgroup in ("word", "number"):
            yield match.start(), match.group()


def is_float_literal(word):
    """True for 1.5, 1e3, 1.f; false for 1'000u, 0x1e5 and names."""
    if word[:2].lower() == "0x":
        return "p" in word.lower()
    return "." in word or bool(re.fullmatch(r"[\d']+[eE]\d*[fFlL]?", word))
