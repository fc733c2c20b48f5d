#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "platon/game/level.h"

namespace platon {

/// What stands at the beginning of a recording, also of one by older rules.
struct RecordingHead {
  std::uint32_t rules = 0;             ///< version of the rules that it was recorded with
  std::shared_ptr<const Level> level;  ///< null if its text is not valid for this program
};

/// Reads the head from the first bytes of a recording; the rest is not looked at. Returns nothing if it is damaged or
/// cut off, or not that of a recording.
std::optional<RecordingHead> readRecordingHead(std::span<const std::uint8_t> bytes);

/// Says of a recording of other rules why it is not played, as the end of a sentence that begins with its name.
std::string otherRulesText(std::uint32_t rules);

}  // namespace platon
