"""The text of docs/speed_vs_error.md. Sentences with figures are made from the run."""

from report_data import ENGINES, BODIES, SEGMENTS, count

OTHERS = ENGINES[1:]
EXACT = 0
ENOUGH = 1e-6   # of a displacement
DEFAULT_RESOLUTION = 1024

HEAD = """# Speed against error

Each measurement of speed on this page is shown with the error of the same engine. The page and its pictures are written by

    ./platon bench

in one run: {machine}; compiler {compiler}, `{flags}`. Times are processor times of one thread. The engines are measured in \
turn, pass by pass, so that other load on the machine affects all of them. A time is the median of {passes} passes, with the \
lowest and highest in brackets. On another machine the times differ; the ratios differ less. `./platon bench --quick` prints a \
shorter run as text and does not change this page.

![Deepest overlap against the cost of a step](pictures/speed_error_step.svg)
![Error of sweeps against their cost](pictures/speed_error_sweep.svg)
![Cost against number of segments](pictures/cost_segments.svg)
![Error against resolution](pictures/error_resolution.svg)

In all pictures, low and left is better. Lengths are in subunits. For engines that use metres, 16 384 subunits are a metre. A \
level unit has 1 024 subunits; the player's radius is 12 units, so 0.75 m."""

AIMED = "Bounds in nanoseconds are for a quiet core of a current server processor; ratios are of this run."

ENGINES_USED = """All engines have the same segments and the same octagons. There is no gravity, friction, restitution or rotation, and \
bodies do not collide with each other. Velocities are set before each step of 1/60 s.

- `platon`: the world as it ships. It repeats the step of a body at rest without computing it: up to a tenth of all steps here.
- `float32`, `float64`: the same algorithm in floating point, with the same grid. It keeps a gap to segments, because without \
one it falls through them at the first rounding error: 1/256 of a unit in float32, 2⁻²⁰ in float64. It has no faces, rules, \
angles or lattice, and does not handle segment ends that protrude.
- `box2d-2.4`: in metres. Dynamic bodies with `bullet` and `fixedRotation` that never sleep. Each segment is a two-sided \
`b2EdgeShape` without neighbours, because segments come in any order. 8 velocity and 3 position iterations, as its manual \
recommends. By design, it stops in front of segments because of a skin around its shapes, and limits a body to 2 m a step \
(120 m/s). Both reduce its overlaps here.
- `chipmunk-7.0`: in metres. It has no continuous collision detection; its manual recommends smaller steps and thicker \
segments. It takes as many steps a tick as keep the fastest body below half its radius a step; its time includes all of them. \
Segments are 5 mm thick and its slop is 5 mm, as in Box2D (its default is meant for pixels). Velocities are set in its velocity \
callback. Debian 12 builds it with assertions, which costs some time. It cannot sweep a polygon, so it has no sweeps.

Box2D and Chipmunk are Debian's libraries with Debian's compiler flags; the other engines use the flags above."""

SWEEPS = """Each set has {0} queries: when does the octagon first meet the segment on a given displacement? The far sets \
(`far-1e3`, `far-1e5`) are 10^3 and 10^5 m from the origin; the latter uses 4 096 subunits a metre to stay within the \
coordinates. Segments of `long-lines` are 10 km long, of `short-lines` at most nine subunits. Bodies of `touching` touch the \
segment at the start. `full-range` and `slivers` use the whole range of coordinates. In `slivers`, displacement and segment are 10⁻¹⁷ to \
10⁻¹³ rad from parallel and end close to each other. Box2D answers with `b2TimeOfImpact`. It does not allow twelve vertices, and \
`far-1e5`, `long-lines`, `full-range` and `slivers` are far outside the range of 0.1 to 10 m for which its manual recommends it."""

SWEEP_ERRORS = """Each cell: missed hits / false hits; the largest error of the time of the found hits, relative to the \
displacement; the deepest overlap in subunits, at the reported time or on a path reported as free. An oracle that shares no code \
with Platon gives the true answers, and times are compared as rationals, so a 0 is exact. Box2D stops in front of segments by \
design; here this counts as an error of the time and, when it passes close by, as a false hit."""

STEPS = """Octagons move among random segments at up to 22 m/s and change direction every half second. The table gives \
nanoseconds per body and step."""

MEMORY = f"""Heap bytes per segment; heap bytes per body, of {BODIES} bodies, including cached segments near it:"""

HARD_CASES = """{0} steps in each case. A cell gives the deepest overlap after any step, in subunits, and:

- wedges of 0.1°: the body is driven into the narrow end and back, at the given speed and up to 30° off the axis; \
`wedge-far-100-m/s` is about 30 km from the origin. The second number counts the steps after which it was outside the closed room (it is then put back);
- straight floors of segments whose ends are off by up to 2 subunits or 1 mm, at 10 m/s: steps with less than 99 % of their \
progress / steps that end more than 5 mm too high;
- pressed into a notch: drift between step 1 000 and the last step; gap to the nearest segment."""

