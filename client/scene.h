#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "client/palette.h"
#include "client/pose.h"
#include "client/stage.h"
#include "shared/exact/point.h"
#include "shared/game/game.h"
#include "shared/physics/entity_state.h"

namespace platon {

/// A game between two ticks. The players are drawn `fraction` of the way from where they stood at the tick before to
/// where they stand.
struct GameInTime {
  const Game* game = nullptr;
  std::span<const EntityState> before;  ///< by slot; a slot beyond its end is drawn where it stands
  double fraction = 1;                  ///< 0 … 1
};

/// All that a scene is made of. `others.game` and `stage` are set.
struct SceneSource {
  std::shared_ptr<const Stage> stage;  ///< of the games' level
  GameInTime others;                   ///< the confirmed game
  GameInTime own;                      ///< the predicted game; without one the own player is as confirmed, too
  std::optional<std::uint32_t> ownSlot;
  Point ownOffset;                     ///< added to the own player's place: subunits, in its own frame (+y its up)
  std::span<const std::string> names;  ///< by slot, UTF-8
};

/// One player as it is drawn: once, however many instances it has.
struct PlayerDrawing {
  std::uint32_t slot = 0;
  Pose pose;
  Colour colour{1};
  std::string number;  ///< slot + 1
  std::string name;
  bool own = false;
  std::optional<double> finishedAfter;  ///< seconds from the start of the round
};

/// One moment of the game as it is drawn. The only place where the exact game becomes floating point.
struct Scene {
  std::shared_ptr<const Stage> stage;
  std::vector<PlayerDrawing> players;  ///< by slot, the own last
  Pose focus;                          ///< what the camera follows: the own player, else the first, else the start
  double seconds = 0;                  ///< since the start of the round
  double secondsLeft = 0;
  bool over = false;
};

Scene makeScene(const SceneSource& source);

}  // namespace platon
