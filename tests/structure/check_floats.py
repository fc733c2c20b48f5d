#!/usr/bin/env python3
"""Refuses calculations with floats in the machine code of libraries, for x86-64.

usage: check_floats.py OBJDUMP ARCHIVE…. Prints each instruction that calculates with a float or converts one, each call of
a function for floats, and where it is; exit 1 if there are any. Code that only copies a float, changes its sign or folds one
while it is compiled has none; check_structure.py refuses their names and literals.
"""

import re
import sys

import archives

_FUNCTION = re.compile(r"^[0-9a-f]+ <(.+)>:$", re.MULTILINE)
# Of SSE and AVX, the instructions on scalars and vectors of floats that do more than to move bits; those of the x87.
_CALCULATES = re.compile(
    r"\t(v?(?:add|sub|mul|div|sqrt|rcp|rsqrt|min|max|cmp\w*|u?comi|round|fn?m(?:add|sub)\w*|h(?:add|sub)|addsub|dp)[sp][sd]"
    r"|v?cvt\w+|f(?!xsave|xrstor)[a-z]\w*)(?:\s|$)"
)
# Of libgcc, for types without instructions of their own, and of the C library.
_CALLS = re.compile(
    r": R_X86_64_\w+\s+(__\w*[sdxt]f\w*|__bid_\w+|__dpd_\w+|strto(?:f|d|ld)|ato[f]|(?:a?sin|a?cos|a?tan|atan2|sqrt|cbrt|pow|exp2?"
    r"|log(?:2|10)?|floor|ceil|trunc|l?l?rint|l?l?round|fmod|fma|hypot|ldexp|frexp)[fl]?)(?:[-+@]|$)"
)


def calculations(disassembly):
    """Yields (function, instruction or callee) from the output of `objdump --disassemble --reloc`."""
    function = "?"
    for line in disassembly.splitlines():
        if begins := _FUNCTION.match(line):
            function = begins[1]
        elif found := _CALCULATES.search(line) or _CALLS.search(line):
            yield function, found[1]


def faults(disassembly):
    if not _FUNCTION.search(disassembly):
        yield "no code"
    for function, calculation in calculations(disassembly):
        yield f"{calculation} in {function}"


if __name__ == "__main__":
    options = ["--disassemble", "--reloc", "--no-show-raw-insn"]
    sys.exit(archives.check(sys.argv, options, faults, "calculations with floats"))
