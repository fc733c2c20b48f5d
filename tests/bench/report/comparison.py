"""Compares Platon with every other engine, in every measure of the report."""

from report_data import BODIES, ENGINES, IDEAL_PLACE, PLATFORMER, RANDOM, count, jam_share

OTHERS = ENGINES[1:]
FLOATS = ("float32", "float64")

EXTRA = "Platon also proves each move on the lattice and asks for faces, rules and warps; they do none of this."
SLEEPS = "A body of theirs that sleeps costs almost nothing, and a step that loses the rest of its motion at a contact is short."
CACHES = "Platon keeps the segments near a body with their obstacles and separating edges; they keep indices, or nothing."
PUSHED = "They let the body overlap or keep a gap, and so pass ends that protrude by more than Platon's nudge of 7 subunits."
SAME_JOINTS = "The same joints slow both; the loss falls into one step or into two."
LATTICE = "The position is a lattice point, so it is off by about a subunit; the remainder holds the rest."


class Measure:
    """One column of the comparison: rows in which a lower value is better, and why another engine may be ahead."""

    def __init__(self, name, rows, value, why="", layout="{:.3g}", own="platon"):
        """`value(row, engine)` is None if the engine has no result. `why` is a sentence or {engine: sentence}."""
        self.name, self.rows = name, list(rows)
        self._value, self._why, self._layout, self._own = value, why, layout, own

    def pairs(self, engine):
        """[(row, value of Platon, value of the engine)] of the rows that both have."""
        found = [(row, self._value(row, self._own), self._value(row, engine)) for row in self.rows]
        return [pair for pair in found if None not in pair]

    def behind(self, engine):
        return [pair for pair in self.pairs(engine) if pair[1] > pair[2]]

    def why(self, engine):
        reason = self._why.get(engine) if isinstance(self._why, dict) else self._why
        return reason or "This run does not show why."

    def text(self, value):
        return count(round(value)) if value == int(value) else self._layout.format(value)

    def cell(self, engine):
        pairs, behind = self.pairs(engine), self.behind(engine)
        if not pairs:
            return ""
        if behind:
            return f"behind in {len(behind)} of {len(pairs)}"
        ahead = sum(own < other for _, own, other in pairs)
        return "equal" if not ahead else "ahead" if ahead == len(pairs) else f"ahead in {ahead} of {len(pairs)}, else equal"

    def line(self):
        """One line that says where Platon is behind and why; None if it is not."""
        parts, reasons = [], {}
        for engine in OTHERS:
            behind = self.behind(engine)
            if not behind:
                continue
            row, own, other = max(behind, key=lambda pair: (pair[1] / pair[2] if pair[2] > 0 else float("inf"), pair[1]))
            parts.append(f"{engine} in {len(behind)} of {len(self.pairs(engine))}, most in {row}: "
                         f"{self.text(own)} against {self.text(other)}")  # fmt: skip
            reasons[self.why(engine)] = None
        return f"{self.name}: {'; '.join(parts)}. {' '.join(reasons)}" if parts else None


class _Named(tuple):
    """(segments, bodies) that prints as words."""

    def __str__(self):
        segments, bodies = self
        return f"{count(segments)} segments, {count(bodies)} {'body' if bodies == 1 else 'bodies'}"


def measures(data):
    """All measures of a report. Lower is better in each."""
    def of_sets(key):
        def value(row, engine):
            result = data.sweep(row, engine)
            return None if result is None else key(result)
        return value

    def of_cases(key):
        return lambda row, engine: key(data.hard_case(row, engine))

    def of_steps(kind, key):
        return lambda row, engine: key(data.step(engine, *row, kind))

    def of_times(row, engine):
        return data.worst_path_error(engine, int(row.split(" ticks")[0].replace(" ", "")))

    def of_resolutions(row, engine):
        result = data.on_ladder(engine, int(row.split(" sub")[0].replace(" ", "")))
        return None if result is None else result["maxTrajectoryError"]

    random, platformer = ([_Named(row) for row in data.scenes(kind)] for kind in (RANDOM, PLATFORMER))
    sizes = [_Named((n, BODIES)) for n in data.sizes()]
    joints = [name for name in data.cases() if name.startswith("joints")]
    wedges = [name for name in data.cases() if name.startswith("wedge")]
    rests = [name for name in data.cases() if name.startswith("rest")]
    times = [f"{count(n)} ticks" for n in data.times()]
    ladder = [f"{count(n)} subunits a unit" for n in data.resolutions()]
    step_why = {**dict.fromkeys(FLOATS, EXTRA), **dict.fromkeys(OTHERS[2:], SLEEPS)}
    wide = "A sweep in integers multiplies and compares in 128 bits; they round."
    grid = "All three have the same grid; the difference is in the allocator."
    yield Measure("sweeps, missed and false hits", data.sets(), of_sets(lambda r: r["missed"] + r["false"]))
    yield Measure("sweeps, error of the time", data.sets(), of_sets(lambda r: r["maxTimeError"]))
    yield Measure("sweeps, overlap", data.sets(), of_sets(lambda r: r["maxOverlap"]))
    yield Measure("sweeps, ns", data.sets(), of_sets(lambda r: r["nsPerQuery"]), wide, "{:.0f}")
    yield Measure("steps among random segments, ns", random, of_steps(RANDOM, lambda r: r["nsPerStep"]), step_why, "{:.0f}")
    yield Measure("steps in a platformer, ns", platformer, of_steps(PLATFORMER, lambda r: r["nsPerStep"]), step_why, "{:.0f}")
    for kind, rows in ((RANDOM, random), (PLATFORMER, platformer)):
        yield Measure(f"jams, {kind}, share of half seconds", rows, of_steps(kind, jam_share))
    yield Measure("memory of a segment, bytes", sizes, of_steps(RANDOM, lambda r: round(r["bytesPerSegment"], 1)), grid, "{:.1f}")
    yield Measure("memory of a body, bytes", sizes, of_steps(RANDOM, lambda r: round(r["bytesPerMover"])), CACHES, "{:.0f}")
    yield Measure("hard cases, overlap", data.cases(), of_cases(lambda r: r["maxOverlap"]))
    yield Measure("hard cases, passed through a segment", wedges, of_cases(lambda r: r["tunnelled"]))
    yield Measure("joints, steps that lose speed", joints, of_cases(lambda r: r["speedDrops"]),
                  {**dict.fromkeys(FLOATS, SAME_JOINTS), **dict.fromkeys(OTHERS[2:], PUSHED)})  # fmt: skip
    yield Measure("joints, steps that end too high", joints, of_cases(lambda r: r["pops"]))
    yield Measure("drift at rest", rests, of_cases(lambda r: r["restDrift"]))
    yield Measure("gap or overlap at rest", rests, of_cases(lambda r: abs(r["restGap"])))
    yield Measure("trajectory, position", times, of_times, LATTICE)
    yield Measure("trajectory, position + remainder", times, of_times, own=IDEAL_PLACE)
    yield Measure("resolution, position", ladder, of_resolutions, LATTICE)
    yield Measure("resolution, position + remainder", ladder, of_resolutions, own=IDEAL_PLACE)
