"""C++ text as tokens, with their brackets, the statements of functions and the arguments of calls."""

import re
import sys
from dataclasses import dataclass
from pathlib import Path

sys.path.append(str(Path(__file__).resolve().parents[1] / "structure"))
from source_text import code_of  # noqa: E402

_TOKEN = re.compile(
    r"""
    (?P<directive>^[ \t]*\#(?:\\\n|[^\n])*)
  | (?P<string>(?:u8|[uUL])?R"(?P<mark>[^()\\\s]{0,16})\(.*?\)(?P=mark)"\w* | (?:u8|[uUL])?"(?:\\.|[^"\\\n])*"\w*)
  | (?P<character>'(?:\\.|[^'\\\n])+')
  | (?P<number>\.?\d(?:(?<=[eE])[+-]|'?[\w.])*)
  | (?P<word>[A-Za-z_]\w*)
  | (?P<operator><=>|<<=|>>=|->\*|\.\.\.|::|->|\+\+|--|<<|<=|>=|==|!=|&&|\|\||[-+*/%&|^]=|\S)
    """,
    re.VERBOSE | re.DOTALL | re.MULTILINE,
)

CLOSERS = {"(": ")", "[": "]", "{": "}"}
# What may stand between the parameters of a function and its body.
_AFTER_PARAMETERS = {"const", "noexcept", "override", "final", "mutable", "try"}


@dataclass(frozen=True)
class Token:
    kind: str
    text: str
    begin: int
    end: int


class Tokens:
    """`match` has the index of the other bracket for that of each bracket."""

    def __init__(self, text):
        self._tokens = [
            Token(match.lastgroup if match.lastgroup != "mark" else "string", match.group(), match.start(), match.end())
            for match in _TOKEN.finditer(code_of(text, keep_strings=True))
        ]
        self._tokens = [token for token in self._tokens if token.kind != "directive"]
        self.match, self._around = self._brackets()
        self._kinds = self._kinds_of_braces()

    def __len__(self):
        return len(self._tokens)

    def __getitem__(self, index):
        return self._tokens[index]

    def __iter__(self):
        return iter(self._tokens)

    def text(self, index):
        return self._tokens[index].text if index < len(self) else ""

    def _brackets(self):
        """({bracket: the other one}, for each token the bracket around it or None)"""
        matches = {}
        around = []
        opened = []
        for index, token in enumerate(self._tokens):
            if token.text in CLOSERS.values() and opened and CLOSERS[self.text(opened[-1])] == token.text:
                matches[index] = opened[-1]
                matches[opened.pop()] = index
            around.append(opened[-1] if opened else None)
            if token.text in CLOSERS:
                opened.append(index)
        return matches, around

    def _kinds_of_braces(self):
        """{opening brace: its kind}: `body` for a function, a block or a lambda, `type`, `namespace` or `value`."""
        kinds = {}
        boundary = 0  # the first token of the declaration
        for index, token in enumerate(self._tokens):
            if token.text == ";" or token.text == "}" and kinds.get(self.match.get(index)) != "value":
                boundary = index + 1
            elif token.text == "{":
                around = self._brace_around(index)
                kinds[index] = self._kind_of_brace(index, boundary, "namespace" if around is None else kinds[around])
                boundary = boundary if kinds[index] == "value" else index + 1
        return kinds

    def _brace_around(self, index):
        around = self._around[index]
        while around is not None and self.text(around) != "{":
            around = self._around[around]
        return around

    def _kind_of_brace(self, index, boundary, inside):
        before = self.text(index - 1) if index else ""
        words = {token.text for token in self._tokens[boundary:index]}
        if inside in ("namespace", "type"):
            if "namespace" in words:
                return "namespace"
            if words & {"class", "struct", "union", "enum"} and "(" not in words:
                return "type"
            if before == "}" and index - 1 >= boundary:  # behind the last initializer of a constructor
                return "body"
        elif before in (";", "{", "}", ":", "else", "do", "try"):
            return "value" if inside == "value" else "body"
        if before in (")", "]") or before in _AFTER_PARAMETERS or self._returns_type(index):
            return "body"
        return "value"

    def _returns_type(self, index):
        """Whether `-> Type` is before the brace."""
        index -= 1
        while index > 0 and (self[index].kind == "word" or self.text(index) in ("::", "<", ">", "*", "&", ",")):
            index -= 1
        return self.text(index) == "->" and self.text(index - 1) in (")", *_AFTER_PARAMETERS)

    def is_in_function(self, index):
        brace = self._brace_around(index)
        while brace is not None and self._kinds[brace] != "body":
            brace = self._brace_around(brace)
        return brace is not None

    def opener(self, index):
        """The text before the bracket around a token, for example `for`."""
        around = self._around[index]
        return self.text(around - 1) if around else ""

    def statements(self):
        """Yields the first token of each statement of a function, also of those behind an `if (…)` or a label."""
        for index in range(1, len(self)):
            if self.text(index) == "}" or self._kinds.get(self._around[index]) != "body":
                continue
            before = self.text(index - 1)
            if before in (";", "{") or before == "}" and self._kinds[self.match[index - 1]] == "body":
                yield from self._with_bodies(index)

    def _with_bodies(self, index):
        while index < len(self):
            word = self.text(index)
            if word in ("case", "default"):
                while index < len(self) and self.text(index) != ":":
                    index += 1
                index += 1
                continue
            yield index
            if word in ("else", "do", "try"):
                index += 1
            elif word in ("if", "for", "while", "switch"):
                opened = index + (2 if self.text(index + 1) == "constexpr" else 1)
                index = self.match.get(opened, len(self)) + 1
            else:
                return
            if self.text(index) in ("{", ";"):
                return

    def end_of_statement(self, index):
        """The next semicolon outside brackets, or the last token before the bracket that ends first."""
        while index < len(self):
            text = self.text(index)
            if text == ";":
                return index
            if text in CLOSERS.values():
                return index - 1
            index = self.match.get(index, index) if text in CLOSERS else index
            index += 1
        return len(self) - 1

    def end_of_body(self, index):
        """The last token of a block or a statement."""
        return self.match[index] if self.text(index) == "{" else self.end_of_statement(index)

    def end_of_template(self, index):
        """The bracket that closes the one at `index`, or `index` itself."""
        depth = 0
        for other in range(index, min(index + 40, len(self))):
            depth += {"<": 1, ">": -1}.get(self.text(other), 0)
            if depth == 0:
                return other
        return index

    def at_depth(self, opened, closed, texts):
        """The tokens between both that are one of these and in no further brackets."""
        found = []
        index = opened + 1
        while index < closed:
            if self.text(index) in texts:
                found.append(index)
            index = self.match.get(index, index) if self.text(index) in CLOSERS else index
            index += 1
        return found

    def arguments(self, opened):
        """The first and the last token of each argument of a call."""
        closed = self.match.get(opened)
        if closed is None or closed == opened + 1:
            return []
        found = []
        first = index = opened + 1
        while index < closed:
            text = self.text(index)
            if text == ",":
                found.append((first, index - 1))
                first = index + 1
            elif text in CLOSERS:
                index = self.match.get(index, index)
            elif text == "<" and self[index].begin == self[index - 1].end:
                index = self.end_of_template(index)
            index += 1
        found.append((first, closed - 1))
        return [argument for argument in found if argument[0] <= argument[1]]
