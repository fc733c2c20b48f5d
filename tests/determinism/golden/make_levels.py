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


def word_of(line):
    return line[4] if len(line) > 4 else ""


def can_block(line):
    return word_of(line).split(" ")[0] not in ("checkpoint", "key")


def middle(line):
    return (line[0] + line[2]) / 2, (line[1] + line[3]) / 2


def is_in_the_way(line, face, start, content):
    """Whether a line overlaps the player at the start or at a checkpoint of its face."""
    places = [middle(other) for other in content if word_of(other) == "checkpoint"] + ([start] if face == 0 else [])
    return can_block(line) and any(distance(line[:4], place) <= ROOM for place in places)


def write(name, title, solid, size, start, faces):
    """Writes a level. `faces` holds the lines of each face: x0, y0, x1, y1 and, of an element, its words. Lines that would
    overlap the player at the start or at a checkpoint are omitted."""
    lines = [f"# title: {title}", "# author: The Platon project", solid,
             f"0 {number(start[0])} {number(start[1])} 0", f"{FACES[solid] - 1} 0 0", str(size)]
    for face, content in enumerate(faces):
        lines.append("%")
        lines += [" ".join([*(number(c) for c in line[:4]), *line[4:]]) for line in content
                  if not is_in_the_way(line, face, start, content)]
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


def any_word(source, solid):
    """The words of an element that can block."""
    return source.choice(("oneway", "oneway", f"up {source.randrange(SIDES[solid])}", "hazard",
                          f"door {source.randrange(3)}", f"plate {source.randrange(3)}",
                          f"timed {source.randrange(1, 90)} {source.randrange(1, 90)}"))


def touched_elements(source, reach):
    """Checkpoints and keys, which never block, at random places."""
    lines = []
    for word in ("checkpoint", f"key {source.randrange(3)}"):
        x, y = random_point(source, reach)
        direction = source.uniform(0, 2 * math.pi)
        lines.append((x, y, x + 60 * math.cos(direction), y + 60 * math.sin(direction), word))
    return lines


def elements(source, solid="HEXAHEDRON", size=480):
    """Floors across every edge with plates, one-way segments, doors and hazards in them, loose at their joints."""
    faces = []
    for face in range(FACES[solid]):
        lines = touched_elements(source, 100)
        for x in range(-240, 240, 40):
            word = source.choice(("", "", "", f"plate {source.randrange(3)}", "oneway", "up 2"))
            if source.random() < 0.75:
                lines.append((x, -200 + offset(source, 1), x + 40, -200 + offset(source, 1), *([word] if word else [])))
            lines.append((x, -110 + offset(source, 1), x + 40, -110 + offset(source, 1), "oneway"))
            lines.append((x, 0, x + 40, 0.3 * (face - 2), any_word(source, solid)))
            if source.random() < 0.2:
                lines.append((x + 20, -200, x + 20 + source.uniform(-9, 9), -150, any_word(source, solid)))
        lines.append((-240, 120, 240, 120, f"up {face % 4}"))
        faces.append(lines)
    write("elements", "Elements over edges", solid, size, (0, -180), faces)


def words(source, solid="ICOSAHEDRON", size=500):
    """Elements of every kind in any direction, many of them across edges, among other lines."""
    reach = inner_radius(solid, size)
    faces = []
    for _ in range(FACES[solid]):
        lines = touched_elements(source, reach * 0.8)
        for i in range(12):
            x, y = random_point(source, reach)
            length, direction = source.uniform(1, 120), source.uniform(0, 2 * math.pi)
            line = (x, y, x + length * math.cos(direction), y + length * math.sin(direction))
            lines.append(line if i < 3 else (*line, any_word(source, solid)))
        faces.append(lines)
    write("words", "Every word", solid, size, (0, 0), faces)


def main():
    source = random.Random(20)
    for level in (joints, wedges, points, crowd, corners, far, elements, words):
        level(source)


if __name__ == "__main__":
    main()
