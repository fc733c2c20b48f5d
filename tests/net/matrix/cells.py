"""What is run: each cell is one server with players on one kind of line."""

from dataclasses import dataclass

LOSSES = (0, 2, 10, 20)
DELAYS = (0, 50, 200)
JITTERS = (0, 20, 100)

# Bots come in the first second; until this long after its first tick a bot's clock settles, and it is not measured.
ARRIVAL = 1
SETTLE = 4


@dataclass(frozen=True)
class Cell:
    """`loss` in per cent, `delay` and `jitter` in ms, each way, as the options of platon-bot have it. `hollow` of the
    players do not play the game, because so many that do would need more machines than one."""

    loss: int = 0
    delay: int = 0
    jitter: int = 0
    players: int = 16
    hollow: int = 0
    seconds: float = 25
    settle: float = SETTLE

    @property
    def name(self):
        return f"{self.players} players, {self.line}"

    @property
    def line(self):
        return f"loss {self.loss} %, delay {self.delay} ms, jitter {self.jitter} ms"

    @property
    def sort_key(self):
        return (self.players, self.loss, self.delay, self.jitter)

    @property
    def line_options(self):
        options = {"--loss": self.loss, "--delay": self.delay, "--jitter": self.jitter}
        return [word for option, value in options.items() if value for word in (option, str(value))]

    @property
    def groups(self):
        """(players, whether hollow) of each process of bots."""
        return [(count, hollow) for count, hollow in ((self.hollow, True), (self.players - self.hollow, False)) if count]


@dataclass(frozen=True)
class Plan:
    """`together`: cells that run at the same time, so many at once. `alone`: cells whose server has the machine for
    itself, but for its bots. `idle`: seconds for which an empty server is watched. `starts`: how often one is started."""

    together: tuple
    at_once: int
    alone: tuple = ()
    idle: float = 0
    starts: int = 0


def _matrix(losses, delays, jitters, seconds):
    """Long lines, which take bots the most time, are spread over the run."""
    return tuple(Cell(loss, delay, jitter, seconds=seconds) for loss in losses for jitter in jitters for delay in delays)


def _scale(seconds):
    return (Cell(seconds=seconds), Cell(players=64, hollow=56, seconds=seconds),
            Cell(2, 50, 0, players=64, hollow=56, seconds=seconds), Cell(players=256, hollow=252, seconds=seconds))  # fmt: skip


FULL = Plan(_matrix(LOSSES, DELAYS, JITTERS, 25), 4, _scale(25), idle=10, starts=9)
QUICK = Plan(_matrix((0, 10), (0, 200), (0, 100), 10), 4, _scale(12)[1:], idle=2, starts=3)

# The corners of the matrix, for what does not depend on how fast the machine is.
CORNERS = Plan(tuple(Cell(*line, seconds=10, settle=3) for line in
                     ((0, 0, 0), (0, 200, 0), (2, 200, 100), (10, 50, 20), (10, 0, 100), (20, 0, 20))), 6)  # fmt: skip
