#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include <glm/vec3.hpp>

#include "client/audio/sounds.h"
#include "client/scene/solid_mesh.h"
#include "platon/game/game.h"

namespace platon {

/// How a sound from a place is heard.
struct Heard {
  double gain = 1;  ///< 0 … 1
  double pan = 0;   ///< −1 left … 1 right
};

/// Distance at which a sound has half its gain, level units.
inline constexpr double kHalfGainDistance = 260;
/// Distance to the side from which on a sound comes from that side alone, level units.
inline constexpr double kFullPanDistance = 700;

/// How a player at `listener` hears a sound from `place`: by the distance through the solid, with the player's right on
/// the right. The gain is 1 at the distance 0, and falls with the square of the distance.
Heard hear(const Pose& listener, glm::dvec3 place);

/// Lets a cue pass once when reconciliation shows its event again. An event that is predicted anew comes a few ticks
/// earlier or later than before, so a repetition within a short time is taken for the same event.
class RepeatFilter {
 public:
  /// Whether the event `key` of tick `tick` is a new one: none with this key has passed in the `ticks` ticks before.
  bool passes(std::uint32_t key, std::uint32_t tick, std::uint32_t ticks) {
    const auto [found, isFirst] = last_.try_emplace(key, tick);
    if (!isFirst && tick < found->second + ticks) return false;
    found->second = tick;
    return true;
  }

 private:
  std::map<std::uint32_t, std::uint32_t> last_;  // tick of the last event that has passed, by key
};

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
  RepeatFilter filter_;
};

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
  RepeatFilter filter_;
};

/// What SoundCues listens to: one frame of a round. The pointers must be set.
struct CueSource {
  std::uint32_t round = 0;  ///< id of the round
  const SolidMesh* mesh = nullptr;
  const Game* predicted = nullptr;  ///< of the local players and the elements
  std::uint32_t predictedTicks = 0;
  const Game* confirmed = nullptr;  ///< of the other players
  std::uint32_t confirmedTicks = 0;
  double othersTick = 0;                     ///< at which the other players are drawn
  std::uint32_t localSlot = 0;               ///< of the first local player, who listens
  std::vector<std::uint32_t> companions{};   ///< slots of the other local players
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
