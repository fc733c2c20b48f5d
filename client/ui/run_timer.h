#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "client/scene/scene.h"
#include "client/ui/medal.h"
#include "client/ui/overlay.h"

namespace platon {

/// How the local player's attempt compares with its best run on this level.
struct RunStatus {
  std::optional<double> best{};        ///< seconds of the best run; nothing: there is none
  std::optional<double> difference{};  ///< seconds to the best run so far, negative: faster; nothing: not to be shown
  bool isNewBest = false;              ///< this attempt has reached the goal as the best run
  std::string notRecorded{};  ///< why it is not, though it would be the best run; empty: it would not, or it is
  double speed = 1;           ///< the least of the attempt; less than 1: its time is not kept
};

/// A difference of times with its sign: `+0.32`, `−1.05`, `±0.00`.
std::string differenceText(double seconds);

/// What is told of a time that was reached at less than full speed: `at 50 % speed, not kept`.
std::string slowedText(double speed);

/// The time of the local player's attempt, or of its team, in ticks once it has reached the goal; nothing before.
std::optional<std::uint32_t> arrivalTicksOf(const Scene& scene);

/// What this time is worth; empty before the goal, and on a level without medals.
std::string ownMedalText(const Scene& scene, const std::optional<MedalTimes>& times);

/// The time of the local player's attempt, beside it the difference, and below it the best time. In a round without a
/// time limit it is the only clock. `place`: left end and middle of the first row. Nothing without a local player.
void addRunTimer(OverlayWriter& writer, const Scene& scene, const RunStatus& run, glm::vec2 place);

}  // namespace platon
