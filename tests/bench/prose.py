"""The words of the report. Sentences that hold figures are made of the run's own."""

from report_data import ENGINES, MOVERS, SEGMENTS, count

OTHERS = ENGINES[1:]
EXACT = 0
ENOUGH = 1e-6   # of a displacement
DEFAULT_RESOLUTION = 1024

HEAD = """# Speed against error

Speed and accuracy both matter, so each is reported beside the other. This page and its pictures are written by

    ./platon bench

in one run, here on {machine}; compiled by {compiler}, `{flags}`. One thread, whose own time on the processor is \
measured. The engines take turns, pass by pass, so that whatever else the machine does meets all of them; a time is the median \
of {passes} passes, with the lowest and the highest in brackets. On another machine the times differ, the ratios less. `./platon bench --quick` prints a shorter run as text and \
leaves this page alone.

![Deepest overlap against the cost of a step](pictures/speed_error_step.svg)
![Error of sweeps against their cost](pictures/speed_error_sweep.svg)
![Cost against number of segments](pictures/cost_segments.svg)
![Error against resolution](pictures/error_resolution.svg)

The lower and the farther left, the better. Lengths are in subunits, of which 16 384 are taken for a metre where an engine \
counts in metres; a level unit has 1 024 of them, a player's radius 12 units, which is then 0.75 m."""

AIMED = "Bounds in nanoseconds are for a quiet core of a current server processor; ratios are of this run."

ENGINES_USED = """All have the same lines, the same octagons, no gravity, no friction, no bounce, no turning, and movers that \
do not meet each other; velocities are set before each step of a sixtieth of a second.

- `platon`: the world as it ships. It repeats the step of a mover that rests, pressed against lines: up to a tenth of all here.
- `float32`, `float64`: the same algorithm in floating point, lines out of the same grid. It keeps a slop before the lines, \
for without one it falls through at the first rounding: 1/256 of a unit in float32, 2⁻²⁰ in float64. It knows neither faces \
nor rules nor angles, keeps no lattice, and leaves out what takes Platon over ends of lines that stand out.
- `box2d-2.4`: metres; dynamic bodies with `bullet` and `fixedRotation`, never asleep; each line is a `b2EdgeShape` hit from \
both sides, without neighbours, since lines come in any order; 8 velocity and 3 position iterations, as its manual has it. It \
keeps a skin about its shapes and so stops in front of lines, and it clamps a body to 2 m a step (120 m/s): at 1 000 m/s it \
moves more slowly than it is told to. Both are its design, and both are in its favour where overlap is measured.
- `chipmunk-7.0`: metres; no continuous collision: its remedies are smaller steps and thicker lines. It takes as many steps a \
tick as keep the fastest mover below half its radius a step, and all count in its time; lines are 5 mm thick, its slop is \
5 mm, as Box2D's (the default is made for pixels). Velocities are set in its velocity callback, between its moves and its \
solver. Debian 12 builds it with its assertions on, which costs it some time. It cannot sweep a polygon, so it has no sweeps.

Box2D and Chipmunk are the system's libraries, compiled with its flags; the others with those above."""

SWEEPS = """{0} questions a set: when does the octagon, moved so far, first meet the line? `far-1e3` and `far-1e5` are so many \
metres from the origin, the last at 4 096 subunits a metre, or it would leave the coordinates; `long-lines` have 10 km, \
`short-lines` up to nine subunits; `touching` ones touch at the start; `full-range` and `slivers` use all of the coordinates, \
and of `slivers` the displacement and the line are 10⁻¹⁷ to 10⁻¹³ rad from parallel, and end a little before or behind each \
other. Box2D answers by `b2TimeOfImpact`; twelve vertices are more than it allows, and `far-1e5`, `long-lines`, `full-range` and \
`slivers` are far outside of the 0.1 to 10 m that its manual is meant for."""

SWEEP_ERRORS = """Meetings missed / meetings that are none; the worst error of the time, as a part of the displacement, of the \
meetings seen; the deepest overlap at the time told or on a way called free, subunits. The truth is that of an oracle that \
shares no code with Platon, and times are compared as rationals: a 0 is a 0. Box2D stops its slop in front, by design: that \
counts here as an error of time and, where it passes close by, as a meeting that is none."""

STEPS = """Octagons are flung among random lines, at 22 m/s at most, and take another direction every half second; \
nanoseconds a mover and step."""

MEMORY = f"""Bytes of the heap that a segment takes; that a mover takes, of {MOVERS}, with what is kept about the lines near \
it:"""

HARD_CASES = """{0} steps in each. Deepest overlap after any step, in subunits, and then:

- in a wedge of a tenth of a degree, into whose end the mover is driven and out again, at so many metres a second and up to \
30° aside, also 30 km from the origin: how often it was outside of the closed room (it is put back then);
- on a straight floor of pieces whose ends are off by up to 2 subunits or 1 mm, at 10 m/s: steps that made less than 99 % of \
their way / steps that ended more than 5 mm too high;
- pressed into a notch: drift between the thousandth step and the last; gap that is left to the nearest line."""

