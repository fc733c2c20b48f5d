#!/usr/bin/env python3
"""Writes docs/speed_vs_error.md and its plots from the output of platon-bench --json.

usage: write_report.py REPORT.json ROOT
"""

import json
import os
import platform
import sys
from pathlib import Path

from comparison import OTHERS, measures
from opening import opening
from plots import Plots
from prose import (AIMED, BOX2D_3, COMPARED, DERIVED, ENGINES_USED, HARD_CASES, HEAD, JAMS, MEMORY, MISSED_HEAD, NO_BOX2D_3, PARTS,
                   PLATFORMER_STEPS, RESOLUTION, STEPS, SWEEP_ERRORS, SWEEPS, TRAJECTORY, jam_lines, memory_of_rests, verdicts)  # fmt: skip
from report_data import (BODIES, ENGINES, IDEAL_PLACE, PATH_ENGINES, PLATFORMER, RANDOM, SEGMENTS, STEP_ENGINES, ReportData, count,
                         is_jammed)  # fmt: skip
from targets import missed_lines, target_rows

PICTURES = "docs/pictures"

# Where a logarithmic axis shows an error of 0.
NO_TIME_ERROR = 1e-19
NO_OVERLAP = 1e-5
NO_DISTANCE = 1e-12

CROSSING, NO_CROSSING = "solid, over an edge back and forth", "solid, along an edge back and forth"


def table(heads, rows):
    lines = [heads, ["---"] * len(heads), *rows]
    return "\n".join(f"| {' | '.join(map(str, line))} |" for line in lines)


def short(value):
    if value == 0:
        return "0"
    return f"{value:.1e}" if abs(value) < 0.001 else f"{value:.3g}" if abs(value) < 1000 else count(round(value))


def spread(result, key, digits=0):
    """Median, lowest and highest pass as text."""
    median, low, high = (f"{result[key + end]:.{digits}f}" for end in ("", "Low", "High"))
    return f"{median} ({low}–{high})"


def by_engine(rows, find, cell, first="", engines=ENGINES):
    """A row for each of `rows` and a column for each engine; a cell is empty if `find` returns None."""
    lines = []
    for row in rows:
        found = [find(row, engine) for engine in engines]
        lines.append([row, *("" if result is None else cell(result) for result in found)])
    return table([first, *engines], lines)


def draw_all(data, folder):
    plots = Plots(folder)
    plots.points(
        "speed_error_step",
        {"title": "Whole steps", "x": f"ns per body and step, {BODIES} bodies, {count(SEGMENTS)} segments",
         "y": "deepest overlap in the hard cases, subunits"},
        {engine: (data.step_ns(engine, SEGMENTS), data.overlap(engine)) for engine in (*ENGINES, *data.guests())},
        NO_OVERLAP)  # fmt: skip
    plots.points(
        "speed_error_sweep",
        {"title": "Sweeps", "x": "ns a query, median of the sets", "y": "largest relative error of the time"},
        {engine: (data.median_sweep_ns(engine), data.time_error(engine)) for engine in ENGINES if data.sweeps_of(engine)},
        NO_TIME_ERROR)  # fmt: skip
    for name, title, kind in (("cost_segments", "Cost of a step among random segments", RANDOM), ("cost_platformer", "Cost of a step in a platformer", PLATFORMER)):
        plots.curves(
            name,
            {"title": title, "x": "segments", "y": f"ns per body and step, {BODIES} bodies"},
            {engine: [(n, data.step_ns(engine, n, kind)) for n in data.sizes()] for engine in (*STEP_ENGINES, *data.guests())})  # fmt: skip
    plots.curves(
        "error_time",
        {"title": "Error of the trajectory over time", "x": "ticks", "y": "worst distance from the ideal one, units"},
        {engine: [(n, data.worst_path_error(engine, n)) for n in data.times()] for engine in (*PATH_ENGINES, *data.guests())},
        NO_DISTANCE)  # fmt: skip
    ladder = {}
    for result in data.report["resolution"]:
        ladder.setdefault(result["engine"], []).append((result["subunitsPerUnit"], result["maxTrajectoryError"]))
    plots.curves(
        "error_resolution",
        {"title": "Error of the trajectory", "x": "subunits a unit", "y": "worst distance from the ideal one, units"},
        ladder)  # fmt: skip


