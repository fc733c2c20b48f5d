"""Runs cells and puts together what their programs tell."""

import contextlib
import statistics
import time
from concurrent.futures import ThreadPoolExecutor

from cells import ARRIVAL, Cell
from processes import Bots, Server

# A cell whose processes wait for a processor for more of the time, in per cent, tells of the machine and not of them.
DISTURBED = 30
ATTEMPTS = 2

# Of all bots, each as often as there are bots in its process.
MEANS = ("connectMs", "downBytesPerSecond", "upBytesPerSecond")


def combined(groups):
    """One result of those of several processes of bots. What a bot without the game cannot know is that of the others."""
    players = [group for group in groups if group["hashMismatches"] is not None]
    result = dict(players[0]) if players else {}
    connected = sum(group["connected"] for group in groups)
    for key in MEANS:
        result[key] = sum(group[key] * group["connected"] for group in groups) / max(connected, 1)
    result["connected"] = connected
    result["said"] = "; ".join(group["said"] for group in groups if group["said"])
    result["failed"] = sum(group["failed"] for group in groups)
    result["longestDatagramBytes"] = max(group["longestDatagramBytes"] for group in groups)
    return result


def _watch(processes, seconds):
    """The first process's share of a processor over this time, and the largest share of it that any of them waited for
    one; both in per cent."""
    before, begun = [process.processor_seconds() for process in processes], time.monotonic()
    time.sleep(seconds)
    after, passed = [process.processor_seconds() for process in processes], time.monotonic() - begun
    waits = [now[1] - then[1] for then, now in zip(before, after, strict=True)]
    return 100 * (after[0][0] - before[0][0]) / passed, 100 * max(waits) / passed


def is_disturbed(result):
    return result["waitPercent"] > DISTURBED


class Runner:
    """`attempts`: how often a cell is tried on a machine that has other things to do."""

    def __init__(self, programs, level, say, attempts=ATTEMPTS):
        self._programs = programs
        self._level = level
        self._say = say
        self._attempts = attempts

    def cell(self, cell):
        """What the bots and the server say of it, `cpuPercent` of the server and `waitPercent` while all play. Of
        several attempts the one that waited least."""
        tried = []
        while len(tried) < self._attempts:
            tried.append(self._try(cell))
            self._say(f"{cell.name}: {self._words(tried[-1])}")
            if not is_disturbed(tried[-1]):
                break
        return min(tried, key=lambda result: result["waitPercent"])

    def _try(self, cell):
        with contextlib.ExitStack() as processes:
            server = processes.enter_context(Server(self._programs, self._level, cell.players))
            bots = [processes.enter_context(Bots(self._programs, server, cell, count, hollow, seed))
                    for seed, (count, hollow) in enumerate(cell.groups, 1)]  # fmt: skip
            before = ARRIVAL + cell.settle
            time.sleep(before)
            cpu, wait = _watch([server, *bots], cell.seconds - before - 0.5)
            result = combined([process.result() for process in bots])
            result |= {"cpuPercent": cpu, "waitPercent": wait, "memoryBytes": server.memory_bytes(), "cell": cell}
            result |= server.stop()
            result["roundOver"] = int(server.find(r"round over .*") is not None)
        return result

    @staticmethod
    def _words(result):
        keys = ("connectMs", "downBytesPerSecond", "upBytesPerSecond", "missedInputsPer1000Ticks", "cpuPercent", "p99Us",
                "waitPercent")  # fmt: skip
        said = f"; {result['said']}" if result["said"] else ""
        return ", ".join(f"{key} {result[key]:.4g}" for key in keys) + said

    def plan(self, plan):
        """(results of the cells, what a server without players does)"""
        with ThreadPoolExecutor(plan.at_once) as pool:
            together = sorted(pool.map(self.cell, plan.together), key=lambda result: result["cell"].sort_key)
        alone = [self.cell(cell) for cell in plan.alone]
        return together, alone, self.without_players(plan)

    def without_players(self, plan):
        if not plan.starts:
            return {}
        start = statistics.median(self._start() for _ in range(plan.starts))
        return {"startMs": start, "starts": plan.starts, "atOnce": plan.at_once, **self._idle(plan.idle)}

    def _start(self):
        with Server(self._programs, self._level) as server:
            server.stop()
            return server.start_ms

    def _idle(self, seconds):
        visit = Cell(players=4, seconds=3, settle=0)
        with Server(self._programs, self._level) as server:
            time.sleep(0.5)
            fresh, _ = _watch([server], seconds)
            with Bots(self._programs, server, visit, visit.players, False, 1) as bots:
                bots.result()
            time.sleep(0.5)
            left, _ = _watch([server], seconds)
            server.stop()
        return {"idlePercent": fresh, "leftPercent": left}
