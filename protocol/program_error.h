#pragma once

#include <stdexcept>
#include <string>

namespace platon {

/// An error that ends a program; `what()` states the cause and how to correct it. `what()` is one line, except for an
/// invalid level: then it has one line per error found.
class ProgramError : public std::runtime_error {
 public:
  static constexpr int kFailed = 1;
  static constexpr int kUsage = 2;  ///< usage or configuration
  static constexpr int kLevel = 3;  ///< a level is invalid

  ProgramError(int exitCode, const std::string& what) : std::runtime_error(what), exitCode_(exitCode) {}

  int exitCode() const { return exitCode_; }

 private:
  int exitCode_;
};

}  // namespace platon
