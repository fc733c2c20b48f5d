#include "levels/tool/solve_command.h"

#include <cstdio>
#include <fstream>
#include <iterator>
#include <memory>
#include <utility>
#include <vector>

#include "levels/reach/reach.h"
#include "levels/solve/level_solver.h"
#include "levels/solve/recorded_way.h"
#include "levels/tool/exit_code.h"
#include "levels/tool/json_text.h"
#include "levels/tool/level_file.h"

namespace platon {
namespace {

bool write(const std::string& file, const std::vector<std::uint8_t>& bytes) {
  std::ofstream out(file, std::ios::binary);
  out.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  out.close();
  if (!out) std::fprintf(stderr, "platon-level: cannot write '%s'\n", file.c_str());
  return !out.fail();
}

// "key 1, plate 2": the elements that the solution uses.
std::string elementsText(const Level& level, const SolutionFacts& facts, bool json) {
  std::string text;
  for (const std::uint32_t index : facts.elements) {
    const Element& element = level.elements[index];
    std::string name(wordOf(element.kind));
    if (hasNumber(element.kind)) name += " " + std::to_string(element.number);
    text += (text.empty() ? "" : json ? "," : ", ") + (json ? jsonText(name) : name);
  }
  return text;
}

void printFacts(const Level& level, const SolutionFacts& facts) {
  std::printf("solved in %.2f s: %u presses, %u crossings, %u turns of down", facts.ticks / 60.0, facts.presses,
              facts.crossings, facts.turns);
  if (facts.slack) std::printf(", tightest jump %d ticks", *facts.slack);
  const std::string elements = elementsText(level, facts, false);
  if (!elements.empty()) std::printf("; uses %s", elements.c_str());
  std::printf("; difficulty %d", difficultyOf(facts));
}

void printFactsJson(const Level& level, const SolutionFacts& facts) {
  const std::string slack = facts.slack ? std::to_string(*facts.slack) : "null";
  std::printf(
      "{\"solved\":true,\"ticks\":%u,\"presses\":%u,\"crossings\":%u,\"turns\":%u,\"slack\":%s,\"elements\":[%s],"
      "\"difficulty\":%d",
      facts.ticks, facts.presses, facts.crossings, facts.turns, slack.c_str(), elementsText(level, facts, true).c_str(),
      difficultyOf(facts));
}

int search(const std::shared_ptr<const Level>& level, const SolveOptions& options) {
  LevelSolver solver(level);
  LevelSolver::Limits limits;
  limits.pressCost = options.pressCost;
  const auto solution = solver.solve(limits);
  if (!solution) {
    if (options.json) std::printf("{\"solved\":false,\"states\":%zu}\n", solver.states());
    std::fprintf(stderr, "platon-level: no way to the goal found after %zu states\n", solver.states());
    return kFailed;
  }
  const SolutionFacts facts = factsOf(level, *solution).value();
  if (options.json) {
    printFactsJson(*level, facts);
    std::printf(",\"states\":%zu}\n", solver.states());
  } else {
    printFacts(*level, facts);
    std::printf(" (%zu states searched)\n", solver.states());
  }
  return options.recording.empty() || write(options.recording, recordWay(level, *solution)) ? 0 : kFailed;
}

// Tells about a recorded way, if it is one of this level.
int tell(const std::shared_ptr<const Level>& level, const SolveOptions& options) {
  std::ifstream in(options.recorded, std::ios::binary);
  const std::vector<std::uint8_t> bytes(std::istreambuf_iterator<char>(in), {});
  if (!in) {
    std::fprintf(stderr, "platon-level: cannot read '%s'\n", options.recorded.c_str());
    return kUsage;
  }
  const RecordedWay way = readRecordedWay(bytes);
  if (!way.fault.empty()) {
    std::fprintf(stderr, "%s: error: %s\n", options.recorded.c_str(), way.fault.c_str());
    return kInvalidLevel;
  }
  const bool isOfLevel =
      way.level->hash == level->hash && !way.inputs.empty() && way.inputs.front().size() >= level->players;
  const auto facts = isOfLevel ? factsOf(level, way.inputs) : std::nullopt;
  if (!facts) {
    std::fprintf(stderr, "platon-level: '%s' is no way to the goal of '%s' as it is now; record a new one with -o\n",
                 options.recorded.c_str(), options.file.c_str());
    return kFailed;
  }
  options.json ? printFactsJson(*level, *facts) : printFacts(*level, *facts);
  std::printf(options.json ? "}\n" : "\n");
  return 0;
}

// Proves that no way has fewer crossings, or shows one, or says that it can do neither.
int prove(const std::shared_ptr<const Level>& level, const SolveOptions& options) {
  const int crossings = *options.withoutCrossing;
  const bool proved = crossings == 0 || !Reach(*level, crossings - 1).crossingsToGoal();
  if (options.json) std::printf("{\"withoutCrossing\":%d,\"proved\":%s}\n", crossings, proved ? "true" : "false");
  if (proved) {
    if (!options.json) std::printf("proved: every way to the goal has %d crossings or more\n", crossings);
    return 0;
  }
  LevelSolver solver(level);
  LevelSolver::Limits limits;
  limits.crossings = static_cast<std::uint32_t>(crossings - 1);
  const auto way = solver.solve(limits);
  const auto facts = way ? factsOf(level, *way) : std::nullopt;
  if (facts) {
    std::fprintf(stderr, "platon-level: a way has %u crossings\n", facts->crossings);
    if (!options.recording.empty() && !write(options.recording, recordWay(level, *way))) return kFailed;
  } else {
    std::fprintf(stderr,
                 "platon-level: not proved: there may be a way with fewer than %d crossings, but none was found\n",
                 crossings);
  }
  return kFailed;
}

}  // namespace

int solveLevel(const SolveOptions& options) {
  const std::optional<LevelResult> result = loadLevelFile(options.file);
  if (!result) return kUsage;
  if (!result->level) return kInvalidLevel;
  if (!options.recorded.empty()) return tell(result->level, options);
  return options.withoutCrossing ? prove(result->level, options) : search(result->level, options);
}

}  // namespace platon
