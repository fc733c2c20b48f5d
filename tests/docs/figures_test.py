#!/usr/bin/env python3
"""Compares the figures in the docs with what the programs and sources give.

usage: figures_test.py ROOT BUILD [--write]

Each error is a line `page: what`; exit 1 if there is any. --write corrects the figures in the pages instead.
"""

import functools
import json
import re
import subprocess
import sys
from dataclasses import dataclass
from pathlib import Path
from typing import Callable

NUMBER = r"[\d ]*\d(?:\.\d+)?"


class FigureError(Exception):
    """A figure cannot be computed."""


@dataclass(frozen=True)
class Figures:
    """The numbers in `sentence`, whose places are marked {}, are those that `compute` returns, as text."""

    page: str
    sentence: str
    compute: Callable

    def pattern(self):
        return re.compile(f"({NUMBER})".join(re.escape(part) for part in self.sentence.split("{}")))


class Sources:
    """Figures from the programs in the build folder and from the sources."""

    def __init__(self, root, build):
        self.root = root
        self.build = build

    @functools.cache
    def run(self, *command):
        """Standard output of a program, which is run once."""
        tests = self.build / "tests/bin"
        program = tests / command[0] if (tests / command[0]).exists() else self.build / "bin" / command[0]
        words = [str(word).replace("platon-sim", str(self.build / "bin/platon-sim")) for word in command[1:]]
        finished = subprocess.run([program, *words], cwd=self.root, capture_output=True, text=True)
        if finished.returncode != 0:
            raise FigureError(f"{' '.join(map(str, command))} exits with {finished.returncode}: {finished.stderr.strip()}")
        return finished.stdout

    def constant(self, file, name):
        """The value of a constant of integers."""
        text = (self.root / file).read_text(encoding="utf-8")
        found = re.search(rf"\b{name}(?: = ([^;]+)|\{{([^}}]+)\}});", text)
        if not found:
            raise FigureError(f"{file} has no constant {name}")
        value = re.sub(r"std::(?:size_t|uint64_t)\{(\d+)\}", r"\1", found[1] or found[2])
        value = re.sub(r"std::chrono::(?:milli)?(?:seconds|minutes)\((\d+)\)", r"\1", value).replace("'", "")
        value = value.replace("kTicksPerSecond", "60")
        if re.fullmatch(r"k\w+", value):
            return self.constant(file, value)
        if not re.fullmatch(r"[\d\s*+/<.()-]+", value):
            raise FigureError(f"{file}: {name} = {value} is not understood")
        return eval(value)   # digits and operators only


def grouped(value):
    """Digits in groups of three, as the docs write them."""
    whole, point, rest = str(value).partition(".")
    return f"{int(whole):,}".replace(",", " ") + point + rest


def constant(file, name, scale=1):
    def compute(sources):
        value = sources.constant(file, name) * scale
        return [grouped(int(value) if value == int(value) else value)]
    return compute


def sweep_check(sources):
    output = sources.run("platon-sweep-check", "platon-sim", 10000)
    disagreements = int(re.search(r"^all: .*?(\d+) disagreements", output, re.MULTILINE)[1])
    lines = re.search(r"^bad lines: (\d+) tried, (\d+) failures", output, re.MULTILINE)
    return [str(disagreements + int(lines[2])), "1 000 000", lines[1]]


def scene_check(sources):
    output = sources.run("platon-scene-check", "platon-sim", 100, 2000, 1)
    return [grouped(number) for number in re.search(r"(\d+) entity ticks, (\d+) legs, (\d+) failures", output).groups()]


def joints(sources, line):
    """Steps, loss and lift, the latter two rounded up."""
    output = sources.run("joints_test")
    steps, loss, lift = re.findall(r"^(\d+) steps\D+([\d.]+)\D+([\d.]+)", output, re.MULTILINE)[line]
    return grouped(steps), float(loss), float(lift)


def round_up(value, digits):
    return f"{-(-value * 10**digits // 1) / 10**digits:.{digits}f}"


def first_joints(sources):
    steps, loss, lift = joints(sources, 0)
    return [steps, round_up(loss, 2), round_up(lift, 2)]


def second_joints(sources):
    steps, loss, lift = joints(sources, 1)
    return [steps, round_up(loss, 2), round_up(lift, 1)]


