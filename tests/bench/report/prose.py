"""The text of docs/speed_vs_error.md. Sentences with figures are made from the run."""

from report_data import (BODIES, COMPUTED, ENGINES, PATH_ENGINES, PLATFORMER, RANDOM, SEGMENTS, STEP_ENGINES, SUBUNITS,
                         count, doubts_of, is_jammed, jam_share)  # fmt: skip

OTHERS = ENGINES[1:]
EXACT = 0
ENOUGH = 1e-6   # of a displacement

HEAD = """Each measurement of speed on this page is shown with the error of the same engine. The page and its pictures are written by

    ./platon bench

in one run: {machine}; compiler {compiler}, `{flags}`. Times are processor times of one thread. The engines are measured in \
turn, pass by pass, so that other load on the machine affects all of them. A time is the median of {passes} passes, with the \
lowest and highest in brackets. On another machine the times differ; the ratios differ less. `./platon bench --quick` prints a \
shorter run as text and does not change this page.

![Deepest overlap against the cost of a step](pictures/speed_error_step.svg)
![Error of sweeps against their cost](pictures/speed_error_sweep.svg)
![Cost against number of segments](pictures/cost_segments.svg)
![Cost against number of segments in a platformer](pictures/cost_platformer.svg)
![Error of the trajectory against time](pictures/error_time.svg)
![Error against resolution](pictures/error_resolution.svg)

Low is better in all pictures, and so is left where the axis is a cost. Lengths are in subunits. For engines that use metres, 16 384 subunits are a metre. A \
level unit has 1 024 subunits; the player's radius is 12 units, so 0.75 m."""

AIMED = "Bounds in nanoseconds are for a quiet core of a current server processor; ratios are of this run."

MISSED_HEAD = "Why aims are missed, and what was tried:"

# By a part of the name of an aim: why it is missed, and what was tried.
MISSED = {
    "joints-1-mm": "Joints: an end that protrudes by more than 7 subunits stops the body for good reason: a larger nudge would lift it "
                   "visibly. The loss of such a stop falls into two steps here, into one with float64.",
    "a sweep, hard": "Sweeps: where a path crosses many half planes, the times of the crossings are compared in 128 bits.",
    "segments, relative to float64": "Steps: most of the difference is in slides: each takes products of 128 bits and proves every move of the "
                                     "position, which float64 does not. What helped is in: a step that meets nothing ends early, a slide "
                                     "begins with the segment of the last step. Tried without effect: 64-bit tests before those with 128, "
                                     "instructions of x86-64-v3. Regions twice as large are faster here, but slower in a platformer.",
    "a step, 10 000 bodies": "Many bodies: their caches do not fit into those of the processor. Fetching those of the next bodies in advance "
                          "helped little, and cost more with fewer bodies.",
    "`Game::advance`": "`Game::advance`: a player near an edge has several instances, each with its own segments near by, and the rules of the game come "
                       "on top of the step.",
}

ENGINES_USED = """All engines have the same segments and the same octagons. There is no friction, restitution or rotation, and bodies do \
not collide with each other. Velocities are set before each step of 1/60 s. Only the platformer has gravity.

- `platon`: the world as it ships. It repeats the step of a body at rest from memory, without computing it.
- `platon-computed`: the same world, but its memory of rests is of no use: the vertical velocity of every body changes by one \
subunit a step back and forth, so no step equals the last one, and each is computed. Nothing else differs; the library has no \
switch for it.
- `platon+remainder`: the same world; its place is the position and its remainder, which is how the library stores where the body \
ideally is. `platon` alone is the position on the lattice.
- `float32`, `float64`: the same algorithm in floating point, with the same grid. It keeps a gap to segments, because without \
one it falls through them at the first rounding error: 1/256 of a unit in float32, 2⁻²⁰ in float64. It has no faces, rules, \
angles or lattice, and does not handle segment ends that protrude. In the platformer the caller adds gravity, as for Platon: this \
time counts.
- `box2d-2.4`: in metres. Dynamic bodies with `bullet` and `fixedRotation`. They may sleep in the platformer; elsewhere their \
velocities are set before every step, so they could not. Each segment is a two-sided \
`b2EdgeShape` without neighbours, because segments come in any order. 8 velocity and 3 position iterations, as its manual \
recommends. By design, it stops in front of segments because of a skin around its shapes, and limits a body to 2 m a step \
(120 m/s). Both reduce its overlaps here.
- `chipmunk-7.0`: in metres. It has no continuous collision detection; its manual recommends smaller steps and thicker \
segments. It takes as many steps a tick as keep the fastest body below half its radius a step; its time includes all of them. \
Segments are 5 mm thick and its slop is 5 mm, as in Box2D (its default is meant for pixels). Velocities are set in its velocity \
callback. In the platformer, bodies may sleep after half a second, as in Box2D. Debian 12 builds it with assertions, which costs some time. It cannot sweep a polygon, so it has no sweeps.

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
nanoseconds per body and step. † marks a row in which the engine [jammed](#jams)."""

