"""The limits of the network code, and whether a run is within them. These numbers are only here."""

from dataclasses import dataclass
from typing import Callable

TICK_MS = 1000 / 60


@dataclass(frozen=True)
class Gate:
    """In every cell for which `applies` is true, `key` is at most `max`, a number or a function of the cell. `timing`: the
    value depends on the speed and the load of the machine."""

    what: str
    aim: str
    key: str
    max: float | Callable
    applies: Callable = lambda cell: True
    timing: bool = False
    shown: str = "{:.4g}"
    scale: float = 1

    def limit(self, cell):
        return self.max(cell) if callable(self.max) else self.max

    def text(self, value):
        return self.shown.format(value * self.scale)


@dataclass(frozen=True)
class Verdict:
    gate: Gate
    value: float
    limit: float
    cell: object   # None for a server without players

    @property
    def holds(self):
        return self.value <= self.limit

    @property
    def line(self):
        place = self.cell.name if self.cell else "no players"
        return f"{self.gate.what}: {self.gate.text(self.value)}, above {self.gate.text(self.limit)} ({place})"


def max_connect_ms(cell):
    """Milliseconds: two ticks and five of the longest round trips: two to agree on keys, then connection, Hello and first
    inputs."""
    return 5 * 2 * (cell.delay + cell.jitter) + 2 * TICK_MS


def perfect(cell):
    return cell.loss == cell.delay == cell.jitter == 0


def _players(*counts):
    return lambda cell: cell.players in counts


KB = {"shown": "{:.2f} kB/s", "scale": 0.001}
PER_CENT = {"shown": "{:.2f} %", "scale": 0.1}   # of a number in a thousand
CORE = {"shown": "{:.2f} %", "timing": True}
IDLE = {"shown": "{:.3f} %", "timing": True}

GATES = (
    Gate("down, a player of 16", "≤ 3 kB/s", "downBytesPerSecond", 3000, applies=_players(16), **KB),
    Gate("down, a player of 4, 64 or 256", "≤ 6 kB/s", "downBytesPerSecond", 6000, applies=_players(4, 64, 256), **KB),
    Gate("up, a player", "≤ 1.5 kB/s", "upBytesPerSecond", 1500, **KB),
    Gate("longest datagram, both ways", "≤ 1 200 bytes", "longestDatagramBytes", 1200, shown="{} bytes"),
    Gate("missed inputs, loss ≤ 10 %", "≤ 0.1 %", "missedInputsPer1000Ticks", 1,
         applies=lambda cell: cell.loss <= 10, timing=True, **PER_CENT),
    Gate("own ticks mispredicted, delay 50 ms, loss 2 %, jitter ≤ 20 ms", "≤ 0.5 %", "mispredictedPer1000Ticks", 5,
         applies=lambda cell: (cell.loss, cell.delay) == (2, 50) and cell.jitter <= 20, timing=True, **PER_CENT),
    Gate("desyncs", "0", "hashMismatches", 0, shown="{:g}"),
    Gate("resyncs, a player", "0", "resyncs", 0, shown="{:.2g}"),
    Gate("resumes, loss ≤ 10 %", "0", "resumes", 0, shown="{:.2g}",
         applies=lambda cell: cell.loss <= 10),
    Gate("bots that could not join or were disconnected", "0", "failed", 0, shown="{}"),
    Gate("rounds that ended during the measurement", "0", "roundOver", 0, shown="{}"),
    Gate("time to join, perfect connection", "≤ 300 ms", "connectMs", 300, timing=True, shown="{:.0f} ms",
         applies=perfect),
    Gate("time to join, other connections without loss", "≤ 10 × (delay + jitter) + 2 ticks", "connectMs", max_connect_ms,
         timing=True, shown="{:.0f} ms", applies=lambda cell: cell.loss == 0 and not perfect(cell)),
    Gate("server, 16 players", "≤ 1 % of a core", "cpuPercent", 1, applies=_players(16), **CORE),
    Gate("server, 64 players", "≤ 3 % of a core", "cpuPercent", 3, applies=_players(64), **CORE),
    Gate("server, 256 players", "≤ 10 % of a core", "cpuPercent", 10, applies=_players(256), **CORE),
    Gate("a tick of 256 players, 99th percentile", "≤ 4 ms", "p99Us", 4000, applies=_players(256), timing=True,
         shown="{:.2f} ms", scale=0.001),
    Gate("memory of the server", "≤ 16 MB", "memoryBytes", 16e6, timing=True, shown="{:.1f} MB", scale=1e-6),
)  # fmt: skip

WITHOUT_PLAYERS = (
    Gate("server before anybody joins", "≤ 0.1 % of a core", "idlePercent", 0.1, **IDLE),
    Gate("server after all have left", "≤ 0.1 % of a core", "leftPercent", 0.1, **IDLE),
    Gate("from start to listening, median", "≤ 20 ms", "startMs", 20, timing=True, shown="{:.1f} ms"),
)


def verdicts(gate, results):
    """A verdict for each cell to which the gate applies."""
    return [Verdict(gate, result[gate.key], gate.limit(result["cell"]), result["cell"])
            for result in results if gate.applies(result["cell"])]  # fmt: skip


def worst(found):
    """The verdict farthest above its limit, or nearest to it."""
    return max(found, key=lambda verdict: (not verdict.holds, verdict.value / (verdict.limit or 1)))


def judge(results, without_players, timings):
    """Yields (gate, its verdicts) for every gate that applies to this run."""
    for gate in GATES:
        found = verdicts(gate, results)
        if found and (timings or not gate.timing):
            yield gate, found
    for gate in WITHOUT_PLAYERS if without_players and timings else ():
        yield gate, [Verdict(gate, without_players[gate.key], gate.limit(None), None)]


def failures(judged):
    return [verdict.line for _, found in judged for verdict in found if not verdict.holds]
