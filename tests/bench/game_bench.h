#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tests/bench/measure.h"

namespace platon::bench {

struct SnapshotResult {
  std::string level;
  std::size_t movers = 0;
  std::size_t bytes = 0;
  Spread saveNs;
  Spread restoreNs;
  Spread hashNs;
};

struct ResimulationResult {
  std::string level;
  std::size_t players = 0;
  int ticks = 0;
  Spread microseconds;
};

/// Of one player in one tick.
struct AdvanceResult {
  std::string level;
  std::size_t players = 0;
  Spread nsPerPlayerTick;
};

struct GameResults {
  std::vector<AdvanceResult> advances;            ///< each shipped level, eight players
  std::vector<SnapshotResult> snapshots;          ///< 64 movers, on the slowest of these levels
  std::vector<ResimulationResult> resimulations;  ///< 16 players x 15 ticks, 64 x 60, on the same
};

/// Run from the root of the tree, for the levels.
GameResults benchGames(const Effort& effort);

}  // namespace platon::bench
