#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "platon/game/level.h"

namespace platon {

using LevelPointer = std::shared_ptr<const Level>;

/// The levels that a server plays, one after another, for ever.
class LevelRotation {
 public:
  /// Starts at the first; there is at least one.
  explicit LevelRotation(std::vector<LevelPointer> levels);

  const LevelPointer& current() const { return current_; }
  /// What comes after the current one.
  const LevelPointer& next() const { return levels_[next_]; }
  void advance();

  /// The current level stays what it is; the first of the new ones comes next.
  void replace(std::vector<LevelPointer> levels);

  /// The level with this hash of its text: the current one or one of the rotation; null when there is none.
  LevelPointer find(std::uint64_t hash) const;

 private:
  std::vector<LevelPointer> levels_;
  std::size_t next_ = 0;
  LevelPointer current_;
};

}  // namespace platon
