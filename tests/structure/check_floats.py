#!/usr/bin/env python3
"""Refuses calculations with floats in the machine code of libraries, for x86-64.

usage: check_floats.py OBJDUMP ARCHIVE…. Prints each instruction that calculates with a float or converts one, each call of
a function for floats, and where it is; exit 1 if there are any. Code that only copies a float, changes its sign or folds one
while it is compiled has none; check_structure.py refuses their names and literals.
"""

import re
import subprocess
import sys

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


def main(arguments):
    if len(arguments) < 3:
        print("usage: check_floats.py OBJDUMP ARCHIVE…", file=sys.stderr)
        return 2
    found = 0
    for archive in arguments[2:]:
        dump = subprocess.run([arguments[1], "--disassemble", "--reloc", "--no-show-raw-insn", "--demangle", archive],
                              capture_output=True, text=True)  # fmt: skip
        if dump.returncode != 0:
            print(dump.stderr.strip())
            return 1
        if not _FUNCTION.search(dump.stdout):
            print(f"{archive}: no code")
            return 1
        for function, instruction in calculations(dump.stdout):
            print(f"{archive}: {instruction} in {function}")
            found += 1
    print(f"{found} calculations with floats")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv))
