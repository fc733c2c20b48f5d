#include "client/lobby/shipped_levels.h"

#include <algorithm>
#include <utility>
#include <variant>

#include "platon/game/game.h"
#include "server/app/level_files.h"
#include "server/times/best_time_store.h"

namespace platon {
namespace {

BestTimes timesIn(const std::string& file) {
  auto read = readBestTimes(file);
  auto* const times = std::get_if<BestTimes>(&read);
  return times == nullptr ? BestTimes() : std::move(*times);
}

LevelEntry entryOf(const Level& level, const BestTimes& times) {
  LevelEntry entry{level.title, std::string(nameOf(level.solid)), std::max(level.players, 1u)};
  if (const DatedTime* const best = times.find({level.hash, kRulesVersion})) {
    entry.bestSeconds = double{1} * best->time.ticks / kTicksPerSecond;
  }
  return entry;
}

}  // namespace

std::vector<ShippedLevel> loadShippedLevels() {
  const std::vector<std::string> files = shippedLevelFiles();
  const LoadedLevels loaded = loadLevelFiles(files);
  std::vector<ShippedLevel> levels;
  for (std::size_t i = 0; i < files.size(); ++i) levels.push_back({files[i], loaded.levels[i]});
  // The solids follow each other as in the order of the files.
  std::vector<SolidKind> solids;
  const auto placeOf = [&solids](const ShippedLevel& level) {
    return std::find(solids.begin(), solids.end(), level.level->solid) - solids.begin();
  };
  for (const ShippedLevel& level : levels) {
    if (placeOf(level) == std::ssize(solids)) solids.push_back(level.level->solid);
  }
  std::stable_sort(levels.begin(), levels.end(),
                   [&](const ShippedLevel& a, const ShippedLevel& b) { return placeOf(a) < placeOf(b); });
  return levels;
}

std::vector<LevelEntry> entriesOf(const std::vector<ShippedLevel>& levels, const std::string& bestTimes) {
  const BestTimes times = timesIn(bestTimes);
  std::vector<LevelEntry> entries;
  for (const ShippedLevel& each : levels) entries.push_back(entryOf(*each.level, times));
  return entries;
}

}  // namespace platon
