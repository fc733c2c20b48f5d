#include <charconv>
#include <cstdlib>
#include <iostream>
#include <optional>
#include <stdexcept>
#include <string_view>

#include "tests/exactness/oracle/sweep/bad_lines_check.h"
#include "tests/exactness/oracle/sweep/sweep_families.h"
#include "tests/exactness/oracle/sweep/sweep_oracle.h"
#include "tests/exactness/oracle/sweep/sweep_program.h"

namespace platon::oracle {
namespace {

constexpr std::uint64_t kDefaultSeed = 20240607;
constexpr std::uint64_t kDefaultCount = 1'000'000;
/// The oracle itself is checked against the definition on every 16th query.
constexpr std::size_t kConfirmEvery = 16;

struct Totals {
  std::size_t queries = 0;
  std::size_t hits = 0;
  std::size_t overlaps = 0;
  std::size_t vertices = 0;
  std::size_t disagreements = 0;

  void count(const CorrectAnswer& correct) {
    ++queries;
    hits += correct.kind == CorrectAnswer::Kind::Hit;
    overlaps += correct.kind == CorrectAnswer::Kind::Overlap;
    vertices += correct.normals.size() == 2;
  }
  void add(const Totals& other) {
    queries += other.queries;
    hits += other.hits;
    overlaps += other.overlaps;
    vertices += other.vertices;
    disagreements += other.disagreements;
  }
};

std::ostream& operator<<(std::ostream& stream, const Totals& totals) {
  return stream << totals.queries << " queries, " << totals.hits << " hits (" << totals.vertices
                << " through vertices), " << totals.overlaps << " overlaps, " << totals.disagreements
                << " disagreements";
}

std::vector<SweepQuery> makeBatch(const SweepFamily& family, std::size_t count, std::uint64_t seed) {
  RandomSource random(seed);
  std::vector<SweepQuery> queries;
  queries.reserve(count);
  while (queries.size() < count) queries.push_back(makeQuery(family, random));
  return queries;
}

void printDisagreement(const SweepFamily& family, const SweepQuery& query, const CorrectAnswer& correct,
                       std::string_view answer) {
  std::cout << "DISAGREEMENT in family \"" << family.name << "\"\n  query:    " << toLine(query)
            << "\n  expected: " << toText(correct) << "\n  answer:   " << answer << '\n';
}

/// Compares one answer with the oracle. Prints the first disagreement of a family.
void compare(const SweepFamily& family, const SweepQuery& query, std::string_view line, Totals& totals) {
  const CorrectAnswer correct = correctAnswer(query);
  if (totals.queries % kConfirmEvery == 0 && !confirms(query, correct))
    throw std::logic_error("the oracle contradicts the definition at " + toLine(query) + ": " + toText(correct));
  totals.count(correct);
  const std::optional<SweepAnswer> answer = parseAnswer(line);
  if (answer && agrees(correct, *answer)) return;
  if (totals.disagreements++ == 0) printDisagreement(family, query, correct, line);
}

Totals checkFamily(const SweepProgram& program, const SweepFamily& family, std::size_t count, std::uint64_t seed) {
  const std::vector<SweepQuery> queries = makeBatch(family, count, seed);
  std::string input;
  for (const SweepQuery& query : queries) input.append(toLine(query)).append("\n");
  const SweepRun result = program.run(input);
  Totals totals;
  for (std::size_t i = 0; i < queries.size(); ++i)
    compare(family, queries[i], i < result.output.size() ? result.output[i] : "(no answer)", totals);
  if (result.exitCode != 0 || result.output.size() != queries.size()) {
    std::cout << "family \"" << family.name << "\": exit " << result.exitCode << ", " << result.output.size()
              << " answers\n";
    ++totals.disagreements;
  }
  std::cout << family.name << ": " << totals << std::endl;
  return totals;
}

int check(const SweepProgram& program, std::uint64_t count, std::uint64_t seed) {
  const std::span<const SweepFamily> families = sweepFamilies();
  const std::size_t each = (count + families.size() - 1) / families.size();
  std::cout << "seed " << seed << ", " << families.size() << " families\n";
  Totals total;
  for (std::size_t i = 0; i < families.size(); ++i) total.add(checkFamily(program, families[i], each, seed + i));
  std::cout << "all: " << total << '\n';
  const int badLines = countBadLineFailures(program);
  return total.disagreements == 0 && badLines == 0 ? 0 : 1;
}

std::optional<std::uint64_t> parseNumber(std::string_view text) {
  std::uint64_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  return error == std::errc{} && end == text.data() + text.size() ? std::optional(number) : std::nullopt;
}

}  // namespace
}  // namespace platon::oracle

int main(int count, char** arguments) {
  using namespace platon::oracle;
  const auto queries = count > 2 ? parseNumber(arguments[2]) : kDefaultCount;
  const auto seed = count > 3 ? parseNumber(arguments[3]) : kDefaultSeed;
  if (count < 2 || count > 4 || queries.value_or(0) == 0 || !seed) {
    std::cerr << "usage: platon-sweep-check PLATON-SIM [QUERIES [SEED]]\n";
    return 2;
  }
  try {
    return check(SweepProgram(arguments[1]), *queries, *seed);
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 1;
  }
}
