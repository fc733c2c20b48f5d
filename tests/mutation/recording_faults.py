"""Faults in how games are recorded and read again."""

from fault import Fault, at_length

GAME = "shared/game/"

RECORDING_FAULTS = [
    Fault("check-sum-not-read", GAME + "recording_reader.cpp",
          "if (hash != hashOf(body)) return", "if (false) return",
          "a damaged block is played",
          "RecordingTest.AnyFlippedBitIsFound"),
    at_length("end-not-marked", GAME + "recorder.cpp",
              "  if (!hashes_.empty()) addBlock(game);\n  addBlock(game);", "  if (!hashes_.empty()) addBlock(game);",
              "a whole recording cannot be told from one that was cut off",
              "RecordingTest.HoldsWhatWasPlayed"),
    at_length("slots-of-the-first-tick", GAME + "recorder.cpp",
              "slots = std::max(slots, inputs.size());", "if (slots == 0) slots = inputs.size();",
              "who joins inside a block is not recorded before the next",
              "RecordingTest.SlotsMayBecomeMoreInsideABlock"),
    at_length("runs-beyond-the-block", GAME + "recording_reader.cpp",
              "length == 0 || length > block.ticks() - tick ||", "length == 0 || length > kMaxCheckpointTicks ||",
              "a forged run of inputs is written behind the block",
              "RecordingTest.RefusesRunsThatAreNone"),
    at_length("blocks-in-any-order", GAME + "recording_reader.cpp",
              "if (expected_ && block.first != *expected_)", "if (expected_ && block.first < *expected_)",
              "a block may be missing",
              "RecordingTest.RefusesBlocksOutOfOrder"),
]
