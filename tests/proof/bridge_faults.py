"""Deliberate faults in what is proved, each of which must give an answer that differs from the proved one."""

import sys
from pathlib import Path

sys.path.append(str(Path(__file__).resolve().parents[1] / "mutation"))

import faults  # noqa: E402
from fault import PHYSICS, PUBLIC_PHYSICS, Fault  # noqa: E402

# Of those that must make a test fail.
SHARED = ("graze-is-a-hit", "touch-is-a-hit", "nearer-end", "passes-the-near")
BRIDGE = "proof"  # what must fail

FAULTS = [
    *(next(fault for fault in faults.FAULTS if fault.name == name) for name in SHARED),
    Fault("last-of-a-tie", PHYSICS + "sweep.cpp", "time <= interval.enter) return;", "time < interval.enter) return;",
          "of half planes entered at once the last one counts", BRIDGE),
    Fault("last-exit", PHYSICS + "sweep.cpp",
          "if (interval.endsInside || time < interval.exit) interval.exit = time;", "interval.exit = time;",
          "the half plane that comes last is the one that is left first", BRIDGE),
    Fault("ends-inside", PHYSICS + "sweep.cpp", "    interval.endsInside = false;\n", "", "a path that leaves ends inside", BRIDGE),
    Fault("one-side", PHYSICS + "sweep.cpp",
          "return makeHit(interval, normal, Obstacle::sideFeature", "return makeHit(interval, left, Obstacle::sideFeature",
          "both sides have one normal", BRIDGE),
    Fault("margin-as-length", PUBLIC_PHYSICS + "sweep.h", "start -= std::int64_t{half.oneNorm()} * margin_;", "start -= margin_;",
          "the margin does not grow with the normal", BRIDGE),
    Fault("far-side-lost", PHYSICS + "obstacle.cpp",
          "    highest = std::max(highest, height);", "    highest = std::max(highest, lowest);",
          "the far side of the shape is lost", BRIDGE),
    Fault("last-feature", PHYSICS + "obstacle.cpp", "    if (height < lowest) feature = vertex;", "    if (height <= lowest) feature = vertex;",
          "of two vertices on a side the last one touches it", BRIDGE),
    Fault("kept-plane-misplaced", PHYSICS + "sweep.cpp", "half.offset - dot(half.normal, position_)}", "half.offset}",
          "the half plane that is kept stays relative to the position", BRIDGE),
    Fault("kept-plane-of-the-start", PUBLIC_PHYSICS + "sweep.h", "return distances.start >= 0 && distances.end >= 0;",
          "return distances.start >= 0;", "a half plane excludes a path that leads into it", BRIDGE),
    Fault("kept-plane-of-another-shape", PHYSICS + "region.h", "if (shape_ == &shape && sweep.isExcluded", "if (sweep.isExcluded",
          "the half plane that is kept belongs to another shape", BRIDGE),
    Fault("box-without-margin", PUBLIC_PHYSICS + "sweep.h", "const Point grown(margin, margin);", "const Point grown(0, 0);",
          "the box of a sweep does not grow by the margin", BRIDGE),
    Fault("winds-twice", PHYSICS + "convex.cpp", "if (!windsOnce(vertices))", "if (vertices.empty())",
          "a shape may wind around more than once", BRIDGE),
    Fault("place-turned-back", PHYSICS + "instances.h", "moved : rotate(moved, fromHome));", "moved : rotate(moved, toHome));",
          "an instance moves as the home instance would from its own frame", BRIDGE),
]  # fmt: skip
