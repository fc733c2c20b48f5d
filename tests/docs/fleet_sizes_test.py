#!/usr/bin/env python3
"""Compares the sizes in docs/fleet.md with those that follow from the measurements in the other pages.

usage: fleet_sizes_test.py ROOT [--write]

Exit 1 if they differ. --write corrects the page instead.
"""

import math
import re
import sys
from dataclasses import dataclass
from pathlib import Path

PAGE = "docs/fleet.md"
BEGIN = "<!-- computed: by tests/docs/fleet_sizes_test.py --write, do not edit by hand -->"
END = "<!-- end of computed -->"

POPULATIONS = (1_000, 100_000, 1_000_000)
SERVER_SIZES = (16, 64, 256)
# Share of the places that are taken, share of a core that is planned to be busy, and servers on a machine: Kubernetes
# allows 110 pods on one unless it is told otherwise, and needs some itself.
TAKEN, BUSY, SERVERS_A_MACHINE = 0.75, 0.5, 100
# Part of a core that the sidecar of Agones asks for: SIDECAR_CPU_REQUEST in its install/yaml/install.yaml.
SIDECAR_CORES = 0.03


@dataclass(frozen=True)
class Server:
    """One full server: traffic of a player in kB/s, share of a core in per cent, memory in MB."""

    players: int
    down: float
    up: float
    cpu: float
    memory: float


def rows_of(text, begin):
    """The cells of the rows that begin with these cells."""
    rows = [[cell.strip() for cell in line.strip("|").split("|")] for line in text.splitlines() if line.startswith("| ")]
    return [row for row in rows if row[: len(begin)] == begin]


def measured(netcode, players):
    [row] = [row for row in rows_of(netcode, [str(players), "perfect"]) if len(row) == 12]
    return Server(players, float(row[3]), float(row[4]), float(row[7]), float(row[8]))


def attacked(security):
    """The largest share of a core in per cent, and the most memory in KiB, of all attacks."""
    rows = [row for row in rows_of(security, []) if len(row) == 12 and row[10].startswith("+")]
    return max(int(row[11]) for row in rows), max(int(row[10]) for row in rows)


def grouped(value):
    return f"{value:,}".replace(",", " ")


def rounded(value):
    """Two digits, rounded up."""
    step = 10 ** max(math.floor(math.log10(value)) - 1, -1)
    up = math.ceil(round(value / step, 9)) * step
    return f"{up:.1f}" if step < 1 else grouped(round(up))


def sizes(players, server):
    servers = math.ceil(players / (server.players * TAKEN))
    cores = servers * server.cpu / 100 / BUSY
    gigabits = players * 8 / 1_000_000
    cells = [grouped(players), str(server.players), grouped(servers), grouped(math.ceil(servers / SERVERS_A_MACHINE)), rounded(cores)]
    cells += [rounded(servers * SIDECAR_CORES), rounded(servers * server.memory / 1000), rounded(1000 * gigabits * server.down)]
    return f"| {' | '.join([*cells, rounded(1000 * gigabits * server.up)])} |"


def block(root):
    netcode, security = ((root / "docs" / page).read_text(encoding="utf-8") for page in ("netcode.md", "security.md"))
    servers = [measured(netcode, players) for players in SERVER_SIZES]
    cpu, memory = attacked(security)
    lines = ["", "| players a server | players a core | of a core, % | memory, MB | down, a player, kB/s | up, a player, kB/s |", "|---|---|---|---|---|---|"]
    for one in servers:
        a_core = math.floor(one.players / (one.cpu / 100) * BUSY / 10) * 10
        lines.append(f"| {one.players} | {grouped(a_core)} | {one.cpu} | {one.memory} | {one.down} | {one.up} |")
    lines += ["", f"An attack adds at most {cpu} % of a core and {memory} KiB (`./platon bench --attacks`, [security](security.md#measured)).", ""]
    lines += ["| players | players a server | servers | machines | cores | cores, sidecars | memory, GB | down, Mbit/s | up, Mbit/s |", "|---|---|---|---|---|---|---|---|---|"]
    lines += [sizes(players, one) for players in POPULATIONS for one in servers]
    return "\n".join([BEGIN, *lines, "", END])


def main(arguments):
    if len(arguments) not in (1, 2) or arguments[1:] not in ([], ["--write"]):
        print(__doc__, file=sys.stderr)
        return 2
    root = Path(arguments[0])
    text = (root / PAGE).read_text(encoding="utf-8")
    found = re.search(re.escape(BEGIN) + ".*?" + re.escape(END), text, re.DOTALL)
    if not found:
        print(f"{PAGE}: has no block that begins with {BEGIN}")
        return 1
    right = block(root)
    if found[0] == right:
        return 0
    if arguments[1:]:
        (root / PAGE).write_text(text.replace(found[0], right), encoding="utf-8")
        return 0
    print(f"{PAGE}: the sizes are not those of the measurements: run tests/docs/fleet_sizes_test.py . --write")
    return 1


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