def sweep_tables(data):
    met = {r["set"]: f"{100 * r['meetings'] / r['questions']:.0f} %" for r in data.sweeps_of("platon")}
    times = by_engine(data.sets(), data.sweep, lambda r: spread(r, "nsPerQuery"), "ns a query")
    errors = by_engine(
        [f"{name}, {met[name]} hit" for name in data.sets()],
        lambda row, engine: data.sweep(row.split(",")[0], engine),
        lambda r: f"{count(r['missed'])} / {count(r['false'])}; " + "; ".join(short(r[key]) for key in ("maxTimeError", "maxOverlap")),
    )
    return SWEEPS.format(count(data.sweeps_of("platon")[0]["questions"])), times, SWEEP_ERRORS, errors


def step_times(data, kind):
    """The times of whole steps; those of jammed rows are marked."""
    def cell(result):
        return spread(result, "nsPerStep") + (" †" if is_jammed(result) else "")

    engines = (*STEP_ENGINES, *data.guests())
    rows = [[count(s), count(m), *(cell(data.step(e, s, m, kind)) for e in engines)] for s, m in data.scenes(kind)]
    return table(["segments", "bodies", *engines], rows)


def step_tables(data):
    layout = "{bytesPerSegment:.1f}; {bytesPerMover:.0f}"
    engines = (*ENGINES, *data.guests())
    memory = [[count(n), *(layout.format(**data.step(e, n)) for e in engines)] for n in data.sizes()]
    jams = "\n".join(f"- {line}" for line in jam_lines(data)) or "No engine jammed in any row."
    return (STEPS, step_times(data, RANDOM), PLATFORMER_STEPS, step_times(data, PLATFORMER), memory_of_rests(data),
            JAMS, jams, MEMORY, table(["segments", *engines], memory))  # fmt: skip


def hard_case_tables(data):
    ends = ("driven into a wedge", "pushed along a floor", "at rest")
    cells = (
        lambda r: f"{short(r['maxOverlap'])}; {r['tunnelled']}",
        lambda r: f"{short(r['maxOverlap'])}; {r['speedDrops']} / {r['pops']}",
        lambda r: f"{short(r['maxOverlap'])}; {short(r['restDrift'])}; {short(round(r['restGap'], 6))}",
    )
    yield HARD_CASES.format(count(min(r["steps"] for r in data.report["hardCases"])))
    for start, end, cell in zip(("wedge", "joints", "rest"), ends, cells, strict=True):
        cases = [name for name in data.cases() if name.startswith(start)]
        yield by_engine(cases, data.hard_case, cell, end, (*ENGINES, *data.guests()))


def path_tables(data):
    shown = data.report["trajectoryScenes"]
    least = min(len(data.path_errors("platon", n)) for n in data.times())
    without = len(data.path_errors("platon", data.times()[0])) - len(data.path_errors("box2d-2.4", data.times()[0]))
    rows = []
    engines = (*PATH_ENGINES, *data.guests())
    for n in data.times():
        cells = (f"{short(data.worst_path_error(e, n))}; {short(data.median_path_error(e, n))}" for e in engines)
        rows.append([count(n), len(data.path_errors("platon", n)), *cells])
    text = TRAJECTORY.format(**shown, least=least, without=without, ties=shown["dividedTies"] + shown["jointTies"])
    return text, table(["ticks", "scenes", *engines], rows)


def ladder_tables(data):
    shown = [engine for engine in PATH_ENGINES if data.on_ladder(engine, data.resolutions()[0])]
    rows = []
    for n in data.resolutions():
        found = [data.on_ladder(engine, n) for engine in shown]
        own = f"{found[0]['maxTrajectoryError'] * n:.2f}"
        rows.append([count(n), own, *(f"{short(r['maxTrajectoryError'])}; {spread(r, 'nsPerStep')}" for r in found)])
    errors = [r["maxTrajectoryError"] * r["subunitsPerUnit"] for r in data.report["resolution"] if r["engine"] == "platon"]
    heads = ["subunits a unit", "platon's error in subunits", *shown]
    return RESOLUTION.format(low=min(errors), high=max(errors), precise=IDEAL_PLACE), table(heads, rows)


