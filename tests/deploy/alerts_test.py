#!/usr/bin/env python3
"""Checks the rules of deploy/monitoring/alerts.yaml with promtool of Prometheus, and runs tests/deploy/alerts_cases.yaml,
which says when they fire.

usage: alerts_test.py ROOT. Exit 77 without promtool.
"""

import shutil
import subprocess
import sys
from pathlib import Path


def main(arguments):
    root = Path(arguments[1])
    if not shutil.which("promtool"):
        print("skipped: promtool is not installed; Debian's package prometheus has it")
        return 77
    for command in (["check", "rules", root / "deploy/monitoring/alerts.yaml"], ["test", "rules", root / "tests/deploy/alerts_cases.yaml"]):
        result = subprocess.run(["promtool", *command], check=False)
        if result.returncode != 0:
            return 1
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv))
