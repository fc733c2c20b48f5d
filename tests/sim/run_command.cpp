#include <chrono>
#include <cstdio>
#include <functional>
#include <memory>
#include <optional>
#include <span>

#include "platon/game/game.h"
#include "platon/physics/entity.h"
#include "platon/physics/map_part.h"
#include "protocol/texts.h"
#include "shared/game/element_rules.h"
#include "tests/sim/button_presses.h"
#include "tests/sim/churn.h"
#include "tests/sim/commands.h"
#include "tests/sim/files.h"
#include "tests/sim/recording_file.h"
#include "tests/sim/scene_file.h"
#include "tests/sim/seeded_random.h"
#include "tests/sim/sim_options.h"
#include "tests/sim/trace_writer.h"

namespace platon::sim {
namespace {

constexpr std::int64_t kMaxTicks = 1'000'000'000'000;

std::string readText(const std::string& path) {
  const auto bytes = readBytes(path, kMaxLevelBytes + 1);
  return {bytes.begin(), bytes.end()};
}

std::shared_ptr<const Level> readLevel(const std::string& path) {
  LevelResult result = loadLevel(readText(path));
  for (const Diagnostic& found : result.diagnostics) std::fprintf(stderr, "%s\n", format(path, found).c_str());
  if (!result.level) throw InputError("");
  return result.level;
}

struct Summary {
  std::uint64_t hash = 0;
  std::uint64_t crossings = 0;
  std::uint64_t goals = 0;
  double nanoseconds = 0;  // per entity and tick
};

std::uint64_t crossingsOf(const World& world) {
  std::uint64_t sum = 0;
  for (const EntityState& entity : world.entities()) sum += entity.crossings;
  return sum;
}

// Calls `tick` `ticks` times and measures it. After each, calls `ticked` with the number of ticks so far, not measured.
Summary drive(std::int64_t ticks, std::size_t entities, const std::function<void()>& tick,
              const std::function<void(std::uint64_t)>& ticked) {
  std::chrono::steady_clock::duration spent{};
  for (std::int64_t i = 1; i <= ticks; ++i) {
    const auto start = std::chrono::steady_clock::now();
    tick();
    spent += std::chrono::steady_clock::now() - start;
    ticked(static_cast<std::uint64_t>(i));
  }
  Summary summary;
  const auto steps = static_cast<double>(ticks) * static_cast<double>(entities);
  if (steps > 0) summary.nanoseconds = std::chrono::duration<double, std::nano>(spent).count() / steps;
  return summary;
}

struct Run {
  std::shared_ptr<const Level> level;
  std::uint32_t players;
  std::int64_t ticks;
  std::uint64_t seed;
  TraceWriter* trace;
  RecordingFile* recording;
};

// Plays a game. `nextInputs` returns the inputs of the next tick.
Summary play(const Run& run, const std::function<std::span<const Input>()>& nextInputs) {
  Game game(run.level);
  std::span<const Input> inputs;
  OpenElements open;
  const auto tick = [&] {
    open = game.open();
    game.advance(inputs = nextInputs(), run.trace);
  };
  const auto ticked = [&](std::uint64_t number) {
    if (run.trace != nullptr) run.trace->tick(number, game.hash(), open);
    run.recording->tick(inputs, game);
  };
  run.recording->start(game);
  Summary summary = drive(run.ticks, run.players, tick, ticked);
  run.recording->finish(game);
  summary.hash = game.hash();
  summary.crossings = crossingsOf(game.world());
  for (std::uint32_t slot = 0; slot < game.slots(); ++slot) summary.goals += game.player(slot).finished() ? 1 : 0;
  return summary;
}

Summary playPresses(const Run& run) {
  std::vector<ButtonPresses> presses;
  for (std::uint32_t slot = 0; slot < run.players; ++slot) presses.emplace_back(run.seed, slot);
  std::vector<Input> inputs(run.players);
  return play(run, [&] {
    for (std::uint32_t slot = 0; slot < run.players; ++slot) inputs[slot] = presses[slot].next();
    return std::span<const Input>(inputs);
  });
}

Summary playChurn(const Run& run) {
  Churn churn(run.seed, run.players);
  return play(run, [&] { return std::span(churn.next()); });
}

// Runs the physics without the game rules. Calls `setVelocity` for every entity before each tick, and `solve` with the
// number of ticks before it.
Summary move(World& world, std::int64_t ticks, TraceWriter* trace, const std::function<void(Entity&)>& setVelocity,
             const std::function<void(std::uint32_t)>& solve) {
  const auto count = static_cast<std::uint32_t>(world.entities().size());
  std::uint32_t before = 0;
  const auto tick = [&] {
    for (std::uint32_t i = 0; i < count; ++i) {
      Entity entity(world, i);
      setVelocity(entity);
    }
    solve(before++);
  };
  const auto ticked = [&](std::uint64_t number) {
    if (trace != nullptr) trace->tick(number, world.hash(), {0, static_cast<std::uint32_t>(number - 1)});
  };
  Summary summary = drive(ticks, count, tick, ticked);
  summary.hash = world.hash();
  summary.crossings = crossingsOf(world);
  return summary;
}

// Elements block as in a game, but nothing happens to who touches them. All doors are closed.
Summary runWithoutRules(const Run& run, const std::function<void(Entity&)>& setVelocity) {
  World world = run.level->world;
  ElementRules first(*run.level, {});
  world.setRules(first);
  for (std::uint32_t slot = 0; slot < run.players; ++slot) {
    Entity entity(world, playerShape());
    MapPart(world, run.level->startFace).insert(entity, run.level->start, run.level->startAngle);
  }
  return move(world, run.ticks, run.trace, setVelocity, [&](std::uint32_t tick) {
    ElementRules rules(*run.level, {0, tick});
    world.solve(rules, run.trace);
  });
}

Point velocityOption(const Options& options) {
  const std::string text = options.text("velocity", "");
  const std::size_t comma = text.find(',');
  const auto x = wholeNumber(std::string_view(text).substr(0, comma), -kVelocityLimit + 1, kVelocityLimit - 1);
  const auto y = comma == std::string::npos
                     ? std::nullopt
                     : wholeNumber(std::string_view(text).substr(comma + 1), -kVelocityLimit + 1, kVelocityLimit - 1);
  if (x && y) return {static_cast<std::int32_t>(*x), static_cast<std::int32_t>(*y)};
  throw UsageError("--drive push needs --velocity VX,VY: integers below 2^28 in magnitude, in subunits per tick");
}

Summary dispatch(const Run& run, const Options& options) {
  const std::string drive = options.text("drive", "play");
  const auto maxSpeed = static_cast<std::int32_t>(options.number("max-speed", 8192, 0, kVelocityLimit - 1));
  if (drive == "play") return playPresses(run);
  if (drive == "churn") return playChurn(run);
  if (run.recording->enabled()) throw UsageError("--record works only with --drive play or churn");
  if (drive == "fling") {
    SeededRandom random(run.seed);
    return runWithoutRules(run, [&](Entity& entity) { entity.setVelocity(random.vector(maxSpeed)); });
  }
  if (drive == "push") {
    const Point velocity = velocityOption(options);
    return runWithoutRules(run, [&](Entity& entity) { entity.setVelocity(rotate(velocity, entity.rotation())); });
  }
  throw UsageError("--drive must be play, churn, fling or push, not '" + drive + "'");
}

std::unique_ptr<TraceWriter> openTrace(const Options& options) {
  return options.has("trace") ? std::make_unique<TraceWriter>(options.text("trace", "")) : nullptr;
}

}  // namespace

int runCommand(const std::vector<std::string>& arguments) {
  const Options options(
      arguments, {"players", "ticks", "seed", "drive", "max-speed", "velocity", "trace", "record", "checkpoint-every"},
      {"json"});
  const std::string& path = options.onlyPositional("platon-sim run takes one level file: platon-sim run LEVEL");
  const auto trace = openTrace(options);
  RecordingFile recording(options);
  Run run{.level = nullptr,
          .players = static_cast<std::uint32_t>(options.number("players", 1, 1, kMaxPlayers)),
          .ticks = options.number("ticks", 3600, 0, kMaxTicks),
          .seed = options.seed(),
          .trace = trace.get(),
          .recording = &recording};
  run.level = readLevel(path);
  if (trace) trace->header(run.level->world, playerShape(), run.level.get());
  const Summary summary = dispatch(run, options);
  if (trace) trace->close();
  const char* layout = options.has("json")
                           ? "{\"level\":%s,\"players\":%u,\"ticks\":%lld,\"seed\":%llu,\"hash\":\"%016llx\","
                             "\"crossings\":%llu,\"goals\":%llu,\"nsPerPlayerTick\":%.1f}\n"
                           : "level %s\nplayers %u\nticks %lld\nseed %llu\nhash %016llx\ncrossings %llu\ngoals %llu\n"
                             "%.1f ns per player and tick\n";
  std::printf(layout, (options.has("json") ? jsonText(path) : path).c_str(), run.players,
              static_cast<long long>(run.ticks), static_cast<unsigned long long>(run.seed),
              static_cast<unsigned long long>(summary.hash), static_cast<unsigned long long>(summary.crossings),
              static_cast<unsigned long long>(summary.goals), summary.nanoseconds);
  return 0;
}

int worldCommand(const std::vector<std::string>& arguments) {
  const Options options(arguments, {"ticks", "seed", "max-speed", "trace"}, {"json"});
  const std::string& path =
      options.onlyPositional("platon-sim world takes one scene file: platon-sim world SCENE --ticks T");
  const auto ticks = options.number("ticks", 3600, 0, kMaxTicks);
  const auto maxSpeed = static_cast<std::int32_t>(options.number("max-speed", 0, 0, kVelocityLimit - 1));
  const auto trace = openTrace(options);
  Scene scene = loadScene(path, readText(path));
  if (trace) trace->header(scene.world, scene.shape, nullptr);
  SeededRandom random(options.seed());
  const auto setVelocity = [&](Entity& entity) {
    entity.setVelocity(options.has("max-speed") ? random.vector(maxSpeed) : scene.velocity);
  };
  const Summary summary =
      move(scene.world, ticks, trace.get(), setVelocity, [&](std::uint32_t) { scene.world.solve(trace.get()); });
  if (trace) trace->close();
  const char* layout = options.has("json") ? "{\"scene\":%s,\"entities\":%zu,\"ticks\":%lld,\"hash\":\"%016llx\","
                                             "\"nsPerEntityTick\":%.1f}\n"
                                           : "scene %s\nentities %zu\nticks %lld\nhash %016llx\n"
                                             "%.1f ns per entity and tick\n";
  std::printf(layout, (options.has("json") ? jsonText(path) : path).c_str(), scene.world.entities().size(),
              static_cast<long long>(ticks), static_cast<unsigned long long>(summary.hash), summary.nanoseconds);
  return 0;
}

}  // namespace platon::sim