RESOLUTION = """Scenes of `tests/exactness/reference` for 100 ticks, at 16 to 65 536 subunits a unit. A cell gives the largest \
distance from the ideal trajectory, computed in rationals, in units, and nanoseconds per step. A unit is a twelfth of a player's \
radius; the game has 1 024 subunits a unit. Platon rounds each leg to the lattice, by a subunit or two, and these errors add up: \
to {low:.0f} to {high:.0f} subunits here, at any resolution. So a finer lattice makes the error smaller. Floating point does not \
round to a lattice: its error is the gap it keeps at segment ends. Box2D and Chipmunk do not take part: by design, they discard \
the rest of a step at a contact, which gives another trajectory."""

PARTS = """One body moves the same small way back and forth in every scene; every face has the segments of the plane. Comparing \
the fastest passes, own rules take {rules:.2f} times as long as the plane, and a solid, away from its edges, {solid:.2f} times. A \
body at an edge costs time for every face that it reaches (instances). A crossing takes {crossing:.0f} ns more than moving along \
the edge. Rotations by 5° return to the same shapes, which are cached; by 4.99° nearly every shape is new and must be built."""


def _list(words):
    words = list(words)
    return " and ".join([", ".join(words[:-1]), words[-1]] if len(words) > 1 else words)


def _sweep_verdicts(data):
    asked = sum(r["questions"] for r in data.sweeps_of("platon"))
    wrong = {e: data.wrong(e) for e in ENGINES if data.sweeps_of(e)}
    told = _list(f"{engine} {count(n)}" for engine, n in wrong.items())
    yield f"Missed or false hits in {count(asked)} sweeps: {told}. Box2D does not answer those with twelve vertices."
    for engine in ("float32", "float64"):
        ratios = [data.sweep(s, "platon")["nsPerQuery"] / data.sweep(s, engine)["nsPerQuery"] for s in data.sets()]
        slower = sum(ratio > 1 for ratio in ratios)
        yield (f"{engine} sweeps faster than Platon in {slower} of {len(ratios)} sets: Platon takes "
               f"{min(ratios):.2f} to {max(ratios):.2f} times its time.")  # fmt: skip
    good = [s for s in data.sets() if not data.sweep(s, "float64")["missed"] + data.sweep(s, "float64")["false"]]
    error = max((data.sweep(s, "float64")["maxTimeError"] for s in good), default=0)
    enough = ", which is accurate enough for a game" if good and error < ENOUGH else ""
    yield (f"In {len(good)} of {len(data.sets())} sets float64 has no missed and no false hit; its times there are off by at most "
           f"{error:.0e} of the displacement{enough}.")  # fmt: skip


def _step_verdicts(data):
    own = data.step_ns("platon", SEGMENTS)
    ratios = {engine: own / data.step_ns(engine, SEGMENTS) for engine in OTHERS}
    told = _list(f"{ratio:.2f} times that of {engine}" for engine, ratio in ratios.items())
    yield f"A step of {BODIES} bodies among {count(SEGMENTS)} segments takes Platon {told}."
    own = {scene: data.step("platon", *scene)["nsPerStep"] for scene in data.scenes()}
    faster = [e for e in OTHERS if any(data.step(e, *scene)["nsPerStep"] < ns for scene, ns in own.items())]
    yield f"Faster than Platon in at least one scene of whole steps: {_list(faster) if faster else 'none'}."
    growth = data.step_ns("platon", 100000) / data.step_ns("platon", 100)
    yield f"With 100 000 segments, a step of Platon takes {growth:.2f} times as long as with 100."


def _hard_verdicts(data):
    clean = [e for e in ENGINES if data.overlap(e) == EXACT]
    yield f"No overlap in any hard case: {_list(clean) if clean else 'none'}."
    deep = [f"{e} {data.overlap(e) / 16384:.3f} m" for e in ENGINES if e not in clean]
    if deep:
        yield f"Deepest overlaps of the others: {_list(deep)}."
    out = {e: sum(r["tunnelled"] for r in data.cases_of(e)) for e in ENGINES}
    through = [f"{e} {count(n)} times" for e, n in out.items() if n]
    yield f"Passed through a segment: {_list(through) if through else 'none'}."
    for name in [name for name in data.cases() if name.startswith("joints")]:
        drops = {e: data.hard_case(name, e)["speedDrops"] for e in ENGINES}
        told = _list(f"{e} {count(n)}" for e, n in drops.items())
        steps = count(data.hard_case(name, "platon")["steps"])
        yield f"Steps that lose more than 1 % of their speed in {name}, of {steps}: {told}."
    gaps = _list(f"{e} {round(data.hard_case('rest-in-a-notch', e)['restGap'], 4) + 0:.4g}" for e in ENGINES)
    yield f"Gap between a body at rest and its floor, in subunits; negative: overlap: {gaps}."


def _resolution_verdicts(data):
    found = {e: data.on_ladder(e, DEFAULT_RESOLUTION) for e in ENGINES}
    errors = {e: r["maxTrajectoryError"] for e, r in found.items() if r}
    closest = min(errors, key=errors.get)
    told = _list(f"{e} {error:.1e}" for e, error in errors.items())
    yield (f"Largest distance from the ideal trajectory, in units, at {count(DEFAULT_RESOLUTION)} subunits a unit: {told}. "
           f"{closest} is closest.")  # fmt: skip


def verdicts(data):
    """Sentences about the results, good and bad."""
    yield from _step_verdicts(data)
    yield from _sweep_verdicts(data)
    yield from _hard_verdicts(data)
    yield from _resolution_verdicts(data)
