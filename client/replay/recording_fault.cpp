#include "client/replay/recording_fault.h"

#include <optional>

#include "client/replay/recording_head.h"
#include "platon/game/game.h"

namespace platon {

std::string damagedText(const std::string& fault) { return "is a damaged recording: " + fault; }

std::string recordingFault(const RecordingReader& reader, std::span<const std::uint8_t> recording) {
  if (reader.state() == RecordingReader::State::kComplete) return {};
  const std::optional<RecordingHead> head = readRecordingHead(recording);
  if (head && head->rules != kRulesVersion) return otherRulesText(head->rules);
  if (reader.state() == RecordingReader::State::kTruncated) return "is a recording that is cut off: " + reader.fault();
  return head ? damagedText(reader.fault()) : "cannot be played: " + reader.fault();
}

}  // namespace platon
