#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "client/scene/scene.h"
#include "client/ui/controls/key_names.h"
#include "client/ui/medal.h"
#include "client/ui/overlay.h"
#include "client/ui/run_timer.h"

namespace platon {

/// What is shown of a round that has ended, besides the players.
struct RoundSummary {
  std::string nextTitle{};              ///< of the next level
  double secondsLeft = 0;               ///< until the next round starts
  std::optional<double> bestSeconds{};  ///< best time of the level; nothing: nobody has reached its goal
  std::string bestName{};               ///< of the player who reached it in this time
  bool bestIsNew = false;               ///< in this round
  bool waits = false;                   ///< the next round starts when the player asks for it
};

/// Whether the local player, or its team, is at the goal of a round that waits for it.
bool showsOwnResult(const Scene& scene, const RoundSummary& summary);
/// What this player has reached, each a line; empty lines are left out.
struct OwnResult {
  std::string headline;
  std::string stars;    ///< of the medal; empty: none
  glm::vec4 colour{1};  ///< of the stars
  std::string time;
  std::string medal;  ///< its name, and what is next
};
/// `medals`: of the level; nothing: it has none. `scene` has a time of arrival (arrivalTicksOf).
OwnResult ownResultOf(const Scene& scene, const RunStatus& run, const std::optional<MedalTimes>& medals);
/// Adds it on a panel whose upper edge has this middle.
void addOwnResult(OverlayWriter& writer, const OwnResult& result, glm::vec2 top);
/// The keys with which it goes on.
std::string ownKeysOf(const RoundSummary& summary, const KeyHints& keys, const Font& font);

/// Adds the results of a round with others, at the right: names and times in order, whether the own time is not kept,
/// the best time of the level, and what comes next when. At most `maxRows` players are listed; the others are counted.
void addResults(OverlayWriter& writer, const Scene& scene, const RoundSummary& summary, const RunStatus& run,
                const Font& font, float width, std::size_t maxRows);

}  // namespace platon
