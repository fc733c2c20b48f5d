"""Faults in writing and reading recordings."""

from fault import Fault, at_length

GAME = "shared/game/"

RECORDING_FAULTS = [
    Fault("checksum-not-compared", GAME + "recording_reader.cpp",
          "if (hash != hashOf(body)) return", "if (false) return",
          "a damaged block is replayed",
          "RecordingReaderTest.FindsEveryFlippedBit"),
    at_length("end-not-marked", GAME + "recorder.cpp",
              "  if (!hashes_.empty()) addBlock(game);\n  addBlock(game);", "  if (!hashes_.empty()) addBlock(game);",
              "a complete recording looks like a truncated one",
              "RecorderTest.ARecordingContainsTheGameAsPlayed"),
    at_length("slots-of-the-first-tick", GAME + "recorder.cpp",
              "slots = std::max(slots, inputs.size());", "if (slots == 0) slots = inputs.size();",
              "a player who joins within a block is not recorded before the next block",
              "RecorderTest.ABlockHasTheSlotsOfPlayersWhoJoinInIt"),
    at_length("runs-beyond-the-block", GAME + "recording_reader.cpp",
              "length == 0 || length > block.ticks() - tick ||", "length == 0 || length > kMaxCheckpointTicks ||",
              "a forged run of inputs is written past the end of the block",
              "RecordingReaderTest.RefusesInvalidRuns"),
    at_length("blocks-in-any-order", GAME + "recording_reader.cpp",
              "if (expectedTick_ && block.firstTick != *expectedTick_)",
              "if (expectedTick_ && block.firstTick < *expectedTick_)",
              "a block may be missing",
              "RecordingReaderTest.RefusesBlocksOutOfOrder"),
]
