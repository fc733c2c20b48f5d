#pragma once

#include <cstdint>
#include <cstdio>
#include <vector>

#include "tests/exactness/reference/terrain_judge.h"

namespace platon::reference {

/// Judges random terrains and sums up. A scene counts if the ideal body is in contact at its end and does not stop
/// at a joint.
class TerrainTable {
 public:
  struct Row {
    std::uint64_t seed = 0;
    Verdict verdict;
  };

  /// Prints one line per scene to `rows`, unless it is null.
  TerrainTable(std::int64_t ticks, std::FILE* rows);

  /// Judges the terrains with ascending seeds until `count` of them count.
  void run(std::uint64_t firstSeed, std::int64_t count);
  /// Judges one terrain.
  void add(std::uint64_t seed);
  /// Adds the verdict on a scene.
  void add(const Row& row);

  void printSummary(std::FILE* out) const;
  /// Seeds of all scenes in which the body is above kMaxLatticeError, those that stop at a joint included.
  std::vector<std::uint64_t> above() const;
  std::int64_t counted() const;
  std::int64_t ties() const { return number(Tie::Kind::kDivided) + number(Tie::Kind::kNarrow); }
  /// True if no scene is above kMaxLatticeError, and at most 1 % of the scenes that count, or one, have a tie or a
  /// narrow rest.
  bool holds() const;

 private:
  std::int64_t number(Tie::Kind kind) const;

  std::int64_t ticks_;
  std::FILE* out_;
  std::vector<Row> rows_;  // in contact at their end
  std::int64_t withoutContact_ = 0;
};

}  // namespace platon::reference
