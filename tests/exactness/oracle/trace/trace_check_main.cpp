#include <algorithm>
#include <charconv>
#include <fstream>
#include <iostream>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "tests/exactness/oracle/trace/trace_checker.h"
#include "tests/exactness/oracle/trace/traced_run.h"

namespace platon::oracle {
namespace {

constexpr const char* kUsage =
    "usage: platon-trace-check FILE…\n"
    "       platon-trace-check [--ticks T] [--crossings C] [--elements E] --run PROGRAM ARGUMENT…\n"
    "Checks traces. The second form runs PROGRAM ARGUMENT… --trace PIPE and checks the trace that it writes. The "
    "program\n"
    "must exit with 0 and write T ticks, and its players must cross at least C edges and pass at least E elements.\n";

/// Conditions on a run.
struct Requirements {
  std::int64_t ticks = -1;
  std::int64_t crossings = 0;
  std::int64_t elements = 0;
};

bool printReport(const std::string& what, const TraceReport& report) {
  std::cout << what << ": " << report << '\n';
  return report.clean();
}

int checkFile(const std::string& file) {
  std::ifstream stream(file);
  if (!stream) return std::cerr << "cannot read " << file << '\n', 2;
  TraceChecker checker;
  std::string line;
  while (std::getline(stream, line) && checker.checkLine(line)) {
  }
  checker.finish();
  if (!printReport(file, checker.report())) return 1;
  if (checker.report().ticks == 0) return std::cout << "the trace has no ticks\n", 1;
  return 0;
}

int checkRun(const Requirements& requirements, const std::vector<std::string>& arguments) {
  const auto [report, exitCode] = runTraced(arguments);
  if (!printReport("trace", report)) return 1;
  if (exitCode != 0) return std::cout << "the program exits with " << exitCode << '\n', 1;
  if (report.ticks == 0) return std::cout << "the trace has no ticks\n", 1;
  if (requirements.ticks >= 0 && report.ticks != requirements.ticks)
    return std::cout << report.ticks << " ticks instead of " << requirements.ticks << '\n', 1;
  if (report.crossings < requirements.crossings) return std::cout << "only " << report.crossings << " crossings\n", 1;
  if (static_cast<std::int64_t>(report.elementsPassed.size()) < requirements.elements)
    return std::cout << "only " << report.elementsPassed.size() << " elements passed\n", 1;
  return 0;
}

bool parse(const std::string& text, std::int64_t& number) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  return error == std::errc{} && end == text.data() + text.size() && number >= 0;
}

int usage() {
  std::cerr << kUsage;
  return 2;
}

int main(std::span<const std::string> arguments) {
  Requirements requirements;
  const std::map<std::string, std::int64_t*> options = {{"--ticks", &requirements.ticks},
                                                        {"--crossings", &requirements.crossings},
                                                        {"--elements", &requirements.elements}};
  while (arguments.size() > 2 && options.contains(arguments[0])) {
    if (!parse(arguments[1], *options.at(arguments[0]))) return usage();
    arguments = arguments.subspan(2);
  }
  if (arguments.empty() || arguments[0] == "--help") return usage();
  if (arguments[0] == "--run" && arguments.size() > 1)
    return checkRun(requirements, {arguments.begin() + 1, arguments.end()});
  int worst = 0;
  for (const std::string& file : arguments) worst = std::max(worst, checkFile(file));
  return worst;
}

}  // namespace
}  // namespace platon::oracle

int main(int count, char** arguments) {
  const std::vector<std::string> given(arguments + 1, arguments + count);
  try {
    return platon::oracle::main(given);
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 1;
  }
}