PLATFORMER_STEPS = """In the platformer, storeys of tiles of 1 m, some of them raised by 1 m, lie 4 m above each other. A third of the \
octagons stand. The others walk at 6 m/s, change direction at random every half second, and then jump in half of the cases. Every \
engine gets the same commands. Its peers let bodies at rest sleep."""

JAMS = """### Jams

A jammed body costs little, so a row of a jammed engine is not comparable. At least eight more half seconds are run after the \
measured passes. A body is jammed in a half second if it moves by less than 10 % of the wanted distance, where float64 moves by more \
than 50 % of it, from the same place with the same velocity. There, the shape is 2 % smaller, which is more than the slop of every \
engine. If the body overlaps nothing at that place, float64 must move on with the full shape, too. A row is named if a body is jammed \
in more than 1 % of the half seconds:"""

BOX2D_3 = """`{0}` is a checkout of Box2D 3, built by its own CMake files, with AVX2 where the processor has it. In metres. Bodies \
do not rotate; each segment is a two-sided `b2Segment`; four substeps, as its manual recommends, and one thread. It informs only: \
it has no sweeps, and no comparison or aim counts it."""

NO_BOX2D_3 = """Box2D 3 is not part of this run, because Debian 12 does not have it. `PLATON_BOX2D3=FOLDER ./platon bench` measures \
the checkout in this folder, too."""

MEMORY = f"""Heap bytes per segment; heap bytes per body, of {BODIES} bodies, including cached segments near it:"""

HARD_CASES = """{0} steps in each case. A cell gives the deepest overlap after any step, in subunits, and:

- wedges of 0.1°: the body is driven into the narrow end and back, at the given speed and up to 30° off the axis; \
`wedge-far-100-m/s` is about 30 km from the origin. The second number counts the steps after which it was outside the closed room (it is then put back);
- straight floors of segments whose ends are off by up to 2 subunits or 1 mm, at 10 m/s: steps with less than 99 % of their \
progress / steps that end more than 5 mm too high;
- pressed into a notch: drift between step 1 000 and the last step; gap to the nearest segment."""

TRAJECTORY = """Every engine moves the body of a scene for up to ten minutes, with the same velocity in every tick, from the same \
start. The ideal path is computed in rationals, as [exactness](exactness.md#how-i8-is-judged) defines it, and engines are never \
resynchronised with it. A cell gives the largest distance from it after any tick so far, in units: in the worst scene; in the median \
scene. There are {sceneFiles} scenes of `tests/exactness/reference/scenes` and {terrains} random terrains of slopes, overhangs, loose \
joints and points. A scene is measured up to the last time at which the ideal body was in contact within 100 ticks: {least} of them \
to the end. {ties} scenes are left out, because the ideal path has a tie ({dividedTies}), or one at a joint ({jointTies}); \
only the ideal path decides this. {leftContact} terrains are left out, because they end without contact. Box2D has no part in \
{without} scenes whose shape has more than eight vertices.

The slop of each engine counts in full as error: the gap of float32 (4·10⁻³ units) and of float64 (10⁻⁶ units), the gap of Box2D \
(15 mm, 0.24 units) and the overlap of Chipmunk (5 mm, 0.08 units). Box2D and Chipmunk also discard the rest of a step at a contact, \
by design, so they fall behind. An error that grows at the speed of the body means that the body is held, or has taken another way, \
where the ideal body goes on."""

RESOLUTION = """Scenes of `tests/exactness/reference` for 100 ticks, at 16 to 65 536 subunits a unit. A cell gives the largest \
distance from the ideal trajectory, computed in rationals, in units, and nanoseconds per step. A unit is a twelfth of a player's \
radius; the game has 1 024 subunits a unit. Platon's position is a lattice point: it is off by {low:.2f} to {high:.2f} subunits here, \
at any resolution, so a finer lattice makes the error smaller. `{precise}` is not rounded to the lattice. Floating point neither: its \
error is the gap it keeps at segment ends. Box2D and Chipmunk do not take part: by design, they discard the rest of a step at a contact, \
which gives another trajectory."""