def trajectory(sources):
    """Distances of four scenes after 1, 60 and 3 600 ticks."""
    found = {}
    for result in json.loads(sources.run("platon-reference", "--json"))["trajectories"]:
        if result["subunitsPerUnit"] == 1024:
            found[result["scene"], result["ticks"]] = f"{result['errorSubunits']:.1f}"
    return [found[scene, ticks] for scene in ("bowl", "waves", "uphill", "floor") for ticks in (1, 60, 3600)]


def mutations(sources):
    command = [sys.executable, "-B", "tests/mutation/mutate.py", "--check"]
    output = subprocess.run(command, cwd=sources.root, capture_output=True, text=True, check=True).stdout
    count = re.search(r"(\d+) faults, 0 misfits", output)[1]
    return [count, count]


def jump(sources):
    """Run speed in units a tick, height and width of a jump in units."""
    speed, gravity, run = (sources.constant(PLAYER, name) for name in ("kJumpSpeed", "kGravity", "kRunSpeed"))
    apex = sources.constant(PLAYER, "kApexSpeed")
    height, peak, ticks = 0, 0, 0
    while height >= 0:
        speed -= gravity // 2 if -apex <= speed <= apex else gravity
        height += speed
        peak = max(peak, height)
        ticks += 1
    return [f"{run / 1024:.1f}", f"{peak / 1024:.1f}", f"{(ticks - 1) * run / 1024:.0f}"]


def apex(sources):
    """Largest vertical speed of the apex, units a tick."""
    return [f"{sources.constant(PLAYER, 'kApexSpeed') / 1024:.1f}"]


def falls(sources):
    """Largest speeds of a fall, without and with down, units a tick."""
    return [f"{sources.constant(PLAYER, name) / 1024:.1f}" for name in ("kFallSpeed", "kFastFallSpeed")]


def turn_round(sources):
    """Ticks from the run speed to the one in the other direction, on the ground."""
    text = (sources.root / PLAYER).read_text(encoding="utf-8")
    acceleration, turn = map(int, re.search(r"kGroundGrip\{(\d+), (\d+), \d+\}", text).groups())
    run = sources.constant(PLAYER, "kRunSpeed")
    speed, ticks = run, 0
    while speed > -run:
        speed -= min(turn, speed + acceleration) if speed > 0 else acceleration
        ticks += 1
    return [str(ticks)]


def tilts(sources):
    """Run speed in units a tick; deflections of the stick up to which the player walks and creeps, in per cent."""
    text = (sources.root / "client/ui/controls/gamepad_keys.h").read_text(encoding="utf-8")
    walk, creep = (float(re.search(rf"{name} = ([\d.]+)F", text)[1]) for name in ("kWalk", "kCreep"))
    return [f"{sources.constant(PLAYER, 'kRunSpeed') / 1024:.1f}", f"{100 * walk:.0f}", f"{100 * creep:.0f}"]


def hint(sources):
    """Seconds of a fall after which it is tried out, laps without a landing that show the hint, laps that restart."""
    patience, *laps = (
        sources.constant("client/netcode/player_watch.h", name) for name in ("kPatience", "kHintLaps", "kRestartLaps"))
    return [f"{patience / 60:g}", *map(str, laps)]


def nudge(sources):
    radius = sources.constant("shared/physics/tolerances.h", "kNudge")
    span = range(-radius, radius + 1)
    return [str(radius), str(sum(0 < x * x + y * y <= radius * radius for x in span for y in span))]


def golden_hash(sources, name):
    """Ticks and hash of a golden recording."""
    recording = f"tests/determinism/golden/{name}.recording"
    result = json.loads(sources.run("platon-sim", "verify", recording, "--json"))
    return [str(result["ticks"]), result["hash"]]


def quoted(page, pattern):
    """The first number that the pattern finds in another page."""
    def compute(sources):
        found = re.search(pattern, (sources.root / page).read_text(encoding="utf-8"))
        if not found:
            raise FigureError(f"{page} has no '{pattern}'")
        return [found[1]]
    return compute


def joined(*computations):
    """What several computations return, one after the other."""
    return lambda sources: [figure for compute in computations for figure in compute(sources)]


