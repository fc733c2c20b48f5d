"""The aims of the simulation, and whether a run met them."""

from prose import MISSED
from report_data import (BODIES, COMPUTED, IDEAL_PLACE, MANY_BODIES, PLATFORMER, SEGMENTS, SUBUNITS, count,
                         doubts_of)  # fmt: skip

PEERS = ("box2d-2.4", "chipmunk-7.0")
RANDOM_SETS = ("random", "random-12-gon")

RELATIVE = ", relative to float64"
MANY = f"a step, {count(MANY_BODIES)} bodies, {count(SEGMENTS)} segments, relative to {BODIES} bodies"
ADVANCE = "`Game::advance`, per player"
NEW_ANGLES = "plane, rotating by 4.99°, new angles"
MAX_LATTICE_ERROR = 2  # subunits
MAX_PRECISE_ERROR = 1e-6  # units

# The level with the most segments near a player.
CROWDED_LEVEL = "level_18_after_you"


def _sweep_row(data, name, sets):
    """No set takes longer than with float64."""
    ratios = {s: data.sweep(s, "platon")["nsPerQuery"] / data.sweep(s, "float64")["nsPerQuery"] for s in sets}
    worst = max(ratios, key=ratios.get)
    above = sum(ratio > 1 for ratio in ratios.values())
    return name, "≤ 1.0 × float64", f"{ratios[worst]:.2f} × float64 ({worst}); above in {above} of {len(ratios)}", above == 0


def _speed_rows(data):
    sets = data.sets()
    yield _sweep_row(data, "a sweep, random, the slowest set", [s for s in sets if s in RANDOM_SETS])
    yield _sweep_row(data, "a sweep, hard, the slowest set", [s for s in sets if s not in RANDOM_SETS])
    own = data.step_ns("platon", SEGMENTS)
    best = min(PEERS, key=lambda engine: data.step_ns(engine, SEGMENTS))
    shares = "; ".join(f"{own / data.step_ns(engine, SEGMENTS):.2f} × {engine}{doubts_of(engine, data.step(engine, SEGMENTS))}"
                       for engine in sorted(PEERS, key=lambda engine: engine != best))  # fmt: skip
    share = own / data.step_ns(best, SEGMENTS)
    many = data.step_ns("platon", 100000)
    growth = many / data.step_ns("platon", 100)
    where = f"a step, {BODIES} bodies, {count(SEGMENTS)} segments"
    computed = data.step_ns(COMPUTED, SEGMENTS)
    yield where, "≤ 200 ns a body", f"{own:.0f} ns; {computed:.0f} ns without memory of rests", own <= 200
    floating = data.step_ns("float64", SEGMENTS)
    ratios = own / floating, computed / floating
    yield where + RELATIVE, "≤ 1.05", f"{ratios[0]:.2f}; {ratios[1]:.2f} without memory of rests", ratios[0] <= 1.05
    ratio = data.step_ns("platon", SEGMENTS, PLATFORMER) / data.step_ns("float64", SEGMENTS, PLATFORMER)
    yield where + ", in a platformer" + RELATIVE, "≤ 0.9", f"{ratio:.2f}", ratio <= 0.9
    grown, other = (data.step(engine, SEGMENTS, MANY_BODIES)["nsPerStep"] / data.step_ns(engine, SEGMENTS) for engine in ("platon", "float64"))
    yield MANY, "≤ 1.15", f"{grown:.2f}; float64 {other:.2f}", grown <= 1.15
    yield where + ", relative to the faster of Box2D and Chipmunk", "≤ 0.5", shares, share <= 0.5
    yield f"a step, {BODIES} bodies, 100 000 segments", "≤ 400 ns a body", f"{many:.0f} ns", many <= 400
    yield "the same, relative to 100 segments", "≤ 1.6", f"{growth:.2f}", growth <= 1.6


