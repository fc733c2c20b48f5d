#pragma once

#include <stdexcept>
#include <string>

namespace platon {

/// A client program cannot go on; `what()` says why and how to mend it. One line, but for an invalid level, which has
/// one for everything found.
class ClientError : public std::runtime_error {
 public:
  static constexpr int kFailed = 1;
  static constexpr int kUsage = 2;  ///< usage or configuration
  static constexpr int kLevel = 3;  ///< a level is invalid

  ClientError(int exitCode, const std::string& what) : std::runtime_error(what), exitCode_(exitCode) {}

  int exitCode() const { return exitCode_; }

 private:
  int exitCode_;
};

}  // namespace platon
