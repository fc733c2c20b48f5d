"""The table with which docs/speed_vs_error.md opens, for readers who do not know the engines."""

from report_data import BODIES, SEGMENTS, SUBUNITS, count, doubts_of

SUBUNITS_PER_METRE = 16384
TICKS_PER_SECOND = 60

TEXT = """`./platon bench` measures these engines and writes this page. The time is for {bodies} bodies among {segments} random walls, in \
nanoseconds per body and step of 1/60 s. The overlap is the deepest of all [hard cases](#hard-cases). The distance from the exact path \
is that of the worst and of the median [scene](#trajectory-over-time). A body is 1.5 m wide. The rest of the page has the details, \
also where Platon is [behind](#platon-against-each-engine)."""

# {engine: (name, what it cannot do)}
ABOUT = {
    "platon": ("Platon", "Bodies have no mass, friction or bounce, and do not push each other. Walls do not move."),
    "float64": ("float64", "Platon's algorithm with rounding, made for this comparison. It keeps a gap to walls, and may go the other "
                "way where two are close. No solids, rules or rotation."),
    "float32": ("float32", "As float64, with a larger gap."),
    "box2d-2.4": ("Box2D 2.4", "A rigid-body engine, which does what Platon cannot. Bodies enter walls in narrow corners, and lose the "
                  "rest of a step at a contact."),
    "chipmunk-7.0": ("Chipmunk 7", "A rigid-body engine, too. It does not see walls between two steps, so it takes smaller ones."),
}  # fmt: skip
BOX2D_3 = ("Box2D 3", "As Box2D 2.4.")
NOT_MEASURED = "not in this run: `PLATON_BOX2D3=FOLDER ./platon bench`"


def length(metres):
    """A length in a unit that suits it, with two digits."""
    if metres == 0:
        return "0"
    for factor, unit in ((1000, "mm"), (1, "m"), (0.001, "km")):
        value = metres * factor
        if value < 1000:
            break
    return f"{value:.2g} {unit}" if value < 99.5 else f"{value:.0f} {unit}"


def span(ticks):
    seconds = ticks // TICKS_PER_SECOND
    return f"{seconds} s" if seconds < 60 else f"{seconds // 60} min"


def _row(data, engine, name, cannot, times):
    step = data.step(engine, SEGMENTS)
    through = sum(case["tunnelled"] for case in data.cases_of(engine))
    errors = [(data.worst_path_error(engine, n), data.median_path_error(engine, n)) for n in times]
    paths = ["; ".join(length(units * SUBUNITS / SUBUNITS_PER_METRE) for units in pair) for pair in errors]
    return [name, f"{step['nsPerStep']:.0f}{doubts_of(engine, step)}", length(data.overlap(engine) / SUBUNITS_PER_METRE),
            f"{count(through)} times" if through else "never", *paths, cannot]  # fmt: skip


def opening(data):
    """(text, heads, rows)"""
    times = [next((n for n in data.times() if n >= 10 * TICKS_PER_SECOND), data.times()[-1]), data.times()[-1]]
    rows = [_row(data, engine, *ABOUT[engine], times) for engine in ABOUT]
    guests = [_row(data, engine, *BOX2D_3, times) for engine in data.guests()]
    rows[-1:-1] = guests or [[BOX2D_3[0], NOT_MEASURED, "", "", "", "", BOX2D_3[1]]]
    first, last = map(span, times)
    heads = ["engine", "a step, ns", "deepest overlap with a wall", "went through a wall",
             f"off the exact path in {first}: worst; median", f"in {last}: worst; median", "what it cannot do"]  # fmt: skip
    return TEXT.format(bodies=BODIES, segments=count(SEGMENTS)), heads, rows
