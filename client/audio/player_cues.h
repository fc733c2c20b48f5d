#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "client/audio/cue.h"
#include "client/audio/replay_filter.h"
#include "client/scene/solid_mesh.h"
#include "platon/game/game.h"

namespace platon {

/// A player after a tick.
struct ObservedPlayer {
  std::uint32_t ticks = 0;  ///< since the start of the round
  PlayerState state;
  EntityState entity;
  Pose pose;  ///< of `entity`
};

/// The cues of one player, from its states as they are observed, not necessarily at every tick. They are full: neither
/// their gain nor their pan knows a listener.
class PlayerCues {
 public:
  /// Within so many ticks, a jump, a landing or a crossing is the same one, predicted anew; likewise all other events.
  static constexpr std::uint32_t kMotionTicks = 10;
  static constexpr std::uint32_t kEventTicks = 30;
  static constexpr std::int32_t kSoftLanding = 1200;  ///< speed below which a landing is silent, subunits a tick

  /// The cues of what has happened since the last call; none at the first call, and unless `ticks` exceeds that of all
  /// earlier calls: replaying ticks repeats no cue.
  std::vector<Cue> observe(const ObservedPlayer& now);

  /// Pitch of the cue for a crossing from `before` to `now`: 1 if the player's up is parallel to the edge, so that its
  /// direction in space stays; higher the more the player has moved upwards over the edge, lower for downwards. Both
  /// are steps of the pentatonic scale.
  static double crossingPitch(const Pose& before, const Pose& now);

 private:
  void addMotion(const ObservedPlayer& now, std::vector<Cue>& cues);
  void addCrossing(const ObservedPlayer& now, std::vector<Cue>& cues);
  void addEvents(const ObservedPlayer& now, std::vector<Cue>& cues);
  bool isNew(Sound sound, std::uint32_t ticks);

  std::optional<ObservedPlayer> before_;
  Pose heardPose_;               // after the last crossing that was heard, or the last respawn
  std::uint32_t heardPart_ = 0;  // likewise
  ReplayFilter filter_;
};

}  // namespace platon
