"""Runs one attack on a real server and measures what it does."""

import contextlib
import json
import re
import subprocess
import time
from dataclasses import dataclass
from pathlib import Path
from types import SimpleNamespace

from processes import Bots, Failure, Program, Server

LEVEL = "tests/determinism/golden/levels/icosahedron.level"
PLAYERS = 64
BOTS = 4
SETTLE = 4  # seconds until the bots are measured, and the attack begins
NEWCOMER_SECONDS = 3
DISTURBED = 20  # per cent of the time; if a program waits longer for a core, the run measures the load of the machine
ATTEMPTS = 3
AMPLIFYING_SECONDS = 30  # that an attack lasts that amplifies


@dataclass
class Result:
    """What an attack did. Times in milliseconds."""

    attack: dict
    sent: int
    dropped: int  # by the system, because the server did not read in time
    answered_ratio: float  # bytes to addresses that had returned no cookie, by bytes of the attack
    amplification: float | None  # bytes to the attacker, ticks aside, by bytes of an attack that amplifies
    missed: float  # inputs per 1000 ticks
    disconnected: int
    desyncs: int
    join: float | None  # nothing: the newcomer has not joined
    p50: float
    p99: float
    longest: float
    growth: int  # bytes
    cpu: float  # per cent of a core
    wait: float  # per cent of the time that server, attacker or bots waited for a core, whichever is more

    @property
    def reached(self):
        return 100.0 if self.sent == 0 else 100 * (1 - self.dropped / self.sent)

    def words(self):
        join = "never" if self.join is None else f"{self.join:.0f} ms"
        return (f"{self.sent} sent, {self.reached:.1f} % reached, {self.missed:.2f} missed, {self.disconnected} "
                f"disconnected, joined {join}, p99 {self.p99:.1f} ms, longest {self.longest:.1f} ms, "
                f"{self.growth // 1024} KiB, {self.cpu:.0f} %, waited {self.wait:.0f} %")  # fmt: skip


class Attack(Program):
    """A process of platon-attack, and the relay in it."""

    def __init__(self, programs, port, attack, seconds):
        super().__init__([programs / "platon-attack", str(port), attack["name"], "--seconds", str(seconds)],
                         stdin=subprocess.PIPE, stdout=subprocess.PIPE)  # fmt: skip
        self.amplifies = attack["amplifies"]
        self.relay = SimpleNamespace(address=self._line().removeprefix("relay "))

    def _line(self):
        line = self._process.stdout.readline().strip()
        if not line:
            raise Failure("platon-attack ended too early")
        return line

    def begin(self):
        self._process.stdin.write("begin\n")
        self._process.stdin.flush()

    def result(self):
        return json.loads(self._line())


def drops_at(port):
    """Datagrams for the socket at this port that the system has dropped."""
    for table in ("/proc/net/udp", "/proc/net/udp6"):
        for line in Path(table).read_text().splitlines()[1:]:
            words = line.split()
            if int(words[1].rpartition(":")[2], 16) == port:
                return int(words[-1])
    raise Failure(f"/proc/net/udp and udp6 have no socket at port {port}")


def bots(programs, relay, count, seconds, settle, seed):
    cell = SimpleNamespace(seconds=seconds, settle=settle, condition_options=[])
    return Bots(programs, relay, cell, count, False, seed)


def newcomer(programs, relay):
    with bots(programs, relay, 1, NEWCOMER_SECONDS, 0, 99) as bot:
        result = bot.result()
    return result["connectMs"] if result["connected"] else None


def watch(programs, server, attack, players, seconds, port):
    """Lets the attack run. Returns what is known of the server and the newcomer."""
    watched = (server, attack, players)
    before, begun = [program.processor_seconds() for program in watched], time.monotonic()
    memory, drops = server.resident_bytes(), drops_at(port)
    attack.begin()
    time.sleep(min(1, seconds / 4))
    join = newcomer(programs, attack.relay)
    sent = attack.result()
    after, passed = [program.processor_seconds() for program in watched], time.monotonic() - begun
    waits = [now[1] - then[1] for then, now in zip(before, after, strict=True)]
    return {
        "join": join,
        "sent": sent["sent"],
        "answered_ratio": sent["answeredBytes"] / max(sent["sentBytes"], 1),
        "amplification": sent["lateReceivedBytes"] / max(sent["lateSentBytes"], 1) if attack.amplifies else None,
        "dropped": drops_at(port) - drops,
        "growth": server.resident_bytes() - memory,
        "cpu": 100 * (after[0][0] - before[0][0]) / passed,
        "wait": 100 * max(waits) / passed,
    }


def run_attack(programs, root, attack, seconds):
    """Runs it again if other work of the machine disturbed it, and returns the quietest run."""
    tried = []
    while len(tried) < ATTEMPTS:
        tried.append(_run_once(programs, root, attack, seconds))
        if tried[-1].wait <= DISTURBED:
            break
    return min(tried, key=lambda result: result.wait)


def _run_once(programs, root, attack, seconds):
    with contextlib.ExitStack() as processes:
        bind = "::1" if attack["ipv6"] else "127.0.0.1"
        server = processes.enter_context(Server(programs, root / LEVEL, PLAYERS, bind=bind))
        port = int(re.search(r":(\d+)$", server.address).group(1))
        attacker = processes.enter_context(Attack(programs, port, attack, seconds))
        lasts = AMPLIFYING_SECONDS if attack["amplifies"] else seconds
        duration = SETTLE + max(lasts, NEWCOMER_SECONDS + 1) + 1
        players = processes.enter_context(bots(programs, attacker.relay, BOTS, duration, SETTLE - 1, 1))
        time.sleep(SETTLE)
        measured = watch(programs, server, attacker, players, seconds, port)
        played = players.result()
        ticks = server.stop()
    if played["connected"] == 0:
        raise Failure(f"attack {attack['name']}: no bot played to the end: {played['errors']}")
    return Result(
        attack=attack,
        missed=played["missedInputsPer1000Ticks"],
        disconnected=played["failed"] + round(BOTS * played["resumes"]),
        desyncs=round(BOTS * played["hashMismatches"]),
        p50=ticks["p50Us"] / 1000,
        p99=ticks["p99Us"] / 1000,
        longest=ticks["longestUs"] / 1000,
        **measured,
    )
