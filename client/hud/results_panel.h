#pragma once

#include <optional>
#include <string>

#include "client/scene/scene.h"
#include "client/ui/overlay_writer.h"

namespace platon {

/// What is shown of a round that has ended, besides the players.
struct RoundSummary {
  std::string nextTitle{};              ///< of the next level
  double secondsLeft = 0;               ///< until the next round starts
  std::optional<double> bestSeconds{};  ///< best time of the level; nothing: nobody has reached its goal
  std::string bestName{};               ///< of the player who reached it in this time
  bool bestIsNew = false;               ///< in this round
};

/// Adds the results of a round: names and times in order, the best time of the level, and what comes next when.
void addResults(OverlayWriter& writer, const Scene& scene, const RoundSummary& summary, const Font& font, float width);

}  // namespace platon
