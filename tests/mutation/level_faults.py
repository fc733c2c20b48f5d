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
]  # fmt: skip
