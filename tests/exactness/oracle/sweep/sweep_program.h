#pragma once

#include <string>
#include <utility>
#include <vector>

#include "tests/support/temporary_folder.h"

namespace platon::oracle {

/// What a run of the program left behind.
struct ProgramResult {
  int exitCode = 0;
  std::vector<std::string> output;
  std::vector<std::string> errors;
};

/// A program that answers sweep queries, `PROGRAM sweep`, run over whole batches of lines.
class SweepProgram {
 public:
  explicit SweepProgram(std::string program) : program_(std::move(program)) {}

  /// Runs the program on this input to its end.
  ProgramResult run(const std::string& input) const;

 private:
  std::string program_;
  TemporaryFolder folder_;
};

}  // namespace platon::oracle
