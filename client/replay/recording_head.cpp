#include "client/replay/recording_head.h"

#include "platon/game/game.h"
#include "platon/game/recording_reader.h"

namespace platon {

std::optional<RecordingHead> readRecordingHead(std::span<const std::uint8_t> bytes) {
  const RecordingReader recording(bytes);
  if (recording.level()) return RecordingHead{kRulesVersion, recording.level()};
  if (!recording.rules() || *recording.rules() == kRulesVersion) return std::nullopt;
  const std::span<const std::uint8_t> text = recording.levelText();
  return RecordingHead{*recording.rules(), loadLevel(std::string(text.begin(), text.end())).level};
}

std::string otherRulesText(std::uint32_t rules) {
  return "was recorded by version " + std::to_string(rules) + " of the rules; this program has version " +
         std::to_string(kRulesVersion) + " and cannot play it, so it is kept as it is";
}

}  // namespace platon
