#pragma once

#include <cstdio>
#include <functional>
#include <string>

#include "protocol/moment.h"
#include "protocol/token_bucket.h"

namespace platon {

/// Lines on standard error about what a server does, no more than somebody can read: a hostile server would otherwise
/// fill a disk with them. How many are left out is told.
class ServerLines {
 public:
  using Print = std::function<void(const std::string&)>;

  static constexpr double kLinesPerSecond = 1;
  static constexpr double kBurst = 10;
  /// Between the first line that is left out and the line that tells their number.
  static constexpr Moment kTellTime = std::chrono::seconds(10);

  /// `print` takes a line without its end.
  explicit ServerLines(Moment now, Print print = toStderr)
      : budget_(kLinesPerSecond, kBurst, now), print_(std::move(print)) {}

  /// Prints a line, or leaves it out.
  void add(const std::string& line, Moment now) {
    if (budget_.take(1, now)) return print_(line);
    if (leftOut_++ == 0) tellAt_ = now + kTellTime;
  }
  /// Tells how many lines were left out, when it is time. Call it regularly.
  void update(Moment now) {
    if (now >= tellAt_) tell();
  }
  /// Tells it at once; nothing if none were.
  void tell() {
    if (leftOut_ == 0) return;
    print_(std::to_string(leftOut_) + (leftOut_ == 1 ? " line" : " lines") +
           " about the server left out: it causes too many");
    leftOut_ = 0;
  }

 private:
  static void toStderr(const std::string& line) { std::fprintf(stderr, "platon-client: %s\n", line.c_str()); }

  TokenBucket budget_;
  Print print_;
  std::size_t leftOut_ = 0;
  Moment tellAt_{};
};

}  // namespace platon
