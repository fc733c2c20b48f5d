#!/usr/bin/env python3
"""Runs a command of the compiler and appends a line "SECONDS OUTPUT" with its processor time to the file $PLATON_METER,
if that is set: tests that compile are not part of the build.

usage: meter.py COMMAND…, as a launcher of CMake. OUTPUT is what follows -o.
"""

import os
import sys

if __name__ == "__main__":
    child = os.posix_spawnp(sys.argv[1], sys.argv[1:], os.environ)
    _, status, used = os.wait4(child, 0)
    if "-o" in sys.argv and "PLATON_METER" in os.environ:
        output = sys.argv[sys.argv.index("-o") + 1]
        with open(os.environ["PLATON_METER"], "a", encoding="utf-8") as log:
            log.write(f"{used.ru_utime + used.ru_stime:.2f} {output}\n")
    sys.exit(os.waitstatus_to_exitcode(status))
