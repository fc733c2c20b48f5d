#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "client/ui/controls/key_names.h"
#include "client/ui/hints/element_hints.h"
#include "client/ui/settings.h"
#include "platon/game/game.h"
#include "platon/game/player.h"

namespace platon {

/// Teaches a new player the first keys and what the picture means: shows each hint until the player has done it.
class FirstKeys {
 public:
  /// `known`: the player needs none of it.
  explicit FirstKeys(bool known) : step_(known ? Step::kDone : Step::kRun) {}

  /// Notes what the ball does in a tick; `face`: the one that it is on.
  void observe(const PlayerState& player, std::uint32_t face);
  /// What to do next; empty if there is nothing to teach.
  std::string hint(const KeyHints& keys) const;
  bool done() const { return step_ == Step::kDone; }

 private:
  enum class Step { kRun, kJump, kCross, kDown, kGoal, kMenu, kDone };

  void begin(Step step);
  void observeStep(const PlayerState& player);
  void observePush(const PlayerState& player);

  Step step_;
  std::int64_t way_ = 0;               // subunits moved to the sides in kRun, or risen in the present jump in kJump
  std::uint32_t ticks_ = 0;            // of kDown, kGoal or kMenu
  std::optional<std::uint32_t> face_;  // where the ball was first
  bool crossed_ = false;               // it has been on another face
  std::uint32_t pushed_ = 0;           // ticks of pressing against something that does not give way
};

/// The hints for new players: first the keys, then the elements of the levels. The settings remember what is known.
class NewPlayerHints {
 public:
  explicit NewPlayerHints(const Settings& settings) : keys_(!settings.firstKeys) {}

  /// Notes what the player in this slot has done in a tick, and what is known now in the settings.
  void observe(const Game& game, std::uint32_t slot, Settings& settings);
  /// What to do next; empty if there is nothing to teach.
  std::string hint(const KeyHints& keys) const;

 private:
  FirstKeys keys_;
  ElementHints elements_;
};

}  // namespace platon
