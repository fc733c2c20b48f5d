"""The cells of the matrix: each is one server and its players under simulated network conditions."""

from dataclasses import dataclass

LOSSES = (0, 2, 10, 20)
DELAYS = (0, 50, 200)
JITTERS = (0, 20, 100)

# Seconds: all bots join within ARRIVAL; a bot is measured from SETTLE after its first tick, when its clock has settled.
ARRIVAL = 1
SETTLE = 4


@dataclass(frozen=True)
class Cell:
    """`loss` in per cent, `delay` and `jitter` in ms, each way, as in the options of platon-bot. `hollow`: number of
    players that do not simulate the game, since one machine is too slow to simulate it for all."""

    loss: int = 0
    delay: int = 0
    jitter: int = 0
    players: int = 16
    hollow: int = 0
    seconds: float = 25
    settle: float = SETTLE

    @property
    def name(self):
        return f"{self.players} players, {self.conditions}"

    @property
    def conditions(self):
        return f"loss {self.loss} %, delay {self.delay} ms, jitter {self.jitter} ms"

    @property
    def sort_key(self):
        return (self.players, self.loss, self.delay, self.jitter)

    @property
    def condition_options(self):
        options = {"--loss": self.loss, "--delay": self.delay, "--jitter": self.jitter}
        return [word for option, value in options.items() if value for word in (option, str(value))]

    @property
    def groups(self):
        """[(players, hollow)] of each process of bots."""
        return [(count, hollow) for count, hollow in ((self.hollow, True), (self.players - self.hollow, False)) if count]


@dataclass(frozen=True)
class Plan:
    """`together`: cells of which `at_once` run at the same time. `alone`: cells that run one after another. `idle`: seconds
    for which an empty server is measured. `starts`: how often a server is started to measure its start."""

    together: tuple
    at_once: int
    alone: tuple = ()
    idle: float = 0
    starts: int = 0


def _matrix(losses, delays, jitters, seconds):
    """Long delays, which cost bots the most time, are spread over the run."""
    return tuple(Cell(loss, delay, jitter, seconds=seconds) for loss in losses for jitter in jitters for delay in delays)


def _scale(seconds):
    return (Cell(players=4, seconds=seconds), Cell(seconds=seconds), Cell(players=64, hollow=56, seconds=seconds),
            Cell(2, 50, 0, players=64, hollow=56, seconds=seconds), Cell(players=256, hollow=252, seconds=seconds))  # fmt: skip


FULL = Plan(_matrix(LOSSES, DELAYS, JITTERS, 25), 4, _scale(25), idle=10, starts=9)
QUICK = Plan(_matrix((0, 10), (0, 200), (0, 100), 10), 4, _scale(12)[2:], idle=2, starts=3)

# A few cells, for the limits that are independent of the speed of the machine.
CORNERS = Plan(tuple(Cell(*conditions, seconds=10, settle=3) for conditions in
                     ((0, 0, 0), (2, 200, 100), (10, 50, 20), (20, 0, 20))), 4)  # fmt: skip
