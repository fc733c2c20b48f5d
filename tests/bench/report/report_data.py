"""Access to the output of platon-bench --json by set, case and engine."""

ENGINES = ("platon", "float32", "float64", "box2d-2.4", "chipmunk-7.0")

# Platon without its memory of rests, and Platon whose position includes the remainder.
COMPUTED = "platon-computed"
IDEAL_PLACE = "platon+remainder"
STEP_ENGINES = ("platon", COMPUTED, *ENGINES[1:])
PATH_ENGINES = ("platon", IDEAL_PLACE, *ENGINES[1:])

# The scene in which whole steps are compared.
BODIES = 64
SEGMENTS = 10000
MANY_BODIES = 10000
RANDOM, PLATFORMER = "random", "platformer"

# An engine is jammed in a row if its bodies are jammed in more than this share of the half seconds.
JAMMED = 0.01

# What its library costs an engine, whatever it does.
HANDICAPS = {"chipmunk-7.0": "built with assertions"}

SUBUNITS = 1024  # of a level unit


def count(number):
    """The number with its digits in groups of three."""
    return f"{number:,}".replace(",", " ")


class ReportData:
    def __init__(self, report):
        self.report = report
        self._sweeps = {(r["set"], r["engine"]): r for r in report["sweep"]}
        self._steps = {(r["scenes"], r["engine"], r["segments"], r["movers"]): r for r in report["step"]}
        self._cases = {(r["case"], r["engine"]): r for r in report["hardCases"]}
        self._ladder = {(r["engine"], r["subunitsPerUnit"]): r for r in report["resolution"]}

    def sets(self):
        return list(dict.fromkeys(r["set"] for r in self.report["sweep"]))

    def cases(self):
        return list(dict.fromkeys(r["case"] for r in self.report["hardCases"]))

    def resolutions(self):
        return list(dict.fromkeys(r["subunitsPerUnit"] for r in self.report["resolution"]))

    def scenes(self, kind=RANDOM):
        """(segments, bodies) of the whole steps of one kind of scenes."""
        return list(dict.fromkeys((r["segments"], r["movers"]) for r in self.report["step"] if r["scenes"] == kind))

    def guests(self):
        """Engines that took part in whole steps, hard cases and trajectories because the run was asked for them. They inform only."""
        return [engine for engine in dict.fromkeys(r["engine"] for r in self.report["step"]) if engine not in STEP_ENGINES]

    def sizes(self):
        """Numbers of segments of the whole steps."""
        return list(dict.fromkeys(segments for segments, _ in self.scenes()))

    def sweep(self, set_name, engine):
        """None if the engine cannot answer the set."""
        return self._sweeps.get((set_name, engine))

    def step(self, engine, segments, bodies=BODIES, kind=RANDOM):
        return self._steps[kind, engine, segments, bodies]

    def step_ns(self, engine, segments, kind=RANDOM):
        return self.step(engine, segments, BODIES, kind)["nsPerStep"]

    def times(self):
        """Ticks after which the distance from the ideal trajectory is measured."""
        return sorted({r["ticks"] for r in self.report["trajectory"]})

    def path_errors(self, engine, ticks):
        """{scene: largest distance from the ideal trajectory up to this tick, units}"""
        found = self.report["trajectory"]
        return {r["scene"]: r["maxError"] for r in found if (r["engine"], r["ticks"]) == (engine, ticks)}

    def worst_path_error(self, engine, ticks):
        return max(self.path_errors(engine, ticks).values())

    def median_path_error(self, engine, ticks):
        errors = sorted(self.path_errors(engine, ticks).values())
        return errors[len(errors) // 2]

    def hard_case(self, name, engine):
        return self._cases[name, engine]

    def on_ladder(self, engine, resolution):
        """None if the engine has no result at this resolution."""
        return self._ladder.get((engine, resolution))

    def sweeps_of(self, engine):
        return [r for r in self.report["sweep"] if r["engine"] == engine]

    def cases_of(self, engine):
        return [r for r in self.report["hardCases"] if r["engine"] == engine]

    def wrong(self, engine):
        """Number of missed and false hits in all sets."""
        return sum(r["missed"] + r["false"] for r in self.sweeps_of(engine))

    def time_error(self, engine):
        return max(r["maxTimeError"] for r in self.sweeps_of(engine))

    def overlap(self, engine):
        """Deepest overlap of all hard cases."""
        return max(r["maxOverlap"] for r in self.cases_of(engine))

    def median_sweep_ns(self, engine):
        """Median over the sets that every engine with sweeps can answer."""
        times = sorted(r["nsPerQuery"] for r in self.sweeps_of(engine) if self.sweep(r["set"], "box2d-2.4"))
        return times[len(times) // 2]


def jam_share(result):
    """Share of the half seconds in which a body was jammed in this row of whole steps."""
    return result["jammed"] / result["halfSeconds"] if result["halfSeconds"] else 0


def is_jammed(result):
    return jam_share(result) > JAMMED


def doubts_of(engine, result):
    """Why the time of an engine in a row of whole steps says less than those of others, in brackets; else nothing."""
    jam = f"jammed in {100 * jam_share(result):.1f} % of the half seconds" if is_jammed(result) else None
    doubts = [doubt for doubt in (jam, HANDICAPS.get(engine)) if doubt]
    return f" ({'; '.join(doubts)})" if doubts else ""
