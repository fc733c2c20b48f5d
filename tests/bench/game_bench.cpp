#include "tests/bench/game_bench.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "platon/game/game.h"
#include "tests/bench/engines/platon_engine.h"
#include "tests/bench/heap.h"
#include "tests/bench/steps/step_runner.h"
#include "tests/bench/steps/step_scenes.h"
#include "tests/determinism/lockstep_levels.h"
#include "tests/sim/button_presses.h"

namespace platon::bench {
namespace {

constexpr std::uint64_t kSeed = 3;
constexpr std::size_t kManyBodies = 64;

// Seeded inputs of players who press buttons at the pace of a person.
class PlayerInputs {
 public:
  explicit PlayerInputs(std::size_t players) : inputs_(players) {
    for (std::uint32_t slot = 0; slot < players; ++slot) presses_.emplace_back(kSeed, slot);
  }
  std::span<const Input> next() {
    for (std::size_t slot = 0; slot < inputs_.size(); ++slot) inputs_[slot] = presses_[slot].next();
    return inputs_;
  }

 private:
  std::vector<sim::ButtonPresses> presses_;
  std::vector<Input> inputs_;
};

struct Session {
  Session(std::shared_ptr<const Level> level, std::size_t players) : game(std::move(level)), presses(players) {
    play(600);
  }

  void play(int ticks) {
    for (int tick = 0; tick < ticks; ++tick) game.advance(presses.next());
  }

  Game game;
  PlayerInputs presses;
};

// Average nanoseconds of `work`, called `times` times.
template <class Work>
double averageOf(std::int64_t times, Work&& work) {
  return nanosecondsOf([&] {
           for (std::int64_t i = 0; i < times; ++i) work();
         }) /
         static_cast<double>(times);
}

SnapshotResult benchSnapshot(const std::string& path, const Effort& effort) {
  Session session(sim::levelFrom(path), kManyBodies);
  const WorldState& live = session.game.world().state();
  World other = session.game.world();
  WorldState kept = live;
  const std::int64_t times = 20000 / effort.divisor;
  const auto save = [&] {
    kept = live;
    keep(kept);
  };
  const auto restore = [&] { other.restoreUnchecked(kept); };
  const auto hash = [&] { keep(other.hash()); };
  const auto hashGame = [&] { keep(session.game.hash()); };
  const auto spreads = interleaved({[&] { return averageOf(times, save); }, [&] { return averageOf(times, restore); },
                                    [&] { return averageOf(times, hash); }, [&] { return averageOf(times, hashGame); }},
                                   effort.passes);
  const std::size_t bytes = live.entities.size() * sizeof(EntityState) + live.instances.size() * sizeof(InstanceState);
  return {sim::testName(path), kManyBodies, bytes, spreads[0], spreads[1], spreads[2], spreads[3]};
}

// The reconciliation of a client: copies the confirmed game and advances it to the predicted tick.
ResimulationResult benchResimulation(const std::string& path, std::size_t players, int ticks, const Effort& effort) {
  Session session(sim::levelFrom(path), players);
  std::vector<std::vector<Input>> inputs;
  for (int tick = 0; tick < ticks; ++tick) {
    const auto next = session.presses.next();
    inputs.emplace_back(next.begin(), next.end());
  }
  const Game confirmed = session.game;
  Game predicted = confirmed;
  const auto replay = [&] {
    predicted = confirmed;
    for (const auto& tick : inputs) predicted.advance(tick);
  };
  const std::int64_t times = std::max<std::int64_t>(1, 50 / effort.divisor);
  const auto spreads = interleaved({[&] { return averageOf(times, replay) / 1000; }}, effort.passes);
  return {sim::testName(path), players, ticks, spreads[0]};
}

AdvanceResult benchAdvance(const std::string& path, const Effort& effort) {
  constexpr std::size_t kPlayers = 8;
  const int ticks = static_cast<int>(6000 / effort.divisor);
  const auto level = sim::levelFrom(path);
  const auto pass = [&] {
    Session session(level, kPlayers);
    return nanosecondsOf([&] { session.play(ticks); }) / ticks / static_cast<double>(kPlayers);
  };
  return {sim::testName(path), kPlayers, interleaved({pass}, effort.passes)[0]};
}

DerivedResult derivedAmongSegments() {
  constexpr std::size_t kSegments = 10000;
  constexpr int kHalfSeconds = 20;
  const Scene scene = randomScenes().make(kSegments, kManyBodies);
  auto made = std::make_unique<PlatonEngine>(scene);
  World& world = made->world();
  StepRunner runner(randomScenes(), std::move(made), scene);
  for (int i = 0; i < kHalfSeconds; ++i) runner.runOneVelocity();
  return {"10 000 random segments", kManyBodies, derivedBytes(world) / kManyBodies};
}

DerivedResult derivedOnLevel(const std::string& path) {
  Session session(sim::levelFrom(path), kManyBodies);
  return {sim::testName(path), kManyBodies, derivedBytes(session.game) / kManyBodies};
}

}  // namespace

GameResults benchGames(const Effort& effort) {
  const auto paths = shippedLevels();
  GameResults results;
  for (const std::string& path : paths) results.advances.push_back(benchAdvance(path, effort));
  const auto slowest = std::max_element(
      results.advances.begin(), results.advances.end(),
      [](const auto& a, const auto& b) { return a.nsPerPlayerTick.median < b.nsPerPlayerTick.median; });
  const std::string& path = paths[static_cast<std::size_t>(slowest - results.advances.begin())];
  results.snapshots.push_back(benchSnapshot(path, effort));
  results.derived.push_back(derivedAmongSegments());
  for (const std::string& level : paths) results.derived.push_back(derivedOnLevel(level));
  results.resimulations.push_back(benchResimulation(path, 16, 15, effort));
  results.resimulations.push_back(benchResimulation(path, 64, 60, effort));
  return results;
}

}  // namespace platon::bench
