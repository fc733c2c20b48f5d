"""Faults in the tools for levels."""

from fault import at_length

REACH = "levels/reach/reach.cpp"

LEVEL_FAULTS = [
    at_length("slide-as-slow-as-a-run", REACH,
              "kind.steep ? envelope.slideSpeed() : envelope.runSpeed();", "envelope.runSpeed();",
              "a place that is reached after a slide is called out of reach",
              "ReachTest.ASlideDownASteepSegmentLeadsOverAWiderGap"),
    at_length("slide-begins-as-a-run", REACH,
              " && cell.steep == grid[run.back() / 2].steep;", ";",
              "a slide to the left of which a player may stand is as slow as a run",
              "ReachTest.ASlideDownASteepSegmentLeadsOverAWiderGap"),
    at_length("untouched-keys-open-doors", REACH,
              "(element.kind == ElementKind::kKey || element.kind == ElementKind::kPlate) && isUsed(element);",
              "(element.kind == ElementKind::kKey || element.kind == ElementKind::kPlate);",
              "it is not proved that a level needs its key",
              "ReachTest.WhatIsNotTouchedOpensNothing"),
    at_length("heights-touch-what-is-left-out", "levels/reach/jump_heights.cpp",
              "[&](ElementWord word) { return word.isOf(element); })) return;",
              "[&](ElementWord) { return false; })) return;",
              "it is not proved that a level needs its key, with any number of crossings",
              "JumpHeightsTest.WhatIsNotTouchedOpensNothing"),
    at_length("needs-of-any-number", "shared/include/platon/game/element.h",
              "return element.kind == kind && element.number == number;", "return element.kind == kind;",
              "a level is proved to need key 1 with the doors of key 2 shut",
              "ElementTest.AWordIsOfElementsOfItsKindAndNumber"),
    at_length("searches-touch-what-is-left-out", "levels/solve/way_search.cpp",
              "if (!keepsOff()) return false;", "",
              "a way with the key is shown as one without it",
              "WaySearchTest.KeepsOffWhatItIsToGoWithout"),
    at_length("shut-doors-are-fine", "levels/check/level_warnings.cpp",
              "  warnOfShutDoors(*level, diagnostics);\n", "",
              "a door that nothing opens is called fine",
              "LevelWarningsTest.ADoorThatNothingOpensIsNamed"),
]  # fmt: skip
