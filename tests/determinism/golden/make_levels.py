#!/usr/bin/env python3
"""Writes the hard levels of tests/determinism/golden/levels: geometry on which machines are most likely to disagree."""

import math
import pathlib
import random

SUBUNIT = 1 / 1024
SIDES = {"TETRAHEDRON": 3, "HEXAHEDRON": 4, "OCTAHEDRON": 3, "DODECAHEDRON": 5, "ICOSAHEDRON": 3}
FACES = {"TETRAHEDRON": 4, "HEXAHEDRON": 6, "OCTAHEDRON": 8, "DODECAHEDRON": 12, "ICOSAHEDRON": 20}
PLAYER = 12
ROOM = PLAYER + 6


def inner_radius(solid, size):
    return size / (2 * math.tan(math.pi / SIDES[solid]))


def number(value):
    return f"{value:.4f}".rstrip("0").rstrip(".") if value % 1 else str(int(value))


def distance(line, point):
    """Distance of a point from a line (x0, y0, x1, y1)."""
    x0, y0, x1, y1 = line
    dx, dy = x1 - x0, y1 - y0
    length = dx * dx + dy * dy
    along = 0 if length == 0 else max(0, min(1, ((point[0] - x0) * dx + (point[1] - y0) * dy) / length))
    return math.hypot(x0 + along * dx - point[0], y0 + along * dy - point[1])


def write(name, title, solid, size, start, faces):
    """Writes a level. `faces` holds the lines of each face; lines that would overlap the player at the start are omitted."""
    lines = [f"# title: {title}", "# author: The Platon project", solid,
             f"0 {number(start[0])} {number(start[1])} 0", f"{FACES[solid] - 1} 0 0", str(size)]
    for face, content in enumerate(faces):
        lines.append("%")
        lines += [" ".join(number(c) for c in line) for line in content
                  if face != 0 or distance(line, start) > ROOM]
    path = pathlib.Path(__file__).parent / "levels" / f"{name}.level"
    path.write_text("\n".join(lines) + "\n")


def offset(source, most):
    return source.randint(-most, most) * SUBUNIT


def random_point(source, reach):
    """A random point of the disc of radius `reach`."""
    radius, angle = reach * math.sqrt(source.random()), source.uniform(0, 2 * math.pi)
    return radius * math.cos(angle), radius * math.sin(angle)


def joints(source, solid="HEXAHEDRON", size=480):
    """Floors across every edge, at three slopes, in pieces whose ends are up to two subunits apart."""
    faces = []
    for face in range(FACES[solid]):
        lines = []
        for level, slope in ((-200, 0), (-90, 0.01 * (face - 2)), (40, 0.2)):
            xs = [-240 + 20 * i for i in range(25)]
            for left, right in zip(xs, xs[1:]):
                lines.append((left + offset(source, 2), level + slope * left + offset(source, 2),
                              right + offset(source, 2), level + slope * right + offset(source, 2)))
        faces.append(lines)
    write("joints", "Loose joints", solid, size, (0, -180), faces)


def wedges(source, solid="OCTAHEDRON", size=600):
    """Wedges of two lines with angles from 0.1 to 10 degrees, in every direction."""
    reach = inner_radius(solid, size) * 0.9
    faces = []
    for _ in range(FACES[solid]):
        lines = [(-size / 2, -150, size / 2, -150)]
        for _ in range(9):
            tip = source.uniform(0, reach), source.uniform(0, 2 * math.pi)
            x, y = tip[0] * math.cos(tip[1]), tip[0] * math.sin(tip[1])
            angle = source.uniform(0, 2 * math.pi)
            opening = math.radians(source.choice((0.1, 0.5, 2, 10)))
            for side in (angle - opening / 2, angle + opening / 2):
                lines.append((x, y, x + 60 * math.cos(side), y + 60 * math.sin(side)))
        faces.append(lines)
    write("wedges", "Wedges", solid, size, (0, -120), faces)


def points(source, solid="DODECAHEDRON", size=300):
    """Single points and lines of a few subunits."""
    reach = inner_radius(solid, size) * 0.95
    faces = []
    for _ in range(FACES[solid]):
        lines = [(-size / 2, -120, size / 2, -120)]
        for _ in range(40):
            x, y = random_point(source, reach)
            lines.append((x, y, x + (1 + source.randrange(3)) * SUBUNIT, y + offset(source, 3)))
        lines.append((0, 0, 0, 0))
        faces.append(lines)
    write("points", "Points", solid, size, (0, -90), faces)


def crowd(source, solid="ICOSAHEDRON", size=500):
    """Lines of any length and direction, many of them across edges."""
    reach = inner_radius(solid, size)
    faces = []
    for _ in range(FACES[solid]):
        lines = []
        for _ in range(18):
            x, y = random_point(source, reach)
            length, direction = source.uniform(1, 160), source.uniform(0, 2 * math.pi)
            lines.append((x, y, x + length * math.cos(direction), y + length * math.sin(direction)))
        faces.append(lines)
    write("crowd", "Crowd", solid, size, (0, 0), faces)


def corners(source, solid="TETRAHEDRON", size=200):
    """The smallest face, on which a player has two instances on one face at a corner; lines point into the corners."""
    outer = size / math.sqrt(3)
    faces = []
    for _ in range(FACES[solid]):
        lines = []
        for corner in range(3):
            angle = math.radians(210 + 120 * corner)
            x, y = outer * math.cos(angle), outer * math.sin(angle)
            for near in (0.55, 0.8):
                bend = source.uniform(-0.2, 0.2)
                far = near + 0.12
                lines.append((x * near, y * near, x * far - y * bend * 0.1, y * far + x * bend * 0.1))
        faces.append(lines)
    write("corners", "Corners", solid, size, (0, 0), faces)


def far(source, solid="HEXAHEDRON", size=65536):
    """The largest face: coordinates of 2^25 subunits, long lines with minimal slopes, the start near an edge."""
    half = size / 2
    faces = []
    for _ in range(FACES[solid]):
        lines = [(-half, -half + 100 + 60 * i + offset(source, 400), half, -half + 100 + 60 * i + offset(source, 400))
                 for i in range(6)]
        lines += [(half - 60 - 50 * i, -half + 600, half - 60 - 50 * i + offset(source, 9), half) for i in range(6)]
        faces.append(lines)
    write("far", "Far out", solid, size, (half - 100, -half + 130), faces)


def main():
    source = random.Random(20)
    for level in (joints, wedges, points, crowd, corners, far):
        level(source)


if __name__ == "__main__":
    main()
