#pragma once

#include <chrono>
#include <functional>
#include <string>
#include <utility>
#include <variant>

#include "tests/sim/verify/verification.h"

namespace platon::sim {

/// What is wrong with a recording, for people.
struct VerifyReport {
  std::string text;  ///< a sentence a line, each beginning with the path of the recording; empty when nothing is wrong
  int exitCode = 0;  ///< 1 for a divergence, else 3 for an incomplete recording
};

VerifyReport reportOf(const std::string& path, const Verification& found);
/// The value of the key "differs" of `verify --json`.
std::string jsonOf(const Divergence& divergence);
/// The keys "run" and "noRun" of `verify --json`, with their values.
std::string jsonOf(const std::variant<RunFinish, std::string>& run);
/// The line on the run.
std::string textOf(const std::variant<RunFinish, std::string>& run);

/// Tells whoever waits for a verification how far it is: first after two seconds, then once a second.
class VerifyProgress {
 public:
  using Time = std::chrono::steady_clock::time_point;
  /// Shows a line in place of the one before; an empty one removes it. Null: nobody sees it.
  using Show = std::function<void(const std::string& line)>;

  VerifyProgress(Show show, Time begin) : show_(std::move(show)), due_(begin + std::chrono::seconds(2)) {}
  ~VerifyProgress() { hide(); }
  VerifyProgress(const VerifyProgress&) = delete;
  VerifyProgress& operator=(const VerifyProgress&) = delete;

  /// `line` is asked for only if it is shown.
  void tell(Time now, const std::function<std::string()>& line);
  /// Removes the line, before something else is written.
  void hide();

 private:
  Show show_;
  Time due_;
  bool shown_ = false;
};

}  // namespace platon::sim