RESOLUTION = """Scenes of `tests/exactness/reference` for 100 ticks, each at 16 to 65 536 subunits a unit, against the ideal \
trajectory in rationals: the worst distance in units, and nanoseconds a step. A unit is a twelfth of a player's radius; the \
game has 1 024 subunits in one. Platon goes from lattice point to lattice point: every leg is rounded by a subunit or two, and \
a way of many legs adds them up. That makes {low:.0f} to {high:.0f} subunits here, whatever a subunit is, so the finer the \
lattice, the smaller the error. Floating point does not round to a lattice: its error is that of its slop at the ends of \
lines. Box2D and Chipmunk take no part: at a contact they give up what is left of the step, by design, which is another \
trajectory."""

PARTS = """One mover goes the same small way to and fro in every scene; the lines on every face are those of the plane. By \
the fastest passes, rules of its own make the plane take {rules:.2f} times as long, and a solid, away from its edges, takes \
{solid:.2f} times as long as the plane. A mover at an edge pays for every face that it reaches (instances); a crossing takes \
{crossing:.0f} ns more than going along the edge. Turning by whole steps of 5° comes back to the same shapes, which are kept; by \
4.99° nearly every one is new and has to be made."""


def _list(words):
    words = list(words)
    return " and ".join([", ".join(words[:-1]), words[-1]] if len(words) > 1 else words)


def _sweep_verdicts(data):
    asked = sum(r["questions"] for r in data.sweeps_of("platon"))
    wrong = {e: data.wrong(e) for e in ENGINES if data.sweeps_of(e)}
    told = _list(f"{engine} {count(n)}" for engine, n in wrong.items())
    yield f"Of {count(asked)} sweeps, missed or false: {told}; Box2D cannot be asked those of twelve vertices."
    for engine in ("float32", "float64"):
        ratios = [data.sweep(s, "platon")["nsPerQuery"] / data.sweep(s, engine)["nsPerQuery"] for s in data.sets()]
        slower = sum(ratio > 1 for ratio in ratios)
        yield (f"Sweeps in {engine} are faster than Platon's in {slower} of {len(ratios)} sets: Platon takes "
               f"{min(ratios):.2f} to {max(ratios):.2f} times as long.")  # fmt: skip
    good = [s for s in data.sets() if not data.sweep(s, "float64")["missed"] + data.sweep(s, "float64")["false"]]
    error = max((data.sweep(s, "float64")["maxTimeError"] for s in good), default=0)
    enough = ": where only such questions come, it is as accurate as a game needs" if good and error < ENOUGH else ""
    yield (f"In {len(good)} of {len(data.sets())} sets float64 misses nothing and invents nothing; there its times are right to "
           f"{error:.0e} of the displacement{enough}.")  # fmt: skip


def _step_verdicts(data):
    own = data.step_ns("platon", SEGMENTS)
    ratios = {engine: own / data.step_ns(engine, SEGMENTS) for engine in OTHERS}
    told = _list(f"{ratio:.2f} times that of {engine}" for engine, ratio in ratios.items())
    yield f"A step of {MOVERS} movers among {count(SEGMENTS)} segments costs Platon {told}."
    own = {scene: data.step("platon", *scene)["nsPerStep"] for scene in data.scenes()}
    faster = [e for e in OTHERS if any(data.step(e, *scene)["nsPerStep"] < ns for scene, ns in own.items())]
    yield f"Faster than Platon in at least one scene of whole steps: {_list(faster) if faster else 'none'}."
    growth = data.step_ns("platon", 100000) / data.step_ns("platon", 100)
    yield f"With 100 000 segments a step of Platon's costs {growth:.2f} times as much as with 100."


def _hard_verdicts(data):
    clean = [e for e in ENGINES if data.overlap(e) == EXACT]
    yield f"No overlap in any hard case: {_list(clean) if clean else 'none'}."
    deep = [f"{e} {data.overlap(e) / 16384:.3f} m" for e in ENGINES if e not in clean]
    if deep:
        yield f"Deepest overlaps of the others: {_list(deep)}."
    out = {e: sum(r["tunnelled"] for r in data.cases_of(e)) for e in ENGINES}
    through = [f"{e} {count(n)} times" for e, n in out.items() if n]
    yield f"Through a wall or a floor: {_list(through) if through else 'none'}."
    for name in [name for name in data.cases() if name.startswith("joints")]:
        drops = {e: data.hard_case(name, e)["speedDrops"] for e in ENGINES}
        told = _list(f"{e} {count(n)}" for e, n in drops.items())
        yield f"{name}, steps of {count(data.hard_case(name, 'platon')['steps'])} that lose more than 1 % of their speed: {told}."
    gaps = _list(f"{e} {round(data.hard_case('rest-in-a-notch', e)['restGap'], 4) + 0:.4g}" for e in ENGINES)
    yield f"Subunits between a mover at rest and what it rests on, below 0 where it overlaps: {gaps}."


def _resolution_verdicts(data):
    found = {e: data.on_ladder(e, DEFAULT_RESOLUTION) for e in ENGINES}
    errors = {e: r["maxTrajectoryError"] for e, r in found.items() if r}
    closest = min(errors, key=errors.get)
    told = _list(f"{e} {error:.1e}" for e, error in errors.items())
    yield (f"Farthest from the ideal trajectory, in units, at {count(DEFAULT_RESOLUTION)} subunits a unit: {told}. "
           f"{closest} follows it most closely.")  # fmt: skip


def verdicts(data):
    """Sentences on what the run shows, for and against."""
    yield from _step_verdicts(data)
    yield from _sweep_verdicts(data)
    yield from _hard_verdicts(data)
    yield from _resolution_verdicts(data)
