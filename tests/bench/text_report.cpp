#include <algorithm>
#include <cstdarg>
#include <cstdint>
#include <cstdio>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "tests/bench/report.h"

namespace platon::bench {
namespace {

class Lines {
 public:
  [[gnu::format(printf, 2, 3)]] void add(const char* layout, ...) {
    char line[256];
    va_list arguments;
    va_start(arguments, layout);
    std::vsnprintf(line, sizeof line, layout, arguments);
    va_end(arguments);
    text_ += line;
    text_ += '\n';
  }
  const std::string& text() const { return text_; }

 private:
  std::string text_;
};

void addSweeps(const std::vector<SweepResult>& results, Lines& lines) {
  lines.add("\n%-14s %-13s %9s %19s %7s %7s %7s %11s %11s", "sweep", "engine", "ns", "passes", "hits", "missed",
            "false", "time error", "overlap");
  for (const SweepResult& r : results) {
    const double share = 100.0 * static_cast<double>(r.hits) / static_cast<double>(r.queries);
    lines.add("%-14s %-13s %9.1f %9.1f %9.1f %5.0f %% %7zu %7zu %11.2e %11.3g", r.set.c_str(), r.engine.c_str(),
              r.nsPerQuery.median, r.nsPerQuery.low, r.nsPerQuery.high, share, r.missed, r.falseHits, r.maxTimeError,
              r.maxOverlap);
  }
}

void addSteps(const std::vector<StepResult>& results, Lines& lines) {
  lines.add("\n%-10s %-15s %9s %7s %9s %19s %12s %10s %8s", "step", "engine", "segments", "bodies", "ns", "passes",
            "bytes/segment", "bytes/body", "jammed");
  for (const StepResult& r : results) {
    lines.add("%-10s %-15s %9zu %7zu %9.1f %9.1f %9.1f %12.1f %10.0f %6.1f %%", r.scenes.c_str(), r.engine.c_str(),
              r.segments, r.bodies, r.nsPerStep.median, r.nsPerStep.low, r.nsPerStep.high, r.bytesPerSegment,
              r.bytesPerBody, 100 * r.jams.share());
  }
}

void addHardCases(const std::vector<HardResult>& results, Lines& lines) {
  lines.add("\n%-18s %-13s %8s %11s %9s %7s %7s %11s %9s", "hard case", "engine", "steps", "overlap", "tunnelled",
            "drops", "pops", "rest drift", "rest gap");
  for (const HardResult& r : results) {
    lines.add("%-18s %-13s %8lld %11.3f %9lld %7lld %7lld %11.3f %9.3f", r.name.c_str(), r.engine.c_str(),
              static_cast<long long>(r.steps), r.maxOverlap, static_cast<long long>(r.tunnelled),
              static_cast<long long>(r.speedDrops), static_cast<long long>(r.pops), r.restDrift, r.restGap);
  }
}

void addResolutions(const std::vector<ResolutionResult>& results, Lines& lines) {
  lines.add("\n%-17s %14s %9s %16s", "resolution", "subunits/unit", "ns", "error in units");
  for (const ResolutionResult& r : results) {
    lines.add("%-17s %14lld %9.1f %16.3e", r.engine.c_str(), static_cast<long long>(r.subunitsPerUnit),
              r.nsPerStep.median, r.maxTrajectoryError);
  }
}

// The worst scene of every engine after each time.
void addTrajectories(const TrajectoryResults& results, Lines& lines) {
  std::map<std::pair<std::string, std::int64_t>, double> worst;
  for (const TrajectoryResult& r : results.errors) {
    double& error = worst[{r.engine, r.ticks}];
    error = std::max(error, r.maxError);
  }
  lines.add("\n%-17s %9s %16s", "trajectory", "ticks", "error in units");
  for (const auto& [key, error] : worst) {
    lines.add("%-17s %9lld %16.3e", key.first.c_str(), static_cast<long long>(key.second), error);
  }
  lines.add(
      "%lld scenes and %lld terrains; left out: %lld with a tie, %lld with a tie at a joint, %lld without contact",
      static_cast<long long>(results.scenes), static_cast<long long>(results.terrains),
      static_cast<long long>(results.dividedTies), static_cast<long long>(results.jointTies),
      static_cast<long long>(results.leftContact));
}

void addParts(const std::vector<PartResult>& results, Lines& lines) {
  lines.add("\n%-50s %9s %9s %10s %11s", "one body's step", "ns", "instances", "crossings", "allocations");
  for (const PartResult& r : results) {
    lines.add("%-50s %9.1f %9.2f %10.3f %11.2f", r.scene.c_str(), r.nsPerStep.median, r.instances, r.crossings,
              r.allocations);
  }
}

void addGames(const GameResults& results, Lines& lines) {
  lines.add("%s", "");
  for (const SnapshotResult& r : results.snapshots) {
    lines.add("%s, %zu bodies: %zu bytes; save %.0f ns, restore %.0f ns, hash %.0f ns, of the game %.0f ns",
              r.level.c_str(), r.bodies, r.bytes, r.saveNs.median, r.restoreNs.median, r.hashNs.median,
              r.gameHashNs.median);
  }
  for (const DerivedResult& r : results.derived) {
    lines.add("%-30s %zu bodies: %.0f bytes a body are not saved", r.scene.c_str(), r.bodies, r.bytesPerBody);
  }
  for (const ResimulationResult& r : results.resimulations) {
    lines.add("%s, %zu players x %d ticks resimulated: %.0f microseconds", r.level.c_str(), r.players, r.ticks,
              r.microseconds.median);
  }
  for (const AdvanceResult& r : results.advances) {
    lines.add("%-30s %zu players: %.0f ns per player and tick (%.0f to %.0f)", r.level.c_str(), r.players,
              r.nsPerPlayerTick.median, r.nsPerPlayerTick.low, r.nsPerPlayerTick.high);
  }
}

}  // namespace

std::string toText(const Report& report) {
  Lines lines;
  addSweeps(report.sweeps, lines);
  addSteps(report.steps, lines);
  addHardCases(report.hardCases, lines);
  addResolutions(report.resolutions, lines);
  addTrajectories(report.trajectories, lines);
  addParts(report.parts, lines);
  addGames(report.games, lines);
  return lines.text();
}

}  // namespace platon::bench
