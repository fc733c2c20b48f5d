#include "tests/exactness/reference/terrain_table.h"

#include <algorithm>

#include "tests/exactness/reference/terrain.h"

namespace platon::reference {
namespace {

long long wide(std::int64_t value) { return value; }

/// The `share`-th value of a sorted list, 0 to 1.
double quantile(std::vector<double> values, double share) {
  if (values.empty()) return 0;
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
}

void printErrors(std::FILE* out, const char* what, const std::vector<double>& values) {
  std::fprintf(out, "%s: worst %.9g, 99 %% %.9g, median %.9g subunits\n", what, quantile(values, 1),
               quantile(values, 0.99), quantile(values, 0.5));
}

}  // namespace

TerrainTable::TerrainTable(std::int64_t ticks, std::FILE* rows) : ticks_(ticks), out_(rows) {
  if (out_ != nullptr) {
    std::fprintf(out_, "%8s %-8s %8s %6s %9s %12s %14s %6s\n", "seed", "shape", "segments", "legs", "rests at",
                 "max lattice", "max precise", "above");
  }
}

void TerrainTable::run(std::uint64_t firstSeed, std::int64_t count) {
  const std::size_t goal = counted_.size() + static_cast<std::size_t>(count);
  for (std::uint64_t seed = firstSeed; counted_.size() < goal; ++seed) add(seed);
}

void TerrainTable::add(std::uint64_t seed) {
  const Terrain terrain = randomTerrain(seed, ticks_);
  const Verdict verdict = judge(terrain.scene, ticks_);
  if (!verdict.inContact) {
    ++withoutContact_;
    return;
  }
  counted_.push_back({seed, verdict});
  if (out_ == nullptr) return;
  std::fprintf(out_, "%8llu %-8s %8zu %6zu %9.1f %12.3f %14.9f %6lld\n", static_cast<unsigned long long>(seed),
               terrain.shape.c_str(), terrain.scene.lines.size(), verdict.idealLegs, verdict.restsAt,
               verdict.maxLattice, verdict.maxPrecise, wide(verdict.firstAbove));
}

bool TerrainTable::holds() const {
  return std::all_of(counted_.begin(), counted_.end(), [](const Row& row) { return row.verdict.holds(); });
}

void TerrainTable::printSummary(std::FILE* out) const {
  std::vector<double> lattice;
  std::vector<double> precise;
  std::int64_t above = 0;
  for (const Row& row : counted_) {
    lattice.push_back(row.verdict.maxLattice);
    precise.push_back(row.verdict.maxPrecise);
    above += !row.verdict.holds();
  }
  std::fprintf(out, "%zu scenes of %lld ticks; %lld more without contact in the last %lld ticks\n", counted_.size(),
               wide(ticks_), wide(withoutContact_), wide(kContactTicks));
  printErrors(out, "lattice position", lattice);
  printErrors(out, "with remainder", precise);
  std::fprintf(out, "above %g subunits: %lld scenes", kMaxLatticeError, wide(above));
  for (const Row& row : counted_) {
    if (!row.verdict.holds()) std::fprintf(out, " %llu", static_cast<unsigned long long>(row.seed));
  }
  std::fprintf(out, "\n");
}

}  // namespace platon::reference
