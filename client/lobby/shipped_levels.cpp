#include "client/lobby/shipped_levels.h"

#include <algorithm>
#include <filesystem>
#include <sstream>
#include <utility>
#include <variant>

#include "client/ui/solid_text.h"
#include "levels/solve/recorded_way.h"
#include "platon/game/game.h"
#include "protocol/files/text_file.h"
#include "protocol/program_error.h"
#include "server/app/level_files.h"
#include "server/times/best_times.h"

namespace platon {
namespace {

BestTimes timesIn(const std::string& file) {
  auto read = readBestTimes(file);
  auto* const times = std::get_if<BestTimes>(&read);
  return times == nullptr ? BestTimes() : std::move(*times);
}

// The best time by the last rules before the present ones that have one.
std::optional<std::uint32_t> olderTicks(const BestTimes& times, std::uint64_t level) {
  for (std::uint32_t rules = kRulesVersion; rules-- > 0;) {
    if (const DatedTime* const best = times.find({level, rules})) return best->time.ticks;
  }
  return std::nullopt;
}

constexpr std::size_t kMaxTimesBytes = 1 << 16;

constexpr std::size_t kMaxWayBytes = 1 << 20;

// What is in a file beside the folders of the solids; empty if it cannot be read.
std::string readBeside(const std::string& levelFile, const std::filesystem::path& name, std::size_t maxBytes) {
  auto read = readTextFile((std::filesystem::path(levelFile).parent_path().parent_path() / name).string(), maxBytes);
  auto* const content = std::get_if<std::string>(&read);
  return content == nullptr ? std::string() : std::move(*content);
}

// None if they are missing.
std::vector<std::string> gameLevelFilesIfAny() {
  try {
    return gameLevelFiles();
  } catch (const ProgramError&) {
    return {};
  }
}

bool holds(const std::string& levelFile, const Level& level) {
  const auto read = readTextFile(levelFile, kMaxLevelBytes);
  const auto* const text = std::get_if<std::string>(&read);
  return text != nullptr && *text == level.text;
}

ShippedLevel shippedLevel(const std::string& file, std::shared_ptr<const Level> level,
                          const std::map<std::string, std::uint32_t>& wayTimes) {
  const auto way = wayTimes.find(std::filesystem::path(file).stem().string());
  return {file, std::move(level), way == wayTimes.end() ? 0 : way->second};
}

}  // namespace

std::vector<std::string> gameLevelFiles() {
  return shippedLevelFiles("reinstall Platon, or start it with --level FILE");
}

std::vector<ShippedLevel> loadShippedLevels() {
  const std::vector<std::string> files = gameLevelFiles();
  const LoadedLevels loaded = loadLevelFiles(files);
  std::vector<ShippedLevel> levels;
  const auto times = parseWayTimes(readBeside(files.front(), "way_times", kMaxTimesBytes));
  for (std::size_t i = 0; i < files.size(); ++i) levels.push_back(shippedLevel(files[i], loaded.levels[i], times));
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

std::map<std::string, std::uint32_t> parseWayTimes(const std::string& text) {
  std::map<std::string, std::uint32_t> times;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string name;
    std::uint32_t ticks = 0;
    if (words >> name >> ticks && name.front() != '#') times[name] = ticks;
  }
  return times;
}

std::optional<Solution> shippedWay(const Level& level) {
  for (const std::string& file : gameLevelFilesIfAny()) {
    if (!holds(file, level)) continue;
    const auto name = std::filesystem::path("ways") / std::filesystem::path(file).stem().concat(".recording");
    const std::string bytes = readBeside(file, name, kMaxWayBytes);
    RecordedWay way = readRecordedWay(std::vector<std::uint8_t>(bytes.begin(), bytes.end()));
    const bool isWay = way.level && way.level->hash == level.hash && !way.inputs.empty() && !way.inputs.front().empty();
    if (isWay) return std::move(way.inputs);
  }
  return std::nullopt;
}

LevelEntry entryOf(const ShippedLevel& level) {
  LevelEntry entry{level.level->title, textOf(level.level->solid), std::max(level.level->players, 1u)};
  if (level.wayTicks != 0) entry.medals = medalTimesOf(level.wayTicks);
  return entry;
}

std::vector<LevelEntry> entriesOf(const std::vector<ShippedLevel>& levels, const std::string& bestTimes,
                                  const ReachedLevels& reached) {
  const BestTimes times = timesIn(bestTimes);
  std::vector<LevelEntry> entries;
  for (const ShippedLevel& each : levels) {
    entries.push_back(entryOf(each));
    const DatedTime* const best = times.find({each.level->hash, kRulesVersion});
    if (best != nullptr) entries.back().bestTicks = best->time.ticks;
    entries.back().olderTicks = olderTicks(times, each.level->hash);
    entries.back().reached = best != nullptr || reached.has(each.level->hash);
  }
  return entries;
}

}  // namespace platon