PARTS = """One body moves the same small way back and forth in every scene; every face has the segments of the plane. Comparing \
the fastest passes, own rules take {rules:.2f} times as long as the plane, and a solid, away from its edges, {solid:.2f} times. A \
body at an edge costs time for every face that it reaches (instances). A crossing takes {crossing:.0f} ns more than moving along \
the edge. Rotations by 5° return to the same shapes, which are cached. In rows with new angles, every angle is one that the world has not seen: \
its shape must be built."""

DERIVED = """Memory that a world has beyond its saved state: caches and work space of the step, in bytes of the heap per body. A copy \
of the world does not have it, so it is what destroying the original frees beyond that."""

COMPARED = """Each column has several rows: sets, scenes, cases, sizes or times. Lower is better in all of them. Platon is ahead in \
a row if its value is lower, and equal only if both are the same. Times and bytes are compared as they are, however small the \
difference, also in rows in which an engine [jammed](#jams). For trajectories, Platon has two columns: its position, and its position and remainder."""


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
    told = _list(f"{ratio:.2f} times that of {engine}{doubts_of(engine, data.step(engine, SEGMENTS))}" for engine, ratio in ratios.items())
    yield f"A step of {BODIES} bodies among {count(SEGMENTS)} segments takes Platon {told}."
    for kind in (RANDOM, PLATFORMER):
        rows = {row: data.step("platon", *row, kind)["nsPerStep"] for row in data.scenes(kind)}
        faster = [e for e in OTHERS if any(data.step(e, *row, kind)["nsPerStep"] < ns for row, ns in rows.items())]
        yield f"Faster than Platon in at least one {kind} scene of whole steps: {_list(faster) if faster else 'none'}."
    yield memory_of_rests(data)
    jams = list(jam_lines(data))
    yield f"Engines that jammed in at least one row: {_list(dict.fromkeys(line.split(',')[0] for line in jams)) if jams else 'none'}."
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


def _path_verdicts(data):
    first, last = data.times()[0], data.times()[-1]
    errors = {e: data.worst_path_error(e, last) for e in PATH_ENGINES}
    told = _list(f"{e} {error:.1e}" for e, error in errors.items())
    yield (f"Largest distance from the ideal trajectory in {count(last)} ticks, in units, at {count(SUBUNITS)} subunits a unit: {told}. "
           f"{min(errors, key=errors.get)} is closest.")  # fmt: skip
    growth = {e: errors[e] / max(data.worst_path_error(e, first), 1e-12) for e in PATH_ENGINES}
    told = _list(f"{e} {ratio:.2g}" for e, ratio in growth.items())
    yield f"Growth of this distance from {count(first)} to {count(last)} ticks, as a factor: {told}."


def memory_of_rests(data):
    """A sentence about what the memory of rests saves, by kind of scenes."""
    parts = []
    for kind in (RANDOM, PLATFORMER):
        rows = [row for row in data.scenes(kind) if row[1] == BODIES]
        ratios = [data.step(COMPUTED, *row, kind)["nsPerStep"] / data.step("platon", *row, kind)["nsPerStep"] for row in rows]
        parts.append(f"{min(ratios):.2f} to {max(ratios):.2f} times in {kind} scenes")
    return f"Without its memory of rests, a step of {BODIES} bodies takes Platon {_list(parts)}."


def jam_lines(data):
    """The rows of whole steps in which an engine jammed."""
    for kind in (RANDOM, PLATFORMER):
        for engine in (*STEP_ENGINES, *data.guests()):
            rows = [(row, data.step(engine, *row, kind)) for row in data.scenes(kind)]
            named = [f"{count(s)} segments, {count(m)} {'body' if m == 1 else 'bodies'}: {100 * jam_share(r):.1f} %" for (s, m), r in rows if is_jammed(r)]
            if named:
                yield f"{engine}, {kind}: {'; '.join(named)}."


def verdicts(data):
    """Sentences about the results, good and bad."""
    yield from _step_verdicts(data)
    yield from _sweep_verdicts(data)
    yield from _hard_verdicts(data)
    yield from _path_verdicts(data)
