#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "platon/game/level.h"

namespace platon {

using LevelPointer = std::shared_ptr<const Level>;

/// The levels that a server plays, in order, starting over after the last.
class LevelRotation {
 public:
  /// What is played first, while nobody is there yet: kForOne: the first level that one player can play; kFirst: the
  /// first one, whatever it needs.
  enum class Start : std::uint8_t { kForOne, kFirst };

  /// `levels` must not be empty.
  explicit LevelRotation(std::vector<LevelPointer> levels, Start start = Start::kForOne);

  const LevelPointer& current() const { return current_; }
  /// The next level after the current one that needs at most so many players, or 1; the next one if there is none.
  const LevelPointer& next(std::size_t players) const { return levels_[placeOfNext(players)]; }
  /// Makes next(players) the current level.
  void advance(std::size_t players);

  /// Replaces the levels; `levels` must not be empty. The current level stays; the first new one is next.
  void replace(std::vector<LevelPointer> levels);

  /// Replaces each level by its new version: as many as there are, in the same order. The current level stays, and so
  /// does what is next.
  void update(std::vector<LevelPointer> levels);

  /// The current level or level of the rotation whose text has this hash; null if there is none.
  LevelPointer find(std::uint64_t hash) const;

 private:
  std::size_t placeOfNext(std::size_t players) const;

  std::vector<LevelPointer> levels_;
  std::size_t next_ = 0;
  LevelPointer current_;
};

}  // namespace platon
