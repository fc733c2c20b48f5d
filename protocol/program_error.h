#pragma once

#include <stdexcept>
#include <string>

namespace platon {

/// An error that ends a program; `what()` states the cause and how to correct it. `what()` is one line, except for an
/// invalid level: then it has one line per error found.
class ProgramError : public std::runtime_error {
 public:
  // Exit codes of all programs.
  static constexpr int kFailed = 1;   ///< failed, or a check did not hold
  static constexpr int kUsage = 2;    ///< usage or configuration, also a file that cannot be read
  static constexpr int kInvalid = 3;  ///< a level, a recording or a scene is invalid

  ProgramError(int exitCode, const std::string& what) : std::runtime_error(what), exitCode_(exitCode) {}

  int exitCode() const { return exitCode_; }

 private:
  int exitCode_;
};

}  // namespace platon
