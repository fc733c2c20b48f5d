#include "tests/exactness/oracle/sweep/sweep_program.h"

#include <fstream>
#include <stdexcept>

#include "tests/support/child_process.h"

namespace platon::oracle {
namespace {

std::vector<std::string> linesOf(const std::filesystem::path& file) {
  std::ifstream stream(file);
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

}  // namespace

ProgramResult SweepProgram::run(const std::string& input) const {
  const Redirections files{folder_ / "queries", folder_ / "answers", folder_ / "errors"};
  if (!(std::ofstream(files.input, std::ios::binary) << input << std::flush))
    throw std::runtime_error("cannot write " + files.input);
  ProgramResult result;
  result.exitCode = ChildProcess({program_, "sweep"}, files).wait();
  result.output = linesOf(files.output);
  result.errors = linesOf(files.errors);
  return result;
}

}  // namespace platon::oracle
