#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "client/audio/element_cues.h"
#include "client/audio/player_cues.h"
#include "client/audio/sound_frame.h"
#include "client/scene/solid_mesh.h"
#include "platon/game/game.h"

namespace platon {

/// What SoundCues listens to: one frame of a round. The pointers must be set.
struct CueSource {
  std::uint32_t round = 0;  ///< id of the round
  const SolidMesh* mesh = nullptr;
  const Game* predicted = nullptr;  ///< of the local player and the elements
  std::uint32_t predictedTicks = 0;
  const Game* confirmed = nullptr;  ///< of the other players
  std::uint32_t confirmedTicks = 0;
  double othersTick = 0;  ///< at which the other players are drawn
  std::uint32_t localSlot = 0;
  bool over = false;                         ///< the round has ended
  bool timed = true;                         ///< the round has a time limit
  std::optional<double> nextRoundSeconds{};  ///< until the next round starts, if that is known
};

/// Decides what is heard of a game, from successive frames. It only reads states; what is heard decides nothing.
class SoundCues {
 public:
  static constexpr double kOthersGain = 0.5;  ///< of other players' sounds, at no distance
  static constexpr double kMinGain = 0.04;    ///< what is softer is left out
  static constexpr int kRoundCountdown = 5;   ///< last seconds of a round that are counted
  static constexpr int kNextCountdown = 3;    ///< last seconds before the next round, likewise

  /// `source`: null while there is no round.
  SoundFrame update(const CueSource* source);

 private:
  // A cue of another player, until that player is drawn at its tick.
  struct Pending {
    double tick;
    Cue cue;
    glm::dvec3 place;
  };

  void startRound(const CueSource& source, SoundFrame& frame);
  void hearLocal(const CueSource& source, SoundFrame& frame);
  void observeOthers(const CueSource& source);
  void hearOthers(const CueSource& source, const Pose& listener, SoundFrame& frame);
  void countDown(const CueSource& source, SoundFrame& frame);

  std::optional<std::uint32_t> round_;
  std::vector<PlayerCues> players_;  // by slot
  ElementCues elements_;
  std::vector<Pending> pending_;
  int secondsLeft_ = 0;   // at the last frame, rounded up
  bool counted_ = false;  // the start of the next round has been counted down
};

}  // namespace platon
