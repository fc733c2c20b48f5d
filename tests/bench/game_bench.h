#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tests/bench/measure.h"

namespace platon::bench {

struct SnapshotResult {
  std::string level;
  std::size_t bodies = 0;
  std::size_t bytes = 0;
  Spread saveNs;
  Spread restoreNs;
  Spread hashNs;      ///< of the bodies
  Spread gameHashNs;  ///< of the whole game: bodies and players
};

/// Memory that is not saved: caches and work space of the step.
struct DerivedResult {
  std::string scene;
  std::size_t bodies = 0;
  double bytesPerBody = 0;
};

struct ResimulationResult {
  std::string level;
  std::size_t players = 0;
  int ticks = 0;
  Spread microseconds;
};

/// Cost of one player in one tick.
struct AdvanceResult {
  std::string level;
  std::size_t players = 0;
  Spread nsPerPlayerTick;
};

struct GameResults {
  std::vector<AdvanceResult> advances;            ///< every shipped level with eight players
  std::vector<SnapshotResult> snapshots;          ///< 64 bodies on the slowest of these levels
  std::vector<DerivedResult> derived;             ///< 64 bodies among 10 000 random segments, and on every level
  std::vector<ResimulationResult> resimulations;  ///< on the same level: 16 players for 15 ticks, 64 for 60
};

/// Requires the root of the tree as working folder.
GameResults benchGames(const Effort& effort);

}  // namespace platon::bench
