#include "levels/tool/solve_command.h"

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <memory>
#include <utility>
#include <vector>

#include "levels/reach/jump_heights.h"
#include "levels/reach/reach.h"
#include "levels/solve/level_solver.h"
#include "levels/solve/recorded_way.h"
#include "levels/tool/level_file.h"
#include "protocol/files/text_file.h"
#include "protocol/program_error.h"
#include "protocol/texts.h"

namespace platon {
namespace {

// Longest recording of a way that is read: hours of play.
constexpr std::size_t kMaxWayBytes = std::size_t{1} << 26;

bool write(const std::string& file, const std::vector<std::uint8_t>& bytes) {
  const std::string fault = replaceOutputFile(file, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
  if (!fault.empty()) std::fprintf(stderr, "platon-level: cannot write '%s': %s\n", file.c_str(), fault.c_str());
  return fault.empty();
}

// "key 1, plate 2": the elements that the solution uses.
std::string elementsText(const Level& level, const SolutionFacts& facts, bool json) {
  std::vector<std::string> names;
  for (const std::uint32_t index : facts.elements) {
    const Element& element = level.elements[index];
    const std::string name = ElementWord{element.kind, element.number, element.openTicks}.text();
    names.push_back(json ? jsonText(name) : name);
  }
  return joined(names, json ? "," : ", ");
}

void printFacts(const Level& level, const SolutionFacts& facts) {
  std::printf("solved in %.2f s: %s, %s, %s of down", facts.ticks / 60.0, counted(facts.presses, "press").c_str(),
              counted(facts.crossings, "crossing").c_str(), counted(facts.turns, "turn").c_str());
  if (facts.slack) {
    std::printf(", tightest jump %s", counted(static_cast<std::size_t>(*facts.slack), "tick").c_str());
  }
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
    return ProgramError::kFailed;
  }
  const SolutionFacts facts = factsOf(level, *solution).value();
  if (options.json) {
    printFactsJson(*level, facts);
    std::printf(",\"states\":%zu}\n", solver.states());
  } else {
    printFacts(*level, facts);
    std::printf(" (%zu states searched)\n", solver.states());
  }
  return options.recording.empty() || write(options.recording, recordWay(level, *solution)) ? 0 : ProgramError::kFailed;
}

// Tells about a recorded way, if it is one of this level.
int tell(const std::shared_ptr<const Level>& level, const SolveOptions& options) {
  std::string fault;
  const auto content = readInputFile(options.recorded, kMaxWayBytes, fault);
  if (!content) {
    std::fprintf(stderr, "platon-level: %s\n", fault.c_str());
    return ProgramError::kUsage;
  }
  const auto* const bytes = reinterpret_cast<const std::uint8_t*>(content->data());
  const RecordedWay way = readRecordedWay({bytes, content->size()});
  if (!way.fault.empty()) {
    std::fprintf(stderr, "%s: error: %s\n", options.recorded.c_str(), way.fault.c_str());
    return ProgramError::kInvalid;
  }
  const bool isOfLevel =
      way.level->hash == level->hash && !way.inputs.empty() && way.inputs.front().size() >= level->players;
  const auto facts = isOfLevel ? factsOf(level, way.inputs) : std::nullopt;
  if (!facts) {
    std::fprintf(
        stderr,
        "platon-level: the way in '%s' does not lead to the goal of '%s' as it is now; record a new one with -o\n",
        options.recorded.c_str(), options.file.c_str());
    return ProgramError::kFailed;
  }
  options.json ? printFactsJson(*level, *facts) : printFacts(*level, *facts);
  std::printf(options.json ? "}\n" : "\n");
  return 0;
}

// "key 1", "a checkpoint"; empty if none is excluded.
std::string excludedText(const SolveOptions& options) {
  if (!options.without) return "";
  return (numbersOf(options.without->kind) > 0 ? "" : "a ") + options.without->text();
}

// What is to be proved: "every way to the goal uses key 1".
std::string claimText(const SolveOptions& options) {
  const std::string without = excludedText(options);
  if (!options.withoutCrossing) return "every way to the goal uses " + without;
  const std::string crossings = " has " + std::to_string(*options.withoutCrossing) + " crossings or more";
  return "every way to the goal" + (without.empty() ? "" : " that does not use " + without) + crossings;
}

std::vector<ElementWord> excluded(const SolveOptions& options) {
  return options.without ? std::vector{*options.without} : std::vector<ElementWord>();
}

bool isProved(const Level& level, const SolveOptions& options) {
  if (options.withoutCrossing == 0 || !JumpHeights(level, {.without = excluded(options)}).reachesGoal()) return true;
  return options.withoutCrossing && !Reach(level, *options.withoutCrossing - 1, excluded(options)).crossingsToGoal();
}

// A way that the claim denies.
std::optional<Solution> findCounterexample(const std::shared_ptr<const Level>& level, const SolveOptions& options) {
  LevelSolver::Limits limits;
  limits.without = excluded(options);
  if (options.withoutCrossing) limits.crossings = static_cast<std::uint32_t>(*options.withoutCrossing - 1);
  auto way = LevelSolver(level).solve(limits);
  const auto facts = way ? factsOf(level, *way) : std::nullopt;
  const auto isUsed = [&](std::uint32_t index) { return isAmong(limits.without, level->elements[index]); };
  // Players who wait may have touched what those who move keep off.
  if (!facts || std::any_of(facts->elements.begin(), facts->elements.end(), isUsed)) return std::nullopt;
  return way;
}

void printVerdict(const SolveOptions& options, bool proved, bool found) {
  std::printf("{");
  if (options.withoutCrossing) std::printf("\"withoutCrossing\":%d,", *options.withoutCrossing);
  if (options.without) std::printf("\"without\":%s,", jsonText(options.without->text()).c_str());
  std::printf("\"proved\":%s,\"found\":%s}\n", proved ? "true" : "false", found ? "true" : "false");
}

// Proves the claim, or shows a way that it denies, or says that it can do neither.
int prove(const std::shared_ptr<const Level>& level, const SolveOptions& options) {
  const bool proved = isProved(*level, options);
  const auto way = proved ? std::nullopt : findCounterexample(level, options);
  if (options.json) printVerdict(options, proved, way.has_value());
  if (proved) {
    if (!options.json) std::printf("proved: %s\n", claimText(options).c_str());
    return 0;
  }
  if (!way) {
    std::fprintf(stderr, "platon-level: not proved that %s: no other way was found, but there may be one\n",
                 claimText(options).c_str());
    return ProgramError::kFailed;
  }
  std::fprintf(stderr, "platon-level: a way was found%s: it has %u crossings\n",
               options.without ? (" without " + excludedText(options)).c_str() : "", factsOf(level, *way)->crossings);
  if (!options.recording.empty()) write(options.recording, recordWay(level, *way));
  return ProgramError::kFailed;
}

}  // namespace

int solveLevel(const SolveOptions& options) {
  const std::optional<LevelResult> result = loadLevelFile(options.file);
  if (!result) return ProgramError::kUsage;
  if (!result->level) return ProgramError::kInvalid;
  if (!options.recorded.empty()) return tell(result->level, options);
  return options.withoutCrossing || options.without ? prove(result->level, options) : search(result->level, options);
}

}  // namespace platon
