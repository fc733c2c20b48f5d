"""Where a fault can be put in a C++ source, found from its tokens. Comments, strings, directives and assertions have none.

A fault is a small slip that compiles more often than not:

comparison   < for <=, > for >=, == for !=, and back
constant     a number one larger, one smaller or 0; true for false, and back
negation     the condition of an `if` or a `while`
logic        && for ||, and back
arithmetic   + for -, += for -=, ++ for --, and back
statement    an assignment, an increment, or a call whose result is not used, is dropped
check        an `if (…)` that only returns, continues, breaks or throws is dropped
arguments    two neighbouring arguments of a call are exchanged
"""

import re
from dataclasses import dataclass

from tokens import CLOSERS, Tokens

EXCHANGED = {
    "comparison": (("<", "<="), (">", ">="), ("==", "!=")),
    "logic": (("&&", "||"),),
    "arithmetic": (("+", "-"), ("+=", "-="), ("++", "--")),
}
OPERATORS = (*EXCHANGED, "constant", "negation", "statement", "check", "arguments")

# A binary one has blanks around it, which tells it from a template, a reference and a sign.
SPACED = {"<", "<=", ">", ">=", "==", "!=", "&&", "||", "+", "-"}
LEAVING = {"return", "continue", "break", "throw"}
ASSIGNING = {"=", "+=", "-=", "*=", "/=", "%=", "&=", "|=", "^=", "<<=", ">>="}
KEYWORDS = LEAVING | set(
    "if else for while do switch case default catch try goto using typedef static constexpr const auto delete new sizeof "
    "static_assert assert decltype noexcept alignof template friend struct class enum operator co_return co_await".split()
)
ALIKE = {"min", "max", "minmax", "gcd", "lcm", "dot", "swap"}  # with their arguments exchanged, too

_INTEGER = re.compile(r"(0[xX][\da-fA-F']+|0[bB][01']+|\d[\d']*)([a-zA-Z_]\w*)?")
_FLOAT = re.compile(r"(\d*\.?\d*(?:[eE][+-]?\d+)?)([a-zA-Z_]\w*)?")
# The target of an assignment or a call: names joined by . -> ::, each with brackets behind it; no declaration.
_TARGET = re.compile(r"\*?(?:::)?n(?:[([]|<>)*(?:(?:\.|->|::)n(?:[([]|<>)*)*")


@dataclass(frozen=True)
class Site:
    """Replaces text[begin:end]."""

    begin: int
    end: int
    replaced: str
    operator: str


def changed_constants(text):
    """The numbers that may take the place of this one."""
    integer = _INTEGER.fullmatch(text)
    if integer:
        digits = integer[1].replace("'", "")
        octal = len(digits) > 1 and digits[0] == "0" and digits.isdigit()
        value = int(digits, 8) if octal else int(digits, 0)
        found = (value + 1, value - 1, 0)
        return [f"{other}{integer[2] or ''}" for other in dict.fromkeys(found) if other >= 0 and other != value]
    number = _FLOAT.fullmatch(text)
    if not number or not any(digit.isdigit() for digit in number[1]):
        return []
    value = float(number[1])
    found = (value + 1, value - 1, 0.0)
    return [f"{other!r}{number[2] or ''}" for other in dict.fromkeys(found) if other >= 0 and other != value]


