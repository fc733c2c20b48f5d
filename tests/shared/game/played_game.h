#pragma once

#include <cstdint>
#include <initializer_list>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "platon/exact/integer.h"
#include "platon/game/game.h"
#include "platon/game/level.h"
#include "tests/support/test_levels.h"

namespace platon {

inline constexpr std::uint8_t kNone = 0;

/// A hexahedron with face size 480. `start` and `goal` are lines of a level text, `lines` the lines of each face.
inline std::shared_ptr<const Level> cubeLevel(const std::string& start, std::vector<std::string> lines,
                                              const std::string& goal = "5 0 0") {
  lines.resize(6);
  std::string text = "HEXAHEDRON\n" + start + "\n" + goal + "\n480\n";
  for (const std::string& face : lines) text += "%\n" + face + "\n";
  return levelOf(text);
}

/// A game played by a test. Each slot keeps its buttons until they are changed.
class PlayedGame {
 public:
  explicit PlayedGame(std::shared_ptr<const Level> level) : game(std::move(level)) {}

  /// Sets the buttons of slot 0 and advances.
  void run(int ticks, std::uint8_t buttons) {
    hold(0, buttons);
    for (int tick = 0; tick < ticks; ++tick) game.advance(held_);
  }
  /// Sets the buttons of a slot; the player joins if there is none.
  void hold(std::size_t slot, std::uint8_t buttons) {
    if (held_.size() <= slot) held_.resize(slot + 1);
    held_[slot].buttons = static_cast<std::uint8_t>(buttons | Input::kPresent);
  }
  /// Removes the player of a slot with the next tick.
  void release(std::size_t slot) { held_.at(slot) = Input(); }
  void advance(int ticks = 1) {
    for (int tick = 0; tick < ticks; ++tick) game.advance(held_);
  }

  const PlayerState& player(std::uint32_t slot = 0) const { return game.player(slot); }
  const EntityState& entity(std::uint32_t slot = 0) const { return game.world().entities()[slot]; }
  Point position() const { return entity().position; }
  bool grounded() const { return player().ground != Point(); }

  Game game;

 private:
  std::vector<Input> held_;
};

/// `count` level units in subunits.
constexpr std::int32_t units(std::int32_t count) { return count * kSubunitsPerUnit; }

}  // namespace platon
