#include "tests/exactness/oracle/sweep/bad_lines_check.h"

#include <algorithm>
#include <array>
#include <iostream>
#include <string>
#include <string_view>

namespace platon::oracle {
namespace {

struct BadLine {
  std::string_view fault;
  std::string_view line;
};

constexpr std::string_view kGood = "3 0 0 10 0 0 10 0 0 1 1 5 5 6 6\n";
constexpr int kInvalid = 3;

constexpr auto kBadLines = std::to_array<BadLine>({
    {"a word", "hello"},
    {"only the vertex count", "3"},
    {"polygon only", "3 0 0 10 0 0 10"},
    {"one number short", "3 0 0 10 0 0 10 0 0 1 1 5 5 6"},
    {"one number too many", "3 0 0 10 0 0 10 0 0 1 1 5 5 6 6 7"},
    {"a word at the end", "3 0 0 10 0 0 10 0 0 1 1 5 5 6 6 x"},
    {"a letter on the last number", "3 0 0 10 0 0 10 0 0 1 1 5 5 6 6x"},
    {"a fraction", "3 0 0 10 0 0 10 0.5 0 1 1 5 5 6 6"},
    {"a fraction without digits after the point", "3 0 0 10 0 0 10 0 0 1. 1 5 5 6 6"},
    {"an exponent", "3 0 0 1e1 0 0 10 0 0 1 1 5 5 6 6"},
    {"hexadecimal", "3 0 0 0x10 0 0 10 0 0 1 1 5 5 6 6"},
    {"commas", "3,0,0,10,0,0,10,0,0,1,1,5,5,6,6"},
    {"a lone sign", "3 0 0 10 0 0 10 - 0 1 1 5 5 6 6"},
    {"a fractional vertex count", "3.0 0 0 10 0 0 10 0 0 1 1 5 5 6 6"},
    {"no vertices", "0 0 0 1 1 5 5 6 6"},
    {"one vertex", "1 0 0 0 0 1 1 5 5 6 6"},
    {"two vertices", "2 0 0 10 0 0 0 1 1 5 5 6 6"},
    {"a negative vertex count", "-3 0 0 10 0 0 10 0 0 1 1 5 5 6 6"},
    {"a vertex count beyond the numbers", "1000000000 0 0 10 0 0 10 0 0 1 1 5 5 6 6"},
    {"a vertex count beyond 64 bits", "99999999999999999999 0 0 10 0 0 10 0 0 1 1 5 5 6 6"},
    {"a vertex out of range", "3 0 0 536870912 0 0 10 0 0 1 1 5 5 6 6"},
    {"a vertex out of range below", "3 0 -536870912 10 0 0 10 0 0 1 1 5 5 6 6"},
    {"a position out of range", "3 0 0 10 0 0 10 0 536870912 1 1 5 5 6 6"},
    {"a displacement out of range", "3 0 0 10 0 0 10 0 0 -536870912 1 5 5 6 6"},
    {"a segment's start out of range", "3 0 0 10 0 0 10 0 0 1 1 536870912 5 6 6"},
    {"a segment's end out of range", "3 0 0 10 0 0 10 0 0 1 1 5 5 6 -536870912"},
    {"a number beyond 32 bits", "3 0 0 10 0 0 10 4294967296 0 1 1 5 5 6 6"},
    {"a number beyond 64 bits", "3 0 0 10 0 0 10 18446744073709551616 0 1 1 5 5 6 6"},
    {"clockwise", "3 0 0 0 10 10 0 0 0 1 1 5 5 6 6"},
    {"a dent", "4 0 0 10 0 2 2 0 10 0 0 1 1 5 5 6 6"},
    {"three vertices in a line", "4 0 0 5 0 10 0 0 10 0 0 1 1 5 5 6 6"},
    {"all vertices in a line", "3 0 0 5 0 10 0 0 0 1 1 5 5 6 6"},
    {"a vertex twice in a row", "4 0 0 10 0 10 0 0 10 0 0 1 1 5 5 6 6"},
    {"the first vertex again at the end", "4 0 0 10 0 0 10 0 0 0 0 1 1 5 5 6 6"},
    {"all vertices in one place", "3 7 7 7 7 7 7 0 0 1 1 5 5 6 6"},
    {"a vertex that turns back", "4 0 0 10 0 5 0 0 10 0 0 1 1 5 5 6 6"},
    {"the same triangle wound twice", "6 0 0 10 0 0 10 0 0 10 0 0 10 0 0 1 1 5 5 6 6"},
    {"a five-pointed star", "5 0 100 -59 -81 95 31 -95 31 59 -81 0 0 1 1 5 5 6 6"},
    {"crossing sides", "4 0 0 10 10 10 0 0 10 0 0 1 1 5 5 6 6"},
});

bool isRefusal(std::string_view line, std::string_view prefix) {
  return line.starts_with(prefix) && line.size() > prefix.size() + 2;
}

bool isRefused(const SweepProgram& program, const BadLine& bad, int goodLinesBefore) {
  std::string input;
  for (int i = 0; i < goodLinesBefore; ++i) input += kGood;
  const SweepRun result = program.run(input + std::string(bad.line) + "\n" + std::string(kGood));
  const std::string prefix = "line " + std::to_string(goodLinesBefore + 1) + ": ";
  const bool named = std::any_of(result.errors.begin(), result.errors.end(),
                                 [&](const std::string& line) { return isRefusal(line, prefix); });
  if (named && result.exitCode == kInvalid) return true;
  std::cout << "bad line (" << bad.fault << "): exit " << result.exitCode << " instead of " << kInvalid << ", \""
            << (result.errors.empty() ? "" : result.errors.front()) << "\" instead of \"" << prefix << "…\"\n  "
            << bad.line << '\n';
  return false;
}

bool isEmptyInputAccepted(const SweepProgram& program) {
  const SweepRun result = program.run("");
  if (result.exitCode == 0 && result.output.empty()) return true;
  std::cout << "empty input: exit " << result.exitCode << " and " << result.output.size() << " answers\n";
  return false;
}

}  // namespace

int countBadLineFailures(const SweepProgram& program) {
  int failures = isEmptyInputAccepted(program) ? 0 : 1;
  int goodLinesBefore = 0;
  for (const BadLine& bad : kBadLines) failures += isRefused(program, bad, goodLinesBefore++ % 4) ? 0 : 1;
  std::cout << "bad lines: " << kBadLines.size() << " tried, " << failures << " failures\n";
  return failures;
}

}  // namespace platon::oracle
