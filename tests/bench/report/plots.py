"""Plots of the report, drawn by gnuplot as SVG."""

import subprocess

COLOURS = {
    "platon": "#1b6ca8",
    "platon-computed": "#6fb1dd",
    "platon+remainder": "#0b2f4e",
    "float32": "#e08a1e",
    "float64": "#7a5fb5",
    "box2d-2.4": "#2f8f4e",
    "chipmunk-7.0": "#c0392b",
}

# The marks differ so that points at the same place can be told apart.
MARKS = {"platon": 4, "platon-computed": 6, "platon+remainder": 3, "float32": 5, "float64": 7, "box2d-2.4": 9, "chipmunk-7.0": 11}
GUEST_COLOUR, GUEST_MARK = "#7f8c8d", 13

HEAD = """set terminal svg size 820,460 font 'sans,14' background '#ffffff'
set output '{output}'
set title '{title}'
set xlabel '{x}'
set ylabel '{y}'
set logscale xy
set format '%g'
set grid
set key outside right top reverse Left
"""


class Plots:
    """Draws plots into one folder."""

    def __init__(self, folder):
        self._folder = folder
        folder.mkdir(parents=True, exist_ok=True)

    def points(self, name, labels, points, zero):
        """One point an engine, {engine: (x, y)}. A y of 0 has no logarithm: it is drawn at `zero`, and marked so."""
        rows = {engine: [(x, max(y, zero))] for engine, (x, y) in points.items()}
        settings = f"set yrange [{zero / 5}:*]\nset ytics add ('0' {zero})\nset xrange [10:*]\n"
        self._draw(name, labels, settings, rows, "points ps 2 lw 3")

    def curves(self, name, labels, curves, lowest=0):
        """{engine: [(x, y)]}. A y below `lowest` is drawn there."""
        rows = {engine: [(x, max(y, lowest)) for x, y in points] for engine, points in curves.items()}
        self._draw(name, labels, "", rows, "linespoints ps 0.8 lw 2")

    def _draw(self, name, labels, settings, rows, style):
        script = HEAD.format(output=self._folder / f"{name}.svg", **labels) + settings
        for i, points in enumerate(rows.values()):
            script += f"$data{i} << EOD\n" + "\n".join(f"{x} {y}" for x, y in points) + "\nEOD\n"
        parts = [
            f"$data{i} with {style} pt {MARKS.get(engine, GUEST_MARK)} lc rgb '{COLOURS.get(engine, GUEST_COLOUR)}' title '{engine}'"
            for i, engine in enumerate(rows)
        ]
        subprocess.run(["gnuplot"], input=script + "plot " + ", \\\n  ".join(parts) + "\n", text=True, check=True)
