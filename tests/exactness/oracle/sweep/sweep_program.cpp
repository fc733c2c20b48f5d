#include "tests/exactness/oracle/sweep/sweep_program.h"

#include <chrono>
#include <sstream>

#include "tests/support/files.h"
#include "tests/support/process.h"

namespace platon::oracle {
namespace {

constexpr std::chrono::hours kSweepLimit{1};

std::vector<std::string> linesOf(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

}  // namespace

SweepRun SweepProgram::run(const std::string& input) const {
  ProcessOptions options;
  options.inputFile = folder_ / "queries";
  writeText(options.inputFile, input);
  Process process({program_, "sweep"}, options);
  const int exitCode = process.wait(kSweepLimit);
  return {exitCode, linesOf(process.output()), linesOf(process.errors())};
}

}  // namespace platon::oracle
