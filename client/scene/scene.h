#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "client/netcode/player_snapshot.h"
#include "client/netcode/player_watch.h"
#include "client/scene/element_states.h"
#include "client/scene/palette.h"
#include "client/scene/solid_mesh.h"
#include "client/scene/stage_model.h"
#include "platon/exact/point.h"
#include "platon/game/game.h"

namespace platon {

/// A player of another run, who is not in the game.
struct GhostSource {
  InterpolatedPlayer player;
  std::string name;  ///< UTF-8
  bool own = false;  ///< a run of the local player
};

/// Another local player than the one whose scene it is.
struct CompanionSource {
  std::uint32_t slot = 0;
  InterpolatedPlayer player;  ///< from the predicted game
  Point offset;               ///< as SceneSource::localOffset
};

/// Input of makeScene. `stage` and `game` must be set.
struct SceneSource {
  std::shared_ptr<const StageModel> stage;  ///< of the game's level
  const Game* game = nullptr;               ///< the predicted game, whose clock is shown
  bool roundOver = false;                   ///< the server has ended the round
  bool timed = true;                        ///< the round ends when the clock of the game has run out
  double fraction = 1;                      ///< elapsed part of the last tick of `game`, 0 … 1
  InterpolatedPlayers others;               ///< from the interpolation buffer; may include local players
  std::vector<CompanionSource> companions;
  std::optional<std::uint32_t> localSlot;
  std::optional<InterpolatedPlayer> local;  ///< from the predicted game; if unset, taken from `others`
  Point localOffset;  ///< error smoothing of the local player: subunits, in its own frame (+y is its up)
  std::span<const std::string> names;                        ///< by slot, UTF-8
  std::span<const std::optional<std::uint32_t>> roundTrips;  ///< by slot, milliseconds
  std::span<const double> flashes;  ///< by slot, 0 … 1: brightness of the flash after an event
  AttemptTime attempt;              ///< of the local player
  AttemptTime team;                 ///< of all players of a level for several as one (teamOf)
  bool needsRestart = false;        ///< EndlessFall::needsHint of the local player
  bool longFall = false;            ///< EndlessFall::isLong of the local player
  bool othersCanJoin = false;       ///< so the scene tells how many players are missing
  std::vector<GhostSource> ghosts;
  std::vector<OwnBall> ownBalls;  ///< how the local players want their balls, the first one first
};

/// One player as it is drawn, once even if it has several instances.
struct PlayerDrawing {
  std::uint32_t slot = 0;
  Pose pose;
  Colour colour{1};
  BallPattern pattern = BallPattern::kPlain;
  std::string number;  ///< slot + 1
  std::string name;
  bool local = false;                        ///< the one whose scene it is
  float flash = 0;                           ///< brightness of the flash after an event, 0 … 1
  float opacity = 1;                         ///< below 1: a ghost
  std::optional<std::uint32_t> roundTripMs;  ///< to the server; nothing: not known
  std::string says;                          ///< in a bubble above the ball; empty: nothing
  std::optional<double> finishSeconds;       ///< shortest time of an attempt to the goal in this round
};

/// The local player's attempt to reach the goal.
struct AttemptDrawing {
  double seconds = 0;    ///< since its first input, up to the goal
  bool arrived = false;  ///< the time stands still
};

/// One moment of the game as it is drawn, converted from exact to floating point.
struct Scene {
  std::shared_ptr<const StageModel> stage;
  ElementStates elements;
  std::vector<PlayerDrawing> players;  ///< by slot; the local player is last
  std::vector<PlayerDrawing> ghosts;   ///< of other runs; translucent
  FaceMarks marksBelow;                ///< of the editor, below the segments; null without any
  FaceMarks marksAbove;                ///< of the editor, above the segments; null without any
  Pose focus;              ///< target of the camera: the local player, else the first player, else the start
  double seconds = 0;      ///< since the start of the round
  double secondsLeft = 0;  ///< of the round, if it is timed
  bool timed = true;       ///< the round has a time limit
  std::optional<AttemptDrawing> attempt;  ///< unset without a local player
  bool begun = true;                      ///< the local player's attempt runs, or there is no such player
  bool isTeam = false;                    ///< the level is for several players, who reach its goal together
  std::optional<double> teamSeconds;      ///< of a team: until the first of them was at the goal; unset before
  bool needsRestart = false;              ///< the local player will not land: it must go back to the start
  bool longFall = false;                  ///< the local player falls over edge after edge: it is seen from afar
  std::uint32_t neededPlayers = 0;        ///< how many the level needs; 0: enough are present, or no others can join
  bool over = false;
};

/// The slot of the local player; UINT32_MAX without one.
inline std::uint32_t localSlotOf(const Scene& scene) {
  return !scene.players.empty() && scene.players.back().local ? scene.players.back().slot : UINT32_MAX;
}

Scene makeScene(const SceneSource& source);

/// Pose of a player, which must be present.
Pose poseOf(const SolidMesh& mesh, const PlayerSnapshot& player);

/// Interpolates the pose of a player between two ticks along the surface: linearly within a face, and over an edge
/// linearly in the unfolded faces. Round a vertex, through a third face, the straight line through the solid is
/// projected from the centre onto the surface. Up turns evenly within a face and folds with the faces at an edge. A
/// distance too long for one tick is a jump, such as a restart, and gives the later pose. The player must be present at
/// both ticks.
Pose poseBetween(const SolidMesh& mesh, const InterpolatedPlayer& player);

}  // namespace platon
