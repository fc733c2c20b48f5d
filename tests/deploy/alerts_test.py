#!/usr/bin/env python3
"""Checks the rules of deploy/monitoring/alerts.yaml with promtool of Prometheus, and runs tests/deploy/alerts_cases.yaml,
which says when they fire and when they end: each of them must be in it.

usage: alerts_test.py ROOT
"""

import shutil
import subprocess
import sys
from pathlib import Path

import yaml


def main(arguments):
    rules, cases = (Path(arguments[1]) / name for name in ("deploy/monitoring/alerts.yaml", "tests/deploy/alerts_cases.yaml"))
    if not shutil.which("promtool"):
        print("promtool is not installed: install Debian's package prometheus")
        return 1
    for command in (["check", "rules", rules], ["test", "rules", cases]):
        if subprocess.run(["promtool", *command], check=False).returncode != 0:
            return 1
    text = cases.read_text(encoding="utf-8")
    untried = [rule["alert"] for rule in yaml.safe_load(rules.read_text(encoding="utf-8"))["groups"][0]["rules"] if rule["alert"] not in text]
    for alert in untried:
        print(f"{cases}: no case in which {alert} fires")
    return 1 if untried else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv))
