// platon-reference: measures the distance of the simulated body from the ideal one, for every scene of the reference or
// on random terrains.
#include <array>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <fstream>
#include <optional>
#include <stdexcept>
#include <string>

#include "protocol/program_error.h"
#include "protocol/program_options.h"
#include "tests/exactness/reference/lattice_error.h"
#include "tests/exactness/reference/solid_walk.h"
#include "tests/exactness/reference/terrain.h"
#include "tests/exactness/reference/terrain_judge.h"
#include "tests/exactness/reference/terrain_table.h"

namespace {

using namespace platon::reference;

constexpr auto kResolutions = std::to_array<std::int64_t>({1 << 4, 1 << 6, 1 << 8, 1 << 10, 1 << 12, 1 << 14, 1 << 16});
constexpr auto kTicks = std::to_array<std::int64_t>({1, 60, 3600});

struct Options {
  bool json = false;
  bool rows = false;
  bool slow = false;
  std::int64_t terrains = 0;
  std::int64_t walks = 0;
  std::uint64_t seed = 1;
  std::optional<std::uint64_t> sceneSeed;
  std::int64_t ticks = 1200;
  std::string sceneFile;
};

void print(const LatticeError& error, bool json, bool first) {
  const char* layout = json ? "{\"scene\":\"%s\",\"subunitsPerUnit\":%lld,\"ticks\":%lld,\"legs\":%lld,"
                              "\"errorSubunits\":%.3f,\"maxErrorSubunits\":%.3f,\"errorUnits\":%.6g}"
                            : "%-12s %6lld %6lld %7lld %10.2f %10.2f %12.3g\n";
  if (json && !first) std::printf(",\n");
  std::printf(layout, error.scene.c_str(), static_cast<long long>(error.subunitsPerUnit),
              static_cast<long long>(error.ticks), static_cast<long long>(error.legs), error.subunits,
              error.maxSubunits, error.units());
}

void printAll(bool json) {
  std::printf(json ? "{\"trajectories\":[" : "%-12s %6s %6s %7s %10s %10s %12s\n", "scene", "per u", "ticks", "legs",
              "subunits", "max", "units");
  bool first = true;
  for (const auto& [name, scene] : allScenes()) {
    for (const LatticeError& error : latticeErrors(name, scene, kResolutions, kTicks)) {
      print(error, json, first);
      first = false;
    }
  }
  if (json) std::printf("]}\n");
}

int judgeSlowScenes(std::int64_t ticks) {
  bool holds = true;
  std::printf("%-12s %9s %12s %14s\n", "scene", "rests at", "max lattice", "max precise");
  for (const auto& [name, scene] : allSlowScenes()) {
    const Verdict verdict = judge(scene, ticks);
    holds &= verdict.holds() && verdict.judgedTicks == ticks;
    std::printf("%-12s %9.1f %12.3f %14.9f\n", name.c_str(), verdict.restsAt.value_or(-1), verdict.maxLattice,
                verdict.maxPrecise);
  }
  return holds ? 0 : 1;
}

void writeScene(const std::string& path, std::uint64_t seed, std::int64_t ticks) {
  std::ofstream file(path);
  file << "# terrain " << seed << " for " << ticks << " ticks\n" << toText(randomTerrain(seed, ticks).scene);
  if (!file.flush()) throw std::runtime_error(path + ": cannot be written");
}

int runTerrains(const Options& options) {
  TerrainTable table(options.ticks, options.rows || options.sceneSeed ? stdout : nullptr);
  if (options.sceneSeed) {
    table.add(*options.sceneSeed);
    if (!options.sceneFile.empty()) writeScene(options.sceneFile, *options.sceneSeed, options.ticks);
  } else {
    table.run(options.seed, options.terrains);
  }
  table.printSummary(stdout);
  return table.holds() ? 0 : 1;
}

void addOptions(platon::ProgramOptions& program, Options& options) {
  auto json = program.addFlag("--json", options.json, "print one JSON object");
  auto terrains = program.add("--terrains", options.terrains, "judge this many random terrains instead");
  auto walks = program.add("--walks", options.walks, "judge this many walks on every solid, in two ways each");
  auto seed = program.add("--seed", options.seed, "seed of the first terrain or walk; the next ones ascend");
  auto scene = program.add("--scene-seed", options.sceneSeed, "judge only the terrain with this seed");
  program.add("--ticks", options.ticks, "ticks of every terrain, slow scene or walk").range(101, 1000000);
  auto slow = program.addFlag("--slow", options.slow, "judge every scene at a tenth of its speed");
  program.addFlag("--rows", options.rows, "print a row for each terrain");
  auto write = program.add("--write", options.sceneFile, "write that terrain to this scene file");
  terrains.range(1, 1000000).excludes(json).excludes(scene);
  slow.excludes(json).excludes(terrains).excludes(scene);
  walks.range(1, 1000000).excludes(json).excludes(terrains).excludes(scene).excludes(slow);
  seed.excludes(json).excludes(slow).excludes(scene);
  scene.excludes(json);
  write.needs(scene);
}

}  // namespace

int main(int count, char** arguments) {
  Options options;
  platon::ProgramOptions program("platon-reference",
                                 "platon-reference: measures the distance of the simulated body from the ideal one.");
  addOptions(program, options);
  try {
    if (!program.read(count, arguments)) return 0;
    if (options.terrains > 0 || options.sceneSeed) return runTerrains(options);
    if (options.walks > 0) return judgeWalks(options.seed, options.walks, options.ticks, stdout) ? 0 : 1;
    if (options.slow) return judgeSlowScenes(options.ticks);
    printAll(options.json);
    return 0;
  } catch (const platon::ProgramError& error) {
    std::fprintf(stderr, "platon-reference: %s\n", error.what());
    return error.exitCode();
  } catch (const std::exception& error) {
    std::fprintf(stderr, "platon-reference: %s\n", error.what());
    return 1;
  }
}
