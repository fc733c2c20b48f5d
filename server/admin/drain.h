#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <string_view>

#include "server/base/time_point.h"
#include "server/match/match.h"

namespace platon {

/// The end of a server that lets its players finish their round. Nobody joins any more; the server is to stop when
/// nobody is left, when the pause after the round is over, or after a time limit.
class Drain {
 public:
  /// The match must outlive this.
  explicit Drain(Match& match) : match_(match) {}

  /// Begins, or goes on with another limit. `next`: where the players can go on (isNextServer); empty: they are
  /// told nothing.
  void begin(TimePoint now, std::chrono::seconds limit, const std::string& next);
  bool begun() const { return match_.draining(); }
  /// Why the server is to stop now, in one or two words; nothing as long as it is not.
  std::optional<std::string_view> over(TimePoint now) const;
  /// Until the limit, rounded up; at least 0. Call only after `begin`.
  std::chrono::seconds secondsLeft(TimePoint now) const;

 private:
  Match& match_;
  TimePoint end_{};
};

}  // namespace platon
