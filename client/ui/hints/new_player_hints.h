#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>

#include "client/ui/controls/key_names.h"
#include "client/ui/hints/element_hints.h"
#include "client/ui/settings.h"
#include "platon/exact/angle.h"
#include "platon/game/game.h"
#include "platon/game/player.h"
#include "platon/physics/entity_state.h"

namespace platon {

/// Teaches a new player the first keys and the goal: shows each hint until the player has done it.
class FirstKeys {
 public:
  /// `known`: the player needs none of it.
  explicit FirstKeys(bool known) : step_(known ? Step::kDone : Step::kRun) {}

  /// Notes what the ball does in a tick; `face`: the one that it is on. Who reaches a goal knows all.
  void observe(const PlayerState& player, std::uint32_t face);
  /// What to do next; empty if there is nothing to teach.
  std::string hint(const KeyHints& keys) const;
  bool done() const { return step_ == Step::kDone; }
  /// Whether the player knows how to run and to jump.
  bool hasJumped() const { return step_ > Step::kJump; }
  /// For how long the player has been asked for the present deed.
  std::uint32_t ticks() const { return ticks_; }

 private:
  enum class Step { kRun, kJump, kCross, kGoal, kDone };

  void begin(Step step);

  Step step_;
  std::int64_t way_ = 0;               // subunits moved to the sides in kRun, or risen in the present jump in kJump
  std::uint32_t ticks_ = 0;            // of this step
  std::optional<std::uint32_t> face_;  // where the ball was first
  bool crossed_ = false;               // it has been on another face
};

/// Notices that a player presses against something that does not give way.
class PushedBall {
 public:
  void observe(const PlayerState& player);
  bool stuck() const;

 private:
  std::uint32_t pushed_ = 0;  // ticks
};

/// Notices that a ball comes back to a face on which down is another way than before.
class TurnedDown {
 public:
  /// Notes where the ball is in a tick. An attempt begins without memory.
  void observe(const PlayerState& player, const EntityState& ball);
  /// Whether it has come back so in this attempt.
  bool turned() const { return turned_; }

 private:
  std::map<std::uint32_t, Angle> ups_;  // of the ball when it was last there, by face
  std::optional<std::uint32_t> face_;   // where it was in the last tick
  bool turned_ = false;
};

/// The hints for new players, one at a time, each when it is time for it: how to go on when the ball is stuck, an
/// element that the ball meets, the keys, where down is, how to look round, and the other elements of the level. The
/// settings remember what is known.
class NewPlayerHints {
 public:
  explicit NewPlayerHints(const Settings& settings) : keys_(!settings.firstKeys) {}

  /// Notes what the player in this slot has done in a tick, and what is known now in the settings. `looks`: the player
  /// looks round.
  void observe(const Game& game, std::uint32_t slot, bool looks, Settings& settings);
  /// What to do next; empty if there is nothing to teach.
  std::string hint(const KeyHints& keys) const;

 private:
  enum class Shown : std::uint8_t { kNone, kStuck, kKeys, kDown, kLook, kElement };

  void note(const Game& game, std::uint32_t slot, bool looks, Settings& settings);
  Shown chosen(const Game& game, std::uint32_t slot, const Settings& settings) const;

  FirstKeys keys_;
  PushedBall push_;
  TurnedDown down_;
  ElementHints elements_;
  Shown shown_ = Shown::kNone;
  std::uint32_t downTicks_ = 0;  // for which that of down was shown
  std::uint32_t lookTicks_ = 0;  // for which that of looking round was shown
  std::uint32_t looked_ = 0;     // ticks of looking round
};

}  // namespace platon
