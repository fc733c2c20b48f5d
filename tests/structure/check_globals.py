#!/usr/bin/env python3
"""Refuses variables in libraries that may hold only code and constants.

usage: check_globals.py OBJDUMP ARCHIVE…. Prints each object in a writable section; exit 1 if there are any. A local
static that is written once counts too: its guard is writable.
"""

import re
import sys

import archives

_SYMBOL = re.compile(r"^[0-9a-f]+ (?P<flags>.{7}) (?P<section>\S+)\t[0-9a-f]+\s+(?:\.hidden )?(?P<name>.+)$")
# The loader writes tables of constants that hold addresses (.data.rel.ro) before the program starts; nothing else does.
_WRITABLE = re.compile(r"\.t?(?:data|bss)(?!\.rel\.ro)")


def writable_objects(symbol_table):
    """Yields (section, name) of every variable in the output of `objdump --syms`."""
    for match in filter(None, map(_SYMBOL.match, symbol_table.splitlines())):
        is_section = "d" in match["flags"]
        # Clang adds it to every object that may throw; it leads an exception to its handler.
        is_unwinder = match["name"].startswith("DW.ref.")
        if _WRITABLE.match(match["section"]) and not is_section and not is_unwinder:
            yield match["section"], match["name"]


def faults(symbol_table):
    return (f"variable {name} in {section}" for section, name in writable_objects(symbol_table))


if __name__ == "__main__":
    sys.exit(archives.check(sys.argv, ["--syms"], faults, "variables"))