class Finder:
    """Finds the sites of one source."""

    def __init__(self, text):
        self._text = text
        self._tokens = Tokens(text)
        self._skipped = self._asserted()

    def sites(self):
        found = [*self._tokens_changed(), *self._statements_changed(), *self._arguments_exchanged()]
        return sorted(found, key=lambda site: (site.begin, site.end, site.operator, site.replaced))

    def _site(self, first, last, replaced, operator):
        tokens = self._tokens
        return Site(tokens[first].begin, tokens[last].end, replaced, operator)

    def _source(self, first, last):
        return self._text[self._tokens[first].begin : self._tokens[last].end]

    def _asserted(self):
        """Tokens of assertions and of declarations that only name something."""
        skipped = set()
        for index, token in enumerate(self._tokens):
            if token.text in ("static_assert", "assert", "using", "typedef", "namespace", "friend"):
                last = self._tokens.end_of_statement(index)
                if token.text == "namespace":
                    last = index + 1
                skipped.update(range(index, last + 1))
        return skipped

    def _tokens_changed(self):
        for index, token in enumerate(self._tokens):
            if index in self._skipped:
                continue
            if token.kind == "number":
                yield from (self._site(index, index, other, "constant") for other in changed_constants(token.text))
            elif token.text in ("true", "false"):
                yield self._site(index, index, "false" if token.text == "true" else "true", "constant")
            elif token.kind == "operator":
                yield from self._exchanged(index)

    def _exchanged(self, index):
        token = self._tokens[index]
        if token.text in SPACED and not self._is_spaced(token):
            return
        if index > 0 and self._tokens[index - 1].text == "operator":
            return
        if token.text in ("++", "--") and self._tokens.opener(index) == "for":
            return  # a loop without an end is found too easily
        for operator, pairs in EXCHANGED.items():
            for pair in pairs:
                if token.text in pair:
                    yield self._site(index, index, pair[1 - pair.index(token.text)], operator)

    def _is_spaced(self, token):
        return self._text[token.begin - 1 : token.begin].isspace() and self._text[token.end : token.end + 1].isspace()

    def _statements_changed(self):
        for first in self._tokens.statements():
            if first in self._skipped:
                continue
            word = self._tokens[first].text
            if word in ("if", "while"):
                yield from self._condition_changed(first)
            elif word not in KEYWORDS and word != "{" and word != ";":
                last = self._tokens.end_of_statement(first)
                if self._is_droppable(first, last):
                    yield self._site(first, last, ";", "statement")

    def _condition_changed(self, first):
        tokens = self._tokens
        if tokens[first + 1].text != "(":
            return  # if constexpr
        opened = first + 1
        closed = tokens.match[opened]
        begin = max([opened, *tokens.at_depth(opened, closed, {";"})]) + 1
        if begin < closed and not tokens.at_depth(begin - 1, closed, {"="}):
            yield self._site(begin, closed - 1, f"!({self._source(begin, closed - 1)})", "negation")
        if tokens[first].text == "if" and self._only_leaves(closed + 1):
            last = tokens.end_of_body(closed + 1)
            if tokens.text(last + 1) != "else":
                yield self._site(first, last, ";", "check")

    def _only_leaves(self, first):
        tokens = self._tokens
        if tokens.text(first) != "{":
            return tokens.text(first) in LEAVING
        return tokens.text(first + 1) in LEAVING and tokens.end_of_statement(first + 1) + 1 == tokens.match[first]

    def _is_droppable(self, first, last):
        tokens = self._tokens
        if tokens[first].text in ("++", "--") or tokens[last - 1].text in ("++", "--"):
            return True
        assigned = tokens.at_depth(first - 1, last, ASSIGNING)
        if assigned:
            return self._is_target(first, assigned[0]) and tokens.text(assigned[0] + 1) not in ("default", "delete")
        return tokens[last - 1].text == ")" and self._is_target(first, last)

    def _is_target(self, first, end):
        shape = ""
        index = first
        while index < end:
            token = self._tokens[index]
            if token.kind == "word":
                shape += " " if token.text in KEYWORDS else "n"
            elif token.text in CLOSERS and index in self._tokens.match:
                shape += token.text
                index = self._tokens.match[index]
            elif token.text == "<" and not self._is_spaced(token):
                index = self._tokens.end_of_template(index)
                shape += "<>"
            else:
                shape += token.text
            index += 1
        return _TARGET.fullmatch(shape) is not None

    def _is_range(self, one, other):
        """Whether an argument ends in begin() or end(): exchanged, these are found too easily."""
        return any(self._tokens[last - 2].text in ("begin", "end") for last in (one, other))

    def _arguments_exchanged(self):
        tokens = self._tokens
        for opened in range(1, len(tokens)):
            name = tokens[opened - 1]
            if tokens[opened].text != "(" or opened in self._skipped or not tokens.is_in_function(opened):
                continue
            if name.text in KEYWORDS | ALIKE or (name.kind != "word" and name.text != ">"):
                continue
            arguments = tokens.arguments(opened)
            for one, other in zip(arguments, arguments[1:]):
                if self._source(*one) != self._source(*other) and not self._is_range(one[1], other[1]):
                    between = self._text[tokens[one[1]].end : tokens[other[0]].begin]
                    exchanged = self._source(*other) + between + self._source(*one)
                    yield self._site(one[0], other[1], exchanged, "arguments")