def part_tables(data):
    cost = {r["scene"]: r["nsPerStepLow"] for r in data.report["parts"]}
    plain = next(r["nsPerStep"] for r in data.report["parts"] if r["scene"] == "plane")
    crossings = next(r["crossingsPerStep"] for r in data.report["parts"] if r["scene"] == CROSSING)
    text = PARTS.format(
        rules=cost["plane, own rules"] / cost["plane"], solid=cost["solid, middle of a face"] / cost["plane"],
        crossing=max(0, (cost[CROSSING] - cost[NO_CROSSING]) / crossings))  # fmt: skip
    rows = []
    for r in data.report["parts"]:
        times = f"{r['nsPerStep'] / plain:.2f}"
        rows.append([r["scene"], spread(r, "nsPerStep"), times, f"{r['instances']:.2f}", f"{r['crossingsPerStep']:.4f}",
                     f"{r['allocationsPerStep']:.2f}"])  # fmt: skip
    return text, table(["step of one body", "ns", "× the plain plane", "instances", "crossings a step", "allocations a step"], rows)


def game_tables(data):
    shot = data.report["snapshot"]
    rows = [[f"{end} {shot['movers']} bodies, {count(shot['bytes'])} bytes, {shot['level']}", spread(shot, f"{end}Ns") + " ns"]
            for end in ("save", "restore", "hash")]  # fmt: skip
    rows.append([f"hash the whole game of {shot['movers']} players, {shot['level']}", spread(shot, "gameHashNs") + " ns"])
    rows += [[f"{r['players']} players, {r['ticks']} ticks replayed, {r['level']}", spread(r, "microseconds") + " µs"]
             for r in data.report["resimulation"]]  # fmt: skip
    rows += [[f"`Game::advance`, {r['level']}, per player of {r['players']}", spread(r, "nsPerPlayerTick") + " ns"]
             for r in data.report["advance"]]  # fmt: skip
    derived = [[r["scene"], r["movers"], f"{r['bytesPerMover']:.0f}"] for r in data.report["derived"]]
    return table(["", "median (spread)"], rows), DERIVED, table(["scene", "bodies", "bytes a body"], derived)


def comparison_tables(data):
    found = list(measures(data))
    cells = [[measure.name, len(measure.rows), *(measure.cell(engine) for engine in OTHERS)] for measure in found]
    lines = [line for line in (measure.line() for measure in found) if line]
    told = "\n".join(f"- {line}" for line in lines) or "Platon is behind in no row of any column."
    return COMPARED, table(["column", "rows", *OTHERS], cells), "Where Platon is behind, and why:", told


def machine():
    cpu = platform.processor() or platform.machine()
    info = Path("/proc/cpuinfo")
    if info.exists():
        names = [line.split(":", 1)[1].strip() for line in info.read_text().splitlines() if line.startswith("model name")]
        cpu = names[0] if names else cpu
    return f"{cpu}, {os.cpu_count()} processors"


def used_engines(data):
    guests = [BOX2D_3.format(engine) for engine in data.guests()]
    return [ENGINES_USED, *(guests or [NO_BOX2D_3])]


def document(report):
    data = ReportData(report)
    told, *first_table = opening(data)
    targets = list(target_rows(data))
    held = [[name, aim, measured, "yes" if holds else "**no**"] for name, aim, measured, holds in targets]
    missed = "\n".join(f"- {line}" for line in missed_lines(targets))
    sections = {
        "Results": ["\n".join(f"- {verdict}" for verdict in verdicts(data))],
        "Platon against each engine": comparison_tables(data),
        "Aims": [AIMED, table(["what", "aim", "measured", "holds"], held), *([MISSED_HEAD, missed] if missed else [])],
        "How each engine is used": used_engines(data),
        "Sweeps": sweep_tables(data),
        "Whole steps": step_tables(data),
        "Hard cases": hard_case_tables(data),
        "Trajectory over time": path_tables(data),
        "Resolution": ladder_tables(data),
        "Cost of features": part_tables(data),
        "Games": game_tables(data),
    }
    text = ["# Speed against error", told, table(*first_table), HEAD.format(machine=machine(), **report["build"])]
    for head, parts in sections.items():
        text += [f"## {head}", *parts]
    return "\n\n".join(text) + "\n"


def main(arguments):
    if len(arguments) != 2:
        sys.exit(__doc__)
    report = json.loads(Path(arguments[0]).read_text(encoding="utf-8"))
    root = Path(arguments[1]).resolve()
    text = document(report)
    draw_all(ReportData(report), root / PICTURES)
    (root / "docs/speed_vs_error.md").write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main(sys.argv[1:])