def grace(sources):
    """Seconds of the drain of a server in a fleet, and those that it has more to stop."""
    (drain,), (period,) = (quoted(FLEET, pattern)(sources) for pattern in (r"--drain=(\d+)", r"terminationGracePeriodSeconds: (\d+)"))
    return [drain, str(int(period) - int(drain))]


PLAYER = "shared/include/platon/game/player_motion.h"
STEP = "shared/physics/step/step_state.h"
LIMITS = "protocol/limits.h"
SCHEDULE = "server/fleet/agones_reporter.h"
LINK = "server/program/agones_link.cpp"
FLEET = "deploy/agones/fleet.yaml"
EMPTY = constant(SCHEDULE, "kEmptyTime")
COUNT = constant(SCHEDULE, "kCountInterval")
PING = constant(SCHEDULE, "kHealthInterval")
RETRY = joined(constant(SCHEDULE, "kFirstPause", 0.001), constant(SCHEDULE, "kMaxPause"))
BUFFER = "client/netcode/interpolation_buffer.h"

FIGURES = [
    Figures("docs/exactness.md", "at most {} moves (`StepLimits::kMaxLegs`)", constant(STEP, "kMaxLegs")),
    Figures("docs/exactness.md", "allow {} moves", constant("tests/exactness/oracle/trace/move_count.h", "kMaxMoves")),
    Figures("docs/exactness.md", "at most {} entries", constant("tests/exactness/oracle/trace/trace_checker.cpp", "kMaxEntries")),
    Figures("docs/exactness.md", "`Tolerances::kNudge` = {} subunits clears it, the step tries {} offsets", nudge),
    Figures("docs/exactness.md", "{} of {} differ; {} kinds of malformed line", sweep_check),
    Figures("docs/exactness.md", "{} entity ticks, {} legs, {} failures", scene_check),
    Figures("docs/exactness.md", "{} steps; none makes less than 99 % of the wanted progress minus {}; none ends more than {} above", first_joints),
    Figures("docs/exactness.md", "{} steps; none makes less than 97 % minus {}; none ends more than {} above", second_joints),
    Figures("docs/exactness.md", "bowl {}, {}, {}; waves {}, {}, {}; uphill {}, {}, {}; floor {}, {}, {}", trajectory),
    Figures("docs/exactness.md", "{} of {} are caught", mutations),
    Figures("docs/fleet.md", "when nobody has played for {} s, so that it may be removed", EMPTY),
    Figures("docs/fleet.md", "every {} s, from the tick loop", PING),
    Figures("docs/fleet.md", "the number of players has changed, and every {} s", COUNT),
    Figures("docs/fleet.md", "A call takes at most {} s", constant(LINK, "kCallLimit", 0.001)),
    Figures("docs/fleet.md", "is made again after {} s, doubled up to {} s", RETRY),
    Figures("docs/fleet.md", "The place is reserved for {} s at most", COUNT),
    Figures("docs/fleet.md", "When nobody has played for {} s, and nobody was sent there in this time, it is *ready* again", EMPTY),
    Figures("docs/fleet.md", "for at most {} s, which is more than a round takes", lambda sources: grace(sources)[:1]),
    Figures("docs/fleet.md", "and have {} s more to stop", lambda sources: grace(sources)[1:]),
    Figures("docs/fleet.md", "than a round takes ({} minutes)", constant("shared/include/platon/game/game.h", "kRoundTicks", 1 / 3600)),
    Figures("docs/fleet.md", "After three periods of {} s Agones replaces it", quoted(FLEET, r"periodSeconds: (\d+)\s+failureThreshold: 3\b")),
    Figures("docs/hosting.md", "again after {} s, doubled up to {} s; `health` every {} s", joined(RETRY, PING)),
    Figures("docs/hosting.md", "which waits at most {} s for it", constant(LINK, "kFinishLimit", 0.001)),
    Figures("docs/level_format.md", "runs at {} units a tick (60 ticks a second). A jump is {} units high and about {} units wide", jump),
    Figures("docs/level_format.md", "at most {} MiB", constant("shared/include/platon/game/level.h", "kMaxLevelBytes", 1 / (1 << 20))),
    Figures("docs/hosting.md", "wakes every {} ms", constant("server/app/dedicated_server.h", "kIdleWait")),
    Figures("docs/hosting.md", "the queue of {} lines", constant("server/program/async_line_writer.h", "kQueueLines")),
    Figures("docs/netcode.md", "within {} ms (`ErrorSmoothing::kDuration`)", constant("client/netcode/prediction.h", "kDuration")),
    Figures("docs/netcode.md", "lands after at least {} ticks in the air", constant("client/netcode/player_watch.h", "kMinAirTicks")),
    Figures("docs/netcode.md", "keeps the players of the last {} ticks", constant(BUFFER, "kMaxSnapshots")),
    Figures("docs/netcode.md", "lateness of the last {} ticks", constant(BUFFER, "kWindow")),
    Figures("docs/netcode.md", "and at most {} ticks. This is 25 ms", constant(BUFFER, "kMaxDelay")),
    Figures("docs/netcode.md", "a folder takes at most {} reports", constant("client/desync/desync_report.h", "kMaxReports")),
    Figures("docs/playing.md", "fallen for {} s and would not land within {} laps, or have fallen for as many, you are told that R "
            "returns to the start; after lap {} the client presses R itself", hint),
    Figures("docs/playing.md", "{} high and about {} wide", lambda sources: jump(sources)[1:]),
    Figures("docs/playing.md", "rises or falls by at most {} a tick", apex),
    Figures("docs/playing.md", "at most {} a tick, and {} while down is held", falls),
    Figures("docs/playing.md", "run {} a tick, walk two thirds of it (the stick up to {} %), creep one third (the stick up to {} %", tilts),
    Figures("docs/playing.md", "the other way in {} ticks", turn_round),
    Figures("docs/playing.md", "in the {} ticks after the last one on the ground", constant(PLAYER, "kCoyoteTicks")),
    Figures("docs/playing.md", "in the {} ticks before the ball may jump", constant(PLAYER, "kJumpBufferTicks")),
    Figures("docs/playing.md", "{} frames of each quality", constant("client/play/offscreen/frame_benchmark.h", "kFrames")),
    Figures("docs/playing.md", "median is at most {} ms", constant("client/quality/quality_meter.h", "kHoldSeconds", 1000)),
    Figures("docs/protocol.md", "one message of at most {} bytes", constant(LIMITS, "kMaxMessageBytes")),
]  # fmt: skip

