#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "platon/game/game.h"
#include "platon/game/recorder.h"
#include "platon/game/recording_format.h"
#include "platon/game/state_bytes.h"
#include "shared/exact/hash.h"

namespace platon {

/// The recording as a program with the rules of one version earlier would have written its head.
inline std::vector<std::uint8_t> asOfOlderRules(std::vector<std::uint8_t> recording, const Level& level) {
  const std::size_t head = kRecordingMagic.size() + 12 + level.text.size();
  StateWriter rules;
  rules.add(kRulesVersion - 1);
  for (std::size_t i = 0; i < 4; ++i) recording[kRecordingMagic.size() + i] = rules.bytes()[i];
  StateWriter checksum;
  checksum.add(hashOf(std::span(recording).first(head)));
  for (std::size_t i = 0; i < 8; ++i) recording[head + i] = checksum.bytes()[i];
  return recording;
}

}  // namespace platon
