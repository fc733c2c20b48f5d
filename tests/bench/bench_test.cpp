// Runs the benchmark with little work and checks the results that do not depend on time.
#include <algorithm>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <gmock/gmock.h>

#include "tests/bench/engines/engine.h"
#include "tests/bench/report.h"
#include "tests/exactness/oracle/trace/json_reader.h"

namespace platon::bench::bench_test {
namespace {

using testing::IsSupersetOf;
using testing::UnorderedElementsAre;

// The report is shared by all tests.
const Report& smallReport() {
  static const Report report = runAll({.passes = 1, .divisor = 25, .maxSegments = 1000}, [](const char*) {});
  return report;
}

template <class Result>
auto namesOf(const std::vector<Result>& results, std::string Result::*name) {
  std::set<std::string> names;
  for (const Result& result : results) names.insert(result.*name);
  return names;
}

TEST(Bench, EveryTableHasItsEngines) {
  const Report& report = smallReport();
  const auto all = UnorderedElementsAre("platon", "float32", "float64", "box2d-2.4", "chipmunk-7.0");
  EXPECT_THAT(namesOf(report.steps, &StepResult::engine),
              UnorderedElementsAre("platon", kComputed, "float32", "float64", "box2d-2.4", "chipmunk-7.0"));
  EXPECT_THAT(namesOf(report.steps, &StepResult::scenes), UnorderedElementsAre("random", "platformer"));
  EXPECT_THAT(namesOf(report.trajectories.errors, &TrajectoryResult::engine),
              UnorderedElementsAre("platon", kIdealPlace, "float32", "float64", "box2d-2.4", "chipmunk-7.0"));
  EXPECT_THAT(namesOf(report.hardCases, &HardResult::engine), all);
  EXPECT_THAT(namesOf(report.sweeps, &SweepResult::engine),
              UnorderedElementsAre("platon", "float32", "float64", "box2d-2.4"));
  EXPECT_THAT(namesOf(report.resolutions, &ResolutionResult::engine),
              UnorderedElementsAre("platon", kIdealPlace, "float32", "float64"));
}

TEST(Bench, PlatonAnswersEverySweepExactly) {
  for (const SweepResult& r : smallReport().sweeps) {
    if (r.engine != "platon") continue;
    EXPECT_EQ(r.missed, 0u) << r.set;
    EXPECT_EQ(r.falseHits, 0u) << r.set;
    EXPECT_EQ(r.maxTimeError, 0) << r.set;
    EXPECT_EQ(r.maxOverlap, 0) << r.set;
  }
}

TEST(Bench, PlatonNeitherOverlapsNorTunnelsInHardCases) {
  for (const HardResult& r : smallReport().hardCases) {
    if (r.engine != "platon") continue;
    EXPECT_EQ(r.maxOverlap, 0) << r.name;
    EXPECT_EQ(r.tunnelled, 0) << r.name;
    EXPECT_EQ(r.restDrift, 0) << r.name;
  }
}

TEST(Bench, SomeEngineOverlapsInEveryHardCase) {
  std::map<std::string, double> deepest;
  for (const HardResult& r : smallReport().hardCases) deepest[r.name] = std::max(deepest[r.name], r.maxOverlap);
  ASSERT_EQ(deepest.size(), 7u);
  for (const auto& [name, overlap] : deepest) EXPECT_GT(overlap, 10) << name;
}

TEST(Bench, EverySetHasHitsAndMisses) {
  ASSERT_FALSE(smallReport().sweeps.empty());
  for (const SweepResult& r : smallReport().sweeps) {
    EXPECT_GT(r.hits * 8, r.queries) << r.set;
    EXPECT_LT(r.hits * 5, r.queries * 4) << r.set;
  }
}

TEST(Bench, DoublesFailOnSlivers) {
  const auto& sweeps = smallReport().sweeps;
  const auto slivers = std::find_if(sweeps.begin(), sweeps.end(),
                                    [](const SweepResult& r) { return r.set == "slivers" && r.engine == "float64"; });
  ASSERT_NE(slivers, sweeps.end());
  EXPECT_GT(slivers->missed, 0u);
  EXPECT_GT(slivers->falseHits, 0u);
}

TEST(Bench, ErrorsShrinkWithTheResolution) {
  std::map<std::int64_t, double> errors;
  for (const ResolutionResult& r : smallReport().resolutions) {
    if (r.engine == "platon") errors[r.subunitsPerUnit] = r.maxTrajectoryError;
  }
  ASSERT_EQ(errors.size(), 13u);  // 2^4 ... 2^16
  EXPECT_LT(errors.rbegin()->second * 1000, errors.begin()->second);
}

// I8, on the scenes and the terrains of the report.
TEST(Bench, PlatonFollowsTheIdealPath) {
  constexpr double kTwoSubunits = 2.0 / 1024;
  std::map<std::pair<std::string, std::int64_t>, double> float64;
  for (const TrajectoryResult& r : smallReport().trajectories.errors) {
    if (r.engine == "float64") float64[{r.scene, r.ticks}] = r.maxError;
  }
  EXPECT_GT(float64.size(), 20u);
  for (const TrajectoryResult& r : smallReport().trajectories.errors) {
    if (r.engine == "platon") {
      EXPECT_LE(r.maxError, kTwoSubunits) << r.scene << " after " << r.ticks;
    } else if (r.engine == kIdealPlace) {
      EXPECT_LE(r.maxError, std::max(1e-6, float64.at({r.scene, r.ticks}))) << r.scene << " after " << r.ticks;
    }
  }
}

TEST(Bench, TrajectoriesCountWhatTheyMeasure) {
  const TrajectoryResults& results = smallReport().trajectories;
  std::set<std::string> names = namesOf(results.errors, &TrajectoryResult::scene);
  EXPECT_EQ(names.size(), static_cast<std::size_t>(results.scenes + results.terrains));
  EXPECT_GE(results.scenes + results.dividedTies + results.jointTies, 7);
  EXPECT_GE(results.terrains, 6);
}

TEST(Bench, PlatonJamsInNoRow) {
  for (const StepResult& r : smallReport().steps) {
    EXPECT_GT(r.jams.halfSeconds, 0u) << r.scenes << " " << r.segments;
    if (r.engine != "platon") continue;
    EXPECT_EQ(r.jams.jammed, 0u) << r.scenes << " " << r.segments << " " << r.bodies;
  }
}

TEST(Bench, StateAndSegmentsAreSmall) {
  const Report& report = smallReport();
  EXPECT_LT(report.games.snapshots.at(0).bytes, 8192u);
  for (const StepResult& r : report.steps) {
    if (r.engine != "platon") continue;
    EXPECT_LE(r.bytesPerSegment, 64) << r.segments;
  }
}

// The members of one object, or of each object of a list.
std::set<std::string> membersOf(oracle::JsonReader& json, bool isList) {
  std::set<std::string> members;
  const auto value = [&](std::string_view name) {
    const bool isWord = name == "set" || name == "engine" || name == "case" || name == "scene" || name == "scenes" ||
                        name == "level" || name == "compiler" || name == "flags";
    isWord ? void(json.string()) : void(json.number());
    members.emplace(name);
  };
  isList ? json.array([&] { json.object(value); }) : json.object(value);
  return members;
}

TEST(Bench, JsonHasTheMembersThatTheReportNeeds) {
  std::string text = toJson(smallReport());
  std::replace(text.begin(), text.end(), '\n', ' ');
  oracle::JsonReader json(text);
  std::map<std::string, std::set<std::string>> parts;
  json.object([&](std::string_view name) {
    const bool isObject = name == "snapshot" || name == "build" || name == "trajectoryScenes";
    parts.emplace(name, membersOf(json, !isObject));
  });
  json.end();
  EXPECT_THAT(parts["sweep"],
              IsSupersetOf({"set", "engine", "nsPerQuery", "missed", "false", "maxTimeError", "maxOverlap"}));
  EXPECT_THAT(parts["step"], IsSupersetOf({"scenes", "engine", "segments", "movers", "nsPerStep", "bytesPerSegment",
                                           "bytesPerMover", "jammed", "halfSeconds"}));
  EXPECT_THAT(parts["trajectory"], IsSupersetOf({"scene", "engine", "ticks", "maxError"}));
  EXPECT_THAT(parts["trajectoryScenes"],
              IsSupersetOf({"sceneFiles", "terrains", "dividedTies", "jointTies", "leftContact"}));
  EXPECT_THAT(parts["parts"], IsSupersetOf({"scene", "nsPerStep", "allocationsPerStep"}));
  EXPECT_THAT(parts["derived"], IsSupersetOf({"scene", "movers", "bytesPerMover"}));
  EXPECT_THAT(parts["hardCases"],
              IsSupersetOf({"case", "engine", "steps", "maxOverlap", "tunnelled", "speedDrops", "pops", "restDrift"}));
  EXPECT_THAT(parts["resolution"], IsSupersetOf({"engine", "subunitsPerUnit", "nsPerStep", "maxTrajectoryError"}));
  EXPECT_THAT(parts["snapshot"], IsSupersetOf({"movers", "bytes", "saveNs", "restoreNs", "hashNs", "gameHashNs"}));
  EXPECT_THAT(parts["resimulation"], IsSupersetOf({"players", "ticks", "microseconds"}));
}

}  // namespace
}  // namespace platon::bench::bench_test
