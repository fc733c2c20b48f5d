#include "client/replay/recording_head.h"

#include <algorithm>

#include "platon/game/game.h"
#include "platon/game/recording_format.h"
#include "platon/game/recording_reader.h"
#include "platon/game/state_bytes.h"

namespace platon {

std::optional<RecordingHead> readRecordingHead(std::span<const std::uint8_t> bytes) {
  const RecordingReader recording(bytes);
  if (recording.level()) return RecordingHead{kRulesVersion, recording.level()};
  StateReader reader(bytes.subspan(std::min(bytes.size(), kRecordingMagic.size())));
  std::uint32_t rules = 0;
  std::uint32_t textBytes = 0;
  std::uint32_t complement = 0;
  reader.read(rules);
  reader.read(textBytes);
  reader.read(complement);
  // Of a head with the right checksum, the reader complains about the rules.
  const std::string complaint = "recorded with version " + std::to_string(rules) + " of the rules";
  if (recording.fault().find(complaint) == std::string::npos) return std::nullopt;
  const std::span<const std::uint8_t> text = reader.take(textBytes);
  return RecordingHead{rules, loadLevel(std::string(text.begin(), text.end())).level};
}

std::string otherRulesText(std::uint32_t rules) {
  return "was recorded by version " + std::to_string(rules) + " of the rules; this program has version " +
         std::to_string(kRulesVersion) + " and cannot play it, so it is kept as it is";
}

}  // namespace platon
