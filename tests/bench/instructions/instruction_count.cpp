#include <algorithm>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <iostream>
#include <memory>
#include <string_view>
#include <vector>

#include "platon/game/game.h"
#include "platon/game/level.h"
#include "platon/physics/sweep.h"
#include "tests/bench/sweep_sets.h"
#include "tests/determinism/lockstep_levels.h"
#include "tests/sim/button_presses.h"
#include "tests/support/crowded_levels.h"

namespace platon::bench {
namespace {

constexpr const char* kUsage =
    "usage: platon-instruction-count advance|crowded|sweep COUNT\n"
    "Calls Game::advance for eight players, on a usual level or on the most expensive one that is allowed, or Sweep on "
    "a\n"
    "set of queries, COUNT times on fixed input.\n"
    "check_instructions.py runs it under callgrind.\n";

constexpr const char* kLevel = "tests/determinism/golden/levels/crowd.level";
constexpr std::string_view kCrowdedLevel = "CombRoundTetrahedron";
constexpr std::uint64_t kSeed = 3;
constexpr std::size_t kPlayers = 8;
constexpr std::size_t kQueries = 1000;

std::shared_ptr<const Level> crowdedLevel() {
  const std::vector<CrowdedLevel> levels = crowdedLevels();
  const auto worst =
      std::find_if(levels.begin(), levels.end(), [](const CrowdedLevel& level) { return level.name == kCrowdedLevel; });
  return loadLevel(worst->text(1)).level;
}

std::uint64_t advance(const std::shared_ptr<const Level>& level, std::int64_t ticks) {
  Game game(level);
  std::vector<sim::ButtonPresses> presses;
  for (std::uint32_t slot = 0; slot < kPlayers; ++slot) presses.emplace_back(kSeed, slot);
  std::vector<Input> inputs(kPlayers);
  for (std::int64_t tick = 0; tick < ticks; ++tick) {
    for (std::size_t slot = 0; slot < kPlayers; ++slot) inputs[slot] = presses[slot].next();
    game.advance(inputs);
  }
  return game.hash();
}

std::uint64_t sweep(std::int64_t times) {
  const std::vector<SweepSet> sets = sweepSets(kQueries);
  const auto set = std::find_if(sets.begin(), sets.end(), [](const SweepSet& each) { return each.name == "random"; });
  Sweep sweep;
  std::uint64_t hits = 0;
  for (std::int64_t i = 0; i < times; ++i) {
    for (const SweepQuery& query : set->queries) {
      sweep.start(set->shapes[query.shape], query.position, query.displacement);
      hits += sweep.against(query.segment).has_value() ? 1 : 0;
    }
  }
  return hits;
}

int main(int count, char** arguments) {
  std::int64_t times = 0;
  const std::string_view what = count == 3 ? arguments[1] : "";
  const std::string_view number = count == 3 ? arguments[2] : "";
  const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), times);
  if ((what != "advance" && what != "crowded" && what != "sweep") || error != std::errc{} ||
      end != number.data() + number.size()) {
    std::cerr << kUsage;
    return 2;
  }
  const auto result = [&] {
    if (what == "sweep") return sweep(times);
    return advance(what == "crowded" ? crowdedLevel() : sim::levelFrom(kLevel), times);
  };
  std::cout << result() << '\n';
  return 0;
}

}  // namespace
}  // namespace platon::bench

int main(int count, char** arguments) {
  try {
    return platon::bench::main(count, arguments);
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 1;
  }
}
