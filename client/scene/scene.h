#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "client/netcode/player_snapshot.h"
#include "client/scene/palette.h"
#include "client/scene/pose.h"
#include "client/scene/stage_model.h"
#include "platon/exact/point.h"
#include "platon/game/game.h"

namespace platon {

/// All that a scene is made of. `stage` and `game` are set.
struct SceneSource {
  std::shared_ptr<const StageModel> stage;  ///< of the game's level
  const Game* game = nullptr;               ///< whose clock it is: the predicted game
  double fraction = 1;                      ///< of the game's last tick that has passed, 0 … 1
  InterpolatedPlayers others;               ///< of the confirmed game; may hold the own player, too
  std::optional<std::uint32_t> ownSlot;
  std::optional<InterpolatedPlayer> own;  ///< of the predicted game; without, the own player is as the others
  Point ownOffset;                        ///< added to the own player's place: subunits, in its own frame (+y its up)
  std::span<const std::string> names;     ///< by slot, UTF-8
  std::span<const double> flashes;        ///< by slot, 0 … 1: how bright what has just happened to the player shows
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
  std::shared_ptr<const StageModel> stage;
  std::vector<PlayerDrawing> players;  ///< by slot, the own last
  Pose focus;                          ///< what the camera follows: the own player, else the first, else the start
  double seconds = 0;                  ///< since the start of the round
  double secondsLeft = 0;
  bool over = false;
};

Scene makeScene(const SceneSource& source);

}  // namespace platon
