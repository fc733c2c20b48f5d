#pragma once

#include <cstdint>
#include <vector>

#include "client/audio/cue.h"
#include "client/audio/replay_filter.h"
#include "client/scene/solid_mesh.h"
#include "platon/game/game.h"

namespace platon {

/// The cues of keys, doors and plates, which are states of the whole round.
class ElementCues {
 public:
  static constexpr std::uint32_t kEventTicks = 30;  ///< within which a change is the same one, predicted anew

  /// The cues of what has changed since the last call, as a player at `listener` hears it; none at the first call, and
  /// unless `ticks` exceeds that of all earlier calls. Elements of one number sound once, from the nearest of them.
  std::vector<Cue> observe(const Game& game, std::uint32_t ticks, const SolidMesh& mesh, const Pose& listener);

 private:
  std::vector<std::uint8_t> before_;  // by Level::elements: taken, open or pressed
  std::uint32_t newest_ = 0;
  ReplayFilter filter_;
};

}  // namespace platon
