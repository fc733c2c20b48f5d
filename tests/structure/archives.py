"""What the checks of compiled libraries share."""

import subprocess
import sys


def check(arguments, options, faults_of, what):
    """Runs objdump with these options on the archives of the command line `SCRIPT OBJDUMP ARCHIVE…`, prints each fault
    that faults_of(its output) yields, and returns the exit code."""
    if len(arguments) < 3:
        print("usage: SCRIPT OBJDUMP ARCHIVE…", file=sys.stderr)
        return 2
    found = 0
    for archive in arguments[2:]:
        dump = subprocess.run([arguments[1], *options, "--demangle", archive], capture_output=True, text=True)
        if dump.returncode != 0:
            print(dump.stderr.strip())
            return 1
        for fault in faults_of(dump.stdout):
            print(f"{archive}: {fault}")
            found += 1
    print(f"{found} {what}")
    return 1 if found else 0
