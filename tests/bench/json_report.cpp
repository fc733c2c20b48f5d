#include <cstdio>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "protocol/texts.h"
#include "tests/bench/report.h"

namespace platon::bench {
namespace {

/// Builds one JSON object, member by member.
class JsonObject {
 public:
  JsonObject& add(std::string_view name, const std::string& text) { return raw(name, jsonText(text)); }
  JsonObject& add(std::string_view name, double value) {
    char digits[32];
    std::snprintf(digits, sizeof digits, "%.6g", value);
    return raw(name, digits);
  }
  template <class Integer>
  requires std::is_integral_v<Integer> JsonObject& add(std::string_view name, Integer value) {
    return raw(name, std::to_string(value));
  }
  /// Adds the median as NAME and the ends of the spread as NAMELow and NAMEHigh.
  JsonObject& add(std::string_view name, const Spread& spread) {
    add(name, spread.median);
    add(std::string(name) + "Low", spread.low);
    return add(std::string(name) + "High", spread.high);
  }
  JsonObject& raw(std::string_view name, std::string_view json) {
    text_ += text_.empty() ? "{" : ",";
    text_ += jsonText(name) + ":" + std::string(json);
    return *this;
  }
  std::string text() const { return (text_.empty() ? "{" : text_) + "}"; }

 private:
  std::string text_;
};

JsonObject objectOf(const SweepResult& result) {
  return JsonObject()
      .add("set", result.set)
      .add("engine", result.engine)
      .add("nsPerQuery", result.nsPerQuery)
      .add("questions", result.queries)
      .add("meetings", result.hits)
      .add("missed", result.missed)
      .add("false", result.falseHits)
      .add("maxTimeError", result.maxTimeError)
      .add("maxOverlap", result.maxOverlap);
}

JsonObject objectOf(const StepResult& result) {
  return JsonObject()
      .add("scenes", result.scenes)
      .add("engine", result.engine)
      .add("segments", result.segments)
      .add("movers", result.bodies)
      .add("nsPerStep", result.nsPerStep)
      .add("bytesPerSegment", result.bytesPerSegment)
      .add("bytesPerMover", result.bytesPerBody)
      .add("jammed", result.jams.jammed)
      .add("halfSeconds", result.jams.halfSeconds);
}

JsonObject objectOf(const HardResult& result) {
  return JsonObject()
      .add("case", result.name)
      .add("engine", result.engine)
      .add("steps", result.steps)
      .add("maxOverlap", result.maxOverlap)
      .add("tunnelled", result.tunnelled)
      .add("speedDrops", result.speedDrops)
      .add("pops", result.pops)
      .add("restDrift", result.restDrift)
      .add("restGap", result.restGap);
}

JsonObject objectOf(const ResolutionResult& result) {
  return JsonObject()
      .add("engine", result.engine)
      .add("subunitsPerUnit", result.subunitsPerUnit)
      .add("nsPerStep", result.nsPerStep)
      .add("maxTrajectoryError", result.maxTrajectoryError);
}

JsonObject objectOf(const TrajectoryResult& result) {
  return JsonObject()
      .add("scene", result.scene)
      .add("engine", result.engine)
      .add("ticks", result.ticks)
      .add("maxError", result.maxError);
}

JsonObject scenesOf(const TrajectoryResults& results) {
  return JsonObject()
      .add("sceneFiles", results.scenes)
      .add("terrains", results.terrains)
      .add("dividedTies", results.dividedTies)
      .add("jointTies", results.jointTies)
      .add("leftContact", results.leftContact);
}

JsonObject objectOf(const DerivedResult& result) {
  return JsonObject().add("scene", result.scene).add("movers", result.bodies).add("bytesPerMover", result.bytesPerBody);
}

JsonObject objectOf(const PartResult& result) {
  return JsonObject()
      .add("scene", result.scene)
      .add("instances", result.instances)
      .add("crossingsPerStep", result.crossings)
      .add("allocationsPerStep", result.allocations)
      .add("nsPerStep", result.nsPerStep);
}

JsonObject objectOf(const SnapshotResult& result) {
  return JsonObject()
      .add("level", result.level)
      .add("movers", result.bodies)
      .add("bytes", result.bytes)
      .add("saveNs", result.saveNs)
      .add("restoreNs", result.restoreNs)
      .add("hashNs", result.hashNs)
      .add("gameHashNs", result.gameHashNs);
}

JsonObject objectOf(const ResimulationResult& result) {
  return JsonObject()
      .add("level", result.level)
      .add("players", result.players)
      .add("ticks", result.ticks)
      .add("microseconds", result.microseconds);
}

JsonObject objectOf(const AdvanceResult& result) {
  return JsonObject()
      .add("level", result.level)
      .add("players", result.players)
      .add("nsPerPlayerTick", result.nsPerPlayerTick);
}

// How the program was built, for the generated report.
JsonObject buildObject(int passes) {
#if defined(__AVX2__)
  const std::string machine = " for x86-64-v3";
#elif defined(__SSE4_2__)
  const std::string machine = " for x86-64-v2";
#else
  const std::string machine;
#endif
  return JsonObject()
      .add("compiler", std::string(PLATON_COMPILER))
      .add("flags", PLATON_FLAGS + machine)
      .add("passes", passes);
}

template <class Result>
std::string listOf(const std::vector<Result>& results) {
  std::string text = "[";
  for (const Result& result : results) text += (text.size() > 1 ? ",\n" : "\n") + objectOf(result).text();
  return text + "]";
}

}  // namespace

std::string toJson(const Report& report) {
  return JsonObject()
      .raw("build", buildObject(report.passes).text())
      .raw("sweep", listOf(report.sweeps))
      .raw("step", listOf(report.steps))
      .raw("hardCases", listOf(report.hardCases))
      .raw("resolution", listOf(report.resolutions))
      .raw("trajectory", listOf(report.trajectories.errors))
      .raw("trajectoryScenes", scenesOf(report.trajectories).text())
      .raw("parts", listOf(report.parts))
      .raw("snapshot", objectOf(report.games.snapshots.front()).text())
      .raw("derived", listOf(report.games.derived))
      .raw("resimulation", listOf(report.games.resimulations))
      .raw("advance", listOf(report.games.advances))
      .text();
}

}  // namespace platon::bench
