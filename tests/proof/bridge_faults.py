"""Deliberate faults in the sweep and the obstacle, each of which must give an answer that differs from the proved one."""

import shutil
import subprocess
from itertools import zip_longest

SWEEP, OBSTACLE = "shared/physics/sweep.cpp", "shared/physics/obstacle.cpp"
SWEEP_H, OBSTACLE_H = "shared/include/platon/physics/sweep.h", "shared/include/platon/physics/obstacle.h"
SOURCES = ("tests/proof/sweep_queries.cpp", SWEEP, OBSTACLE, "shared/physics/convex.cpp", "shared/exact/angle.cpp")

# (file, what is replaced, by what, what goes wrong)
FAULTS = [
    (SWEEP, "time <= interval.enter) return;", "time < interval.enter) return;", "of planes entered at once the last one counts"),
    (SWEEP, "interval.enter >= interval.exit;", "interval.enter > interval.exit;", "touching a corner is a hit"),
    (SWEEP, "if (interval.endsInside || time < interval.exit) interval.exit = time;", "interval.exit = time;", "the last exit counts"),
    (SWEEP, "    interval.endsInside = false;\n", "", "a path that leaves ends inside"),
    (SWEEP, "return makeHit(interval, normal, Obstacle::sideFeature", "return makeHit(interval, left, Obstacle::sideFeature", "both sides have one normal"),
    (SWEEP_H, "if (distances.start >= 0 && distances.end >= 0) return false;", "if (distances.start > 0 && distances.end >= 0) return false;", "sliding along is a hit"),
    (SWEEP_H, "start -= std::int64_t{half.oneNorm()} * margin_;", "start -= margin_;", "the margin does not grow with the normal"),
    (OBSTACLE_H, "std::max(dot(edge.normal, segment.a), dot(edge.normal, segment.b))", "dot(edge.normal, segment.a)", "only one end of the segment counts"),
    (OBSTACLE, "half.normal.x > 0 ?", "half.normal.x < 0 ?", "relevant half planes are missed"),
    (OBSTACLE, "    highest = std::max(highest, height);", "    highest = std::max(highest, lowest);", "the far side of the shape is lost"),
]  # fmt: skip


def program_with(root, work, fault):
    """Builds platon-sweep-queries with one of FAULTS. Returns its path."""
    tree = work / "faulty"
    shutil.rmtree(tree, ignore_errors=True)
    for folder in ("shared/physics", "shared/exact", "shared/include", "tests/proof", "tests/sim", "tests/shared/physics"):
        shutil.copytree(root / folder, tree / folder)
    file, original, replaced, _ = fault
    text = (tree / file).read_text(encoding="utf-8")
    if text.count(original) != 1:
        raise ValueError(f"{file}: '{original}' occurs {text.count(original)} times, not once")
    (tree / file).write_text(text.replace(original, replaced), encoding="utf-8")
    subprocess.run(["g++", "-std=c++20", "-O1", "-w", "-I.", "-Ishared/include", *SOURCES, "-o", "faulty"], cwd=tree, check=True)
    return tree / "faulty"


def differs(program, work, count, seed):
    """The number of the first answer that is not the proved one; none if all are. A route that answers otherwise is one, too."""
    refused = subprocess.run([program, str(count), str(seed), "faulty_queries", "faulty_answers"], cwd=work, stderr=subprocess.PIPE, check=False).returncode
    with (work / "faulty_answers").open() as answers, (work / "proved").open() as proved:
        for number, (answer, right) in enumerate(zip_longest(answers, proved), 1):
            if answer != right:
                return number
    return count if refused else None


def survivors(root, work, count, seed):
    """What goes wrong with the faults that give no other answer."""
    return [fault[3] for fault in FAULTS if differs(program_with(root, work, fault), work, count, seed) is None]
