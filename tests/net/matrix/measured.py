"""The tables of a run."""

import os
from pathlib import Path

from gates import worst
from run_cells import DISTURBED, is_disturbed

SUBUNITS = 1024   # in a level unit

# Measured on DDNet 18 at 50 ticks a second, on a machine of this size: players, bytes a second down, per cent of a core.
DDNET = ((16, 15700, 6.3), (64, 18800, 23.8))

HEAD = """Written by `./platon bench --network` on {machine}. Each cell is one `platon-server` and 16 `platon-bot` players on \
loopback that press buttons for {seconds:g} s; {at_once} cells run at a time. The numbers are averages over the bots, from \
{settle:g} s after their first tick. Loss, delay and jitter apply in each direction. Missed inputs, mispredicted own ticks and \
corrections are counted in 1 000 ticks. The largest correction is in level units and is counted from the start of the bots. CPU is the share of one \
core while all bots play. A cell is repeated once if one of its processes waited for a processor for more than {disturbed} % of \
the time; cells that were still disturbed: {busy}"""

SCALE = """Each of these servers had the machine for itself and its bots. With 64 players, 8 of them advance the game, with 256 \
players 4; the others are `--hollow`. The time of a tick covers all the work of the server in this tick, from receiving to sending. Times of ticks cover the whole \
run: all bots join within a second and leave at the same time."""

WITHOUT = """A server listens {startMs:.1f} ms after its start (median of {starts}). Before anybody joins it takes \
{idlePercent:.3f} % of a core, and {leftPercent:.3f} % after all have left."""

PEERS = """DDNet 18 (50 ticks a second, sends states, sends each input once) was measured on a machine of this size with as \
many moving players. Platon's numbers are those of a perfect connection:"""


def machine():
    names = [line.split(":", 1)[1].strip() for line in Path("/proc/cpuinfo").read_text().splitlines()
             if line.startswith("model name")]  # fmt: skip
    return f"{names[0] if names else 'a machine'}, {os.cpu_count()} processors"


def table(heads, rows):
    lines = [heads, ["---"] * len(heads), *rows]
    return "\n".join(f"| {' | '.join(map(str, line))} |" for line in lines)


def kb(value):
    return f"{value / 1000:.2f}"


def matrix_table(results):
    heads = ["loss, %", "delay, ms", "jitter, ms", "round trip, ms", "to join, ms", "down, kB/s", "up, kB/s", "missed",
             "mispredicted", "corrections", "largest", "resumes", "CPU, %"]  # fmt: skip
    rows = []
    for r in results:
        cell = r["cell"]
        rows.append([cell.loss, cell.delay, cell.jitter, f"{r['rttMs']:.0f}", f"{r['connectMs']:.0f}",
                     kb(r["downBytesPerSecond"]), kb(r["upBytesPerSecond"]), f"{r['missedInputsPer1000Ticks']:.2f}",
                     f"{r['mispredictedPer1000Ticks']:.2f}", f"{r['correctionsPer1000Ticks']:.2f}",
                     f"{r['maxCorrectionSubunits'] / SUBUNITS:.1f}", f"{r['resumes']:g}", f"{r['cpuPercent']:.2f}"])  # fmt: skip
    return table(heads, rows)


def scale_table(results):
    heads = ["players", "connection", "to join, ms", "down, kB/s", "up, kB/s", "missed", "longest datagram, bytes", "CPU, %",
             "memory, MB", "tick, median, ms", "99th percentile", "longest"]  # fmt: skip
    rows = []
    for r in results:
        cell = r["cell"]
        rows.append([cell.players, cell.conditions if cell.condition_options else "perfect", f"{r['connectMs']:.0f}", kb(r["downBytesPerSecond"]), kb(r["upBytesPerSecond"]),
                     f"{r['missedInputsPer1000Ticks']:.2f}", r["longestDatagramBytes"], f"{r['cpuPercent']:.2f}",
                     f"{r['memoryBytes'] / 1e6:.1f}", *(f"{r[key] / 1000:.2f}" for key in ("p50Us", "p99Us", "longestUs"))])  # fmt: skip
    return table(heads, rows)


def peer_table(results):
    rows = []
    for players, down, cpu in DDNET:
        own = next(r for r in results if r["cell"].players == players and not r["cell"].condition_options)
        times = down / own["downBytesPerSecond"], cpu / own["cpuPercent"]
        rows.append([players, f"{kb(own['downBytesPerSecond'])} kB/s", f"{down / 1000:.1f} kB/s ({times[0]:.1f} ×)",
                     f"{own['cpuPercent']:.2f} %", f"{cpu} % ({times[1]:.1f} ×)"])  # fmt: skip
    return table(["players", "down, a player", "DDNet", "server, of a core", "DDNet"], rows)


def gate_table(judged):
    rows = []
    for gate, found in judged:
        verdict = worst(found)
        wrong = sum(not one.holds for one in found)
        place = f" ({verdict.cell.name})" if verdict.cell and len(found) > 1 else ""
        holds = "yes" if not wrong else f"**no**, {wrong} of {len(found)} cells" if len(found) > 1 else "**no**"
        rows.append([gate.what, gate.aim, gate.text(verdict.value) + place, holds])
    return table(["what", "aim", "worst of all cells", "holds"], rows)


def summary(judged):
    wrong = [gate.what for gate, found in judged if not all(verdict.holds for verdict in found)]
    if not wrong:
        return f"All {len(judged)} limits are kept."
    return f"{len(wrong)} of {len(judged)} limits are exceeded: {'; '.join(wrong)}."


def busy(results):
    """The cells that were disturbed in every attempt."""
    names = [f"{r['cell'].name} ({r['waitPercent']:.0f} %)" for r in results if is_disturbed(r)]
    return f"{'; '.join(names) or 'none'}."


def section(together, alone, without_players, judged):
    """The part of the page that a run makes."""
    first = together[0]["cell"]
    head = HEAD.format(machine=machine(), seconds=first.seconds, settle=first.settle, at_once=without_players["atOnce"],
                       disturbed=DISTURBED, busy=busy(together + alone))  # fmt: skip
    parts = [head, summary(judged), gate_table(judged), "### Connections", matrix_table(together), "### Many players", SCALE,
             scale_table(alone), WITHOUT.format(**without_players), "### Compared with another game", PEERS, peer_table(alone)]  # fmt: skip
    return "\n\n".join(parts)


def text_report(results, without_players):
    """The results as text for the terminal."""
    parts = [matrix_table([r for r in results if not r["cell"].hollow]), scale_table(results)]
    if without_players:
        parts.append(WITHOUT.format(**without_players))
    return "\n\n".join(parts)
