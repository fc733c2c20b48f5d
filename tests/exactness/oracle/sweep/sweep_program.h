#pragma once

#include <string>
#include <utility>
#include <vector>

#include "tests/support/temporary_folder.h"

namespace platon::oracle {

/// Exit code and output lines of a run.
struct SweepRun {
  int exitCode = 0;
  std::vector<std::string> output;
  std::vector<std::string> errors;
};

/// A program that answers sweep queries with `PROGRAM sweep`, one query per line.
class SweepProgram {
 public:
  explicit SweepProgram(std::string program) : program_(std::move(program)) {}

  /// Runs the program on this input. Throws std::runtime_error if it takes longer than an hour.
  SweepRun run(const std::string& input) const;

 private:
  std::string program_;
  TemporaryFolder folder_;
};

}  // namespace platon::oracle
