#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "levels/solve/solution.h"
#include "platon/game/level.h"

namespace platon {

/// A way to the goal as a recording holds it. Whether it leads to the goal is for factsOf to say.
struct RecordedWay {
  std::shared_ptr<const Level> level;  ///< as it was when the way was recorded; null with a fault
  Solution inputs;
  std::string fault;  ///< why the recording cannot be used; empty: it is complete
};

RecordedWay readRecordedWay(std::span<const std::uint8_t> recording);

/// The recording of a way that starts with the round.
std::vector<std::uint8_t> recordWay(const std::shared_ptr<const Level>& level, const Solution& inputs);

}  // namespace platon
