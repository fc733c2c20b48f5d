#pragma once

#include <cstdint>
#include <string>

#include "client/ui/controls/key_hints.h"
#include "client/ui/hints/element_hints.h"
#include "client/ui/hints/first_keys.h"
#include "client/ui/settings.h"
#include "platon/game/game.h"

namespace platon {

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
