#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "platon/game/level.h"

namespace platon {

/// Levels of a server that outlive the sessions with it. A session asks it before it requests a level.
class LevelStore {
 public:
  virtual ~LevelStore() = default;
  /// Hashes of the levels that were used last, at most `count`. A level among them may turn out to be lost.
  virtual std::vector<std::uint64_t> newest(std::size_t count) const = 0;
  /// The level with this hash; null if it is not stored. Its text has been checked against the hash.
  virtual std::shared_ptr<const Level> load(std::uint64_t hash) = 0;
  /// Stores a level. It may be lost again.
  virtual void keep(const Level& level) = 0;
};

}  // namespace platon
