"""Runs cells and combines the results of their programs."""

import contextlib
import statistics
import time
from concurrent.futures import ThreadPoolExecutor

from cells import ARRIVAL, Cell
from processes import Bots, Server

# Per cent of the time. If a process waits longer for a processor, the cell measures the load of the machine.
DISTURBED = 30
ATTEMPTS = 2

# Averages over all bots: weighted by the number of bots in each process.
MEANS = ("connectMs", "downBytesPerSecond", "upBytesPerSecond")


def combined(groups):
    """Combines the results of several processes of bots. Values that hollow bots do not have come from the others."""
    players = [group for group in groups if group["hashMismatches"] is not None]
    result = dict(players[0]) if players else {}
    connected = sum(group["connected"] for group in groups)
    for key in MEANS:
        result[key] = sum(group[key] * group["connected"] for group in groups) / max(connected, 1)
    result["connected"] = connected
    result["errors"] = "; ".join(group["errors"] for group in groups if group["errors"])
    result["failed"] = sum(group["failed"] for group in groups)
    result["longestDatagramBytes"] = max(group["longestDatagramBytes"] for group in groups)
    return result


def _watch(processes, seconds):
    """(processor time of the first process, longest waiting time of any process), in per cent of the time watched."""
    before, begun = [process.processor_seconds() for process in processes], time.monotonic()
    time.sleep(seconds)
    after, passed = [process.processor_seconds() for process in processes], time.monotonic() - begun
    waits = [now[1] - then[1] for then, now in zip(before, after, strict=True)]
    return 100 * (after[0][0] - before[0][0]) / passed, 100 * max(waits) / passed


def is_disturbed(result):
    return result["waitPercent"] > DISTURBED


class Runner:
    """Runs cells, each up to `attempts` times if the machine is busy with other work."""

    def __init__(self, programs, level, say, attempts=ATTEMPTS):
        self._programs = programs
        self._level = level
        self._say = say
        self._attempts = attempts

    def cell(self, cell):
        """The results of bots and server, with `cpuPercent` of the server and `waitPercent` while all play. If there were
        several attempts: of the one with the shortest wait."""
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
        errors = f"; {result['errors']}" if result["errors"] else ""
        return ", ".join(f"{key} {result[key]:.4g}" for key in keys) + errors

    def plan(self, plan):
        """(results of `together`, results of `alone`, result of a server without players)"""
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
