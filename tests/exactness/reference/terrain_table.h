#pragma once

#include <cstdint>
#include <cstdio>
#include <vector>

#include "tests/exactness/reference/terrain_judge.h"

namespace platon::reference {

/// Judges random terrains with ascending seeds and sums up.
class TerrainTable {
 public:
  struct Row {
    std::uint64_t seed = 0;
    Verdict verdict;
  };

  /// Prints one line per scene to `rows`, unless it is null.
  TerrainTable(std::int64_t ticks, std::FILE* rows);

  /// Judges terrains from `firstSeed` on until `count` of them count.
  void run(std::uint64_t firstSeed, std::int64_t count);
  /// Judges one terrain.
  void add(std::uint64_t seed);

  void printSummary(std::FILE* out) const;
  /// True if every scene that counts holds.
  bool holds() const;
  const std::vector<Row>& rows() const { return counted_; }

 private:
  std::int64_t ticks_;
  std::FILE* out_;
  std::vector<Row> counted_;
  std::int64_t withoutContact_ = 0;
};

}  // namespace platon::reference
