#!/usr/bin/env python3
"""Attacks a real server over loopback, one attack after the other, while four bots play on it.

usage: attacks.py ROOT (--write | --quick | --check) [ATTACK…]. PLATON_BIN names the folder of the programs. --write attacks
for 10 s each and writes the table of docs/security.md, --quick for 2 s and prints it. --check is a quick run that checks only
what does not depend on the speed of the machine. With names of attacks, only these run, and nothing is written. Prints every
limit that is exceeded; exit 1 if there is one. Attacks over IPv6 need a network namespace, which only root can make; without one they are
skipped.
"""

import json
import os
import subprocess
import sys
from pathlib import Path

sys.path.append(str(Path(__file__).resolve().parent.parent / "matrix"))

import network_namespace  # noqa: E402
from attack_run import run_attack  # noqa: E402
from attack_table import exceeded, table  # noqa: E402
from page import replace_part, with_part  # noqa: E402
from processes import Failure, exit_code_of  # noqa: E402

SECONDS = {"--write": 10, "--quick": 2, "--check": 1}
COMMAND = "attacks"
QUIET = {"name": "none", "does": "no attack", "proves": False, "ipv6": False, "amplifies": False}


def say(line):
    print(line, file=sys.stderr, flush=True)


def all_attacks(programs):
    listed = subprocess.run([programs / "platon-attack", "--list"], capture_output=True, text=True, check=True).stdout
    return [json.loads(line) for line in listed.splitlines()]


def chosen(attacks, names):
    unknown = set(names) - {attack["name"] for attack in attacks}
    if unknown:
        raise Failure(f"no attack is called {', '.join(sorted(unknown))}; platon-attack --list shows all")
    wanted = [QUIET, *(attack for attack in attacks if not names or attack["name"] in names)]
    return sorted(wanted, key=lambda attack: attack["ipv6"])  # a namespace is entered for good


def enters_namespace():
    """Whether attacks over IPv6 can run; if not, says why."""
    try:
        network_namespace.enter()
    except network_namespace.Unavailable as reason:
        say(f"attacks over IPv6 are skipped: {reason}")
        return False
    return True


def run(root, mode, names, programs):
    page = root / "docs/security.md"
    with_part(page.read_text(encoding="utf-8"), "", COMMAND)  # fails before the run, not after it
    results = []
    for attack in chosen(all_attacks(programs), names):
        if attack["ipv6"] and not results[-1].attack["ipv6"] and not enters_namespace():
            break
        results.append(run_attack(programs, root, attack, SECONDS[mode]))
        say(f"{attack['name']}: {results[-1].words()}")
    part = table(results, SECONDS[mode])
    if mode == "--write" and not names:
        replace_part(page, part, COMMAND)
    else:
        print(part)
    return exceeded(results, timings=mode != "--check")


def main(arguments):
    if len(arguments) < 2 or arguments[1] not in SECONDS or "PLATON_BIN" not in os.environ:
        print(__doc__, file=sys.stderr)
        return 2
    programs = Path(os.environ["PLATON_BIN"])
    return exit_code_of(lambda: run(Path(arguments[0]).resolve(), arguments[1], arguments[2:], programs))


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
