#include "tests/exactness/reference/terrain_table.h"

#include <algorithm>
#include <string>

#include "tests/exactness/reference/terrain.h"

namespace platon::reference {
namespace {

/// At most one scene of this many may have a tie.
constexpr std::int64_t kScenesPerTie = 100;

long long wide(std::int64_t value) { return value; }

/// The `share`-th value of a sorted list, 0 to 1.
double quantile(std::vector<double> values, double share) {
  if (values.empty()) return 0;
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
}

std::string toText(const Tie& tie) {
  if (tie.kind == Tie::Kind::kNone) return "-";
  const std::string kind = tie.kind == Tie::Kind::kJoint    ? "joint"
                           : tie.kind == Tie::Kind::kNarrow ? "narrow"
                                                            : "divided";
  return kind + (" at " + std::to_string(static_cast<std::int64_t>(tie.tick)));
}

void printErrors(std::FILE* out, const char* what, const std::vector<double>& values) {
  std::fprintf(out, "%s: worst %.9g, 99 %% %.9g, median %.9g subunits\n", what, quantile(values, 1),
               quantile(values, 0.99), quantile(values, 0.5));
}

}  // namespace

TerrainTable::TerrainTable(std::int64_t ticks, std::FILE* rows) : ticks_(ticks), out_(rows) {
  if (out_ != nullptr) {
    std::fprintf(out_, "%8s %-8s %8s %6s %9s %12s %14s %6s  %s\n", "seed", "shape", "segments", "legs", "rests at",
                 "max lattice", "max precise", "above", "tie");
  }
}

void TerrainTable::run(std::uint64_t firstSeed, std::int64_t count) {
  const std::int64_t goal = counted() + count;
  for (std::uint64_t seed = firstSeed; counted() < goal; ++seed) add(seed);
}

void TerrainTable::add(std::uint64_t seed) {
  const Terrain terrain = randomTerrain(seed, ticks_);
  const Verdict verdict = judge(terrain.scene, ticks_);
  add({seed, verdict});
  if (out_ == nullptr || !verdict.inContact) return;
  std::fprintf(out_, "%8llu %-8s %8zu %6zu %9.1f %12.3f %14.9f %6lld  %s\n", static_cast<unsigned long long>(seed),
               terrain.shape.c_str(), terrain.scene.lines.size(), verdict.idealLegs, verdict.restsAt.value_or(-1),
               verdict.maxLattice, verdict.maxPrecise, wide(verdict.firstAbove), toText(verdict.tie).c_str());
}

void TerrainTable::add(const Row& row) {
  if (row.verdict.inContact) {
    rows_.push_back(row);
  } else {
    ++withoutContact_;
  }
}

std::int64_t TerrainTable::number(Tie::Kind kind) const {
  return std::count_if(rows_.begin(), rows_.end(), [&](const Row& row) { return row.verdict.tie.kind == kind; });
}

std::int64_t TerrainTable::counted() const {
  return std::count_if(rows_.begin(), rows_.end(), [](const Row& row) { return row.verdict.counts(); });
}

std::vector<std::uint64_t> TerrainTable::above() const {
  std::vector<std::uint64_t> seeds;
  for (const Row& row : rows_) {
    if (!row.verdict.holds()) seeds.push_back(row.seed);
  }
  return seeds;
}

bool TerrainTable::holds() const {
  return above().empty() && ties() <= std::max<std::int64_t>(1, counted() / kScenesPerTie);
}

void TerrainTable::printSummary(std::FILE* out) const {
  std::vector<double> lattice;
  std::vector<double> precise;
  std::int64_t preciseAbove = 0;
  for (const Row& row : rows_) {
    if (row.verdict.tie.kind != Tie::Kind::kNone) continue;
    lattice.push_back(row.verdict.maxLattice);
    precise.push_back(row.verdict.maxPrecise);
    preciseAbove += row.verdict.maxPrecise > kMaxPreciseError;
  }
  std::fprintf(out, "%lld scenes of %lld ticks, %lld of them with a tie or a narrow rest (%lld narrow)\n",
               wide(counted()), wide(ticks_), wide(ties()), wide(number(Tie::Kind::kNarrow)));
  std::fprintf(out, "not counted: %lld stopped at a joint, %lld without contact in the last %lld ticks\n",
               wide(number(Tie::Kind::kJoint)), wide(withoutContact_), wide(kContactTicks));
  printErrors(out, "lattice position", lattice);
  printErrors(out, "position and remainder", precise);
  std::fprintf(out, "position and remainder above %g subunits: %lld scenes\n", kMaxPreciseError, wide(preciseAbove));
  const std::vector<std::uint64_t> seeds = above();
  std::fprintf(out, "lattice position above %g subunits: %zu scenes", kMaxLatticeError, seeds.size());
  for (const std::uint64_t seed : seeds) std::fprintf(out, " %llu", static_cast<unsigned long long>(seed));
  std::fprintf(out, "\n");
}

}  // namespace platon::reference
