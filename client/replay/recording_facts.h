#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>

#include "platon/game/level.h"

namespace platon {

/// What a list tells of a recording.
struct RecordingFacts {
  std::uint32_t rules = 0;               ///< version of the rules it was made by; 0: unknown
  std::shared_ptr<const Level> level{};  ///< null if it cannot be read
  std::optional<std::uint32_t> ticks{};  ///< the time of the run; nothing: it is none, or it cannot be played
  std::string note{};                    ///< why it cannot be played, as the end of a sentence; empty: as far as known,
                                         ///< it can
  std::string noRun{};                   ///< why it shows no run, likewise; empty: it does, or cannot be played
};

/// Reads all blocks of a recording, but plays only the last one with ticks: that gives the time of a run. So a
/// recording may still be refused when it is played whole. Ends early with the present MiB, block or tick when it is
/// asked to stop; then the facts are not to be used.
RecordingFacts readRecordingFacts(const std::filesystem::path& file, const std::stop_token& stop = {});

}  // namespace platon