def _state_rows(report):
    size = max(r["bytesPerSegment"] for r in report["step"] if r["engine"] == "platon")
    shot = report["snapshot"]
    time = shot["saveNs"] + shot["restoreNs"]
    yield "memory of a segment", "≤ 64 bytes", f"{size:.1f} bytes", size <= 64
    yield f"{shot['movers']} bodies saved and restored", "< 1 µs", f"{time:.0f} ns", time < 1000
    yield f"{shot['movers']} bodies, saved", "< 8 192 bytes", f"{count(shot['bytes'])} bytes", shot["bytes"] < 8192
    again = next(r for r in report["resimulation"] if (r["players"], r["ticks"]) == (64, 60))["microseconds"]
    yield "64 players, replay of 60 ticks", "≤ 2 ms", f"{again / 1000:.2f} ms", again <= 2000
    time = next(r["nsPerPlayerTick"] for r in report["advance"] if r["level"] == CROWDED_LEVEL)
    yield f"{ADVANCE}, {CROWDED_LEVEL}", "≤ 300 ns", f"{time:.0f} ns", time <= 300
    others = {r["level"]: r["nsPerPlayerTick"] for r in report["advance"] if r["level"] != CROWDED_LEVEL}
    slowest, above = max(others, key=others.get), sum(time > 250 for time in others.values())
    yield f"{ADVANCE}, the slowest other level", "≤ 250 ns", f"{others[slowest]:.0f} ns ({slowest}); above on {above} of {len(others)}", above == 0
    time = shot["hashNs"]
    yield f"hash of {shot['movers']} players", "≤ 400 ns", f"{time:.0f} ns; {shot['gameHashNs']:.0f} ns the whole game", time <= 400
    turned = next(r for r in report["parts"] if r["scene"] == NEW_ANGLES)
    time, made = turned["nsPerStep"], turned["allocationsPerStep"]
    yield "a step that turns by an angle never seen", "≤ 500 ns; no allocation", f"{time:.0f} ns; {made:.2f} allocations", time <= 500 and made == 0
    most = max(report["derived"], key=lambda r: r["bytesPerMover"])
    size = most["bytesPerMover"]
    yield "derived state of a body, largest", "≤ 2 048 bytes", f"{count(round(size))} bytes ({most['scene']})", size <= 2048


def _path_rows(data):
    last = data.times()[-1]
    worst, allowed = data.worst_path_error("platon", last) * SUBUNITS, MAX_LATTICE_ERROR
    yield f"position, distance from the ideal one in {count(last)} ticks", f"≤ {allowed} subunits", f"{worst:.2f} subunits", worst <= allowed
    own, other = ({(n, scene): error for n in data.times() for scene, error in data.path_errors(engine, n).items()}
                  for engine in (IDEAL_PLACE, "float64"))  # fmt: skip
    above = sum(error > max(other[key], MAX_PRECISE_ERROR) for key, error in own.items())
    yield ("position + remainder, the same, every scene and time", "≤ float64's, or ≤ 10⁻⁶ units",
           f"{max(own.values()):.1e} units; above in {above} of {count(len(own))}", above == 0)  # fmt: skip


def _exactness_rows(data):
    wrong, error = data.wrong("platon"), data.time_error("platon")
    yield "wrong sweeps; error of the time", "0; 0", f"{wrong}; {error:g}", (wrong, error) == (0, 0)
    cases = [data.hard_case(name, "platon") for name in data.cases()]
    overlap, outside = max(r["maxOverlap"] for r in cases), sum(r["tunnelled"] for r in cases)
    yield "overlap; tunnelling, in hard cases", "0; 0", f"{overlap:g}; {outside}", (overlap, outside) == (0, 0)
    drift = max(r["restDrift"] for r in cases)
    yield "drift at rest", "0", f"{drift:g}", drift == 0
    for name in [name for name in data.cases() if name.startswith("joints")]:
        case = data.hard_case(name, "platon")
        seen = case["speedDrops"], case["pops"]
        yield f"steps that lose speed; steps that end too high, {name}", "0; 0", f"{seen[0]}; {seen[1]} in {count(case['steps'])} steps", seen == (0, 0)


def target_rows(data):
    """Rows of (name, aim, measured, whether it is met)."""
    yield from _exactness_rows(data)
    yield from _path_rows(data)
    yield from _speed_rows(data)
    yield from _state_rows(data.report)


def missed_lines(rows):
    """Why aims are missed, as far as that is known, and what was tried."""
    missed = [name for name, _, _, holds in rows if not holds]
    return [reason for key, reason in MISSED.items() if any(key in name for name in missed)]
