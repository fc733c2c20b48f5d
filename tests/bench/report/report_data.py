"""Access to the output of platon-bench --json by set, case and engine."""

ENGINES = ("platon", "float32", "float64", "box2d-2.4", "chipmunk-7.0")

# The scene in which whole steps are compared.
BODIES = 64
SEGMENTS = 10000


def count(number):
    """The number with its digits in groups of three."""
    return f"{number:,}".replace(",", " ")


class ReportData:
    def __init__(self, report):
        self.report = report
        self._sweeps = {(r["set"], r["engine"]): r for r in report["sweep"]}
        self._steps = {(r["engine"], r["segments"], r["movers"]): r for r in report["step"]}
        self._cases = {(r["case"], r["engine"]): r for r in report["hardCases"]}
        self._ladder = {(r["engine"], r["subunitsPerUnit"]): r for r in report["resolution"]}

    def sets(self):
        return list(dict.fromkeys(r["set"] for r in self.report["sweep"]))

    def cases(self):
        return list(dict.fromkeys(r["case"] for r in self.report["hardCases"]))

    def resolutions(self):
        return list(dict.fromkeys(r["subunitsPerUnit"] for r in self.report["resolution"]))

    def scenes(self):
        """(segments, bodies) of the whole steps."""
        return list(dict.fromkeys((r["segments"], r["movers"]) for r in self.report["step"]))

    def sweep(self, set_name, engine):
        """None if the engine cannot answer the set."""
        return self._sweeps.get((set_name, engine))

    def step(self, engine, segments, bodies=BODIES):
        return self._steps[engine, segments, bodies]

    def step_ns(self, engine, segments):
        return self.step(engine, segments)["nsPerStep"]

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