HASH = re.compile(r"^\| (\w+) \| (\d+) \| ([0-9a-f]{16}) \|", re.MULTILINE)


def golden_errors(sources):
    """The first table of hashes in docs/determinism.md is that of the golden recordings."""
    text = (sources.root / "docs/determinism.md").read_text(encoding="utf-8")
    documented = {name: [ticks, value] for name, ticks, value in HASH.findall(text) if ticks == "1800"}
    recorded = {path.stem for path in (sources.root / "tests/determinism/golden").glob("*.recording")}
    if recorded != documented.keys():
        yield f"docs/determinism.md: the table of hashes lists {sorted(documented)}, not {sorted(recorded)}"
    for name in sorted(recorded & documented.keys()):
        actual = golden_hash(sources, name)
        if actual != documented[name]:
            yield f"docs/determinism.md: {name} is {documented[name]}, not {actual}"


def compare(sources, figures, write):
    """The errors of one sentence; with `write` a wrong sentence is corrected."""
    page = sources.root / figures.page
    text = page.read_text(encoding="utf-8")
    found = figures.pattern().search(text)
    if not found:
        yield f"{figures.page}: no sentence '{figures.sentence}'"
        return
    actual, documented = figures.compute(sources), [number.strip() for number in found.groups()]
    if actual == documented:
        return
    documented_sentence, sentence = figures.sentence.format(*documented), figures.sentence.format(*actual)
    if write:
        page.write_text(text.replace(documented_sentence, sentence), encoding="utf-8")
    else:
        yield f"{figures.page}: '{documented_sentence}' should be '{sentence}'"


def errors_of(sources, write):
    for figures in FIGURES:
        try:
            yield from compare(sources, figures, write)
        except FigureError as error:
            yield f"{figures.page}: '{figures.sentence}': {error}"
    yield from golden_errors(sources)


def main(arguments):
    write = arguments[2:] == ["--write"]
    if len(arguments) != 2 and not write:
        print(__doc__, file=sys.stderr)
        return 2
    errors = list(errors_of(Sources(*(Path(argument).resolve() for argument in arguments[:2])), write))
    for error in errors:
        print(error)
    return 1 if errors else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
