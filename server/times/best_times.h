#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "platon/game/diagnostics.h"
#include "server/base/utc_time.h"
#include "server/match/round_times.h"

namespace platon {

/// A level, and the version of the rules by which it was played: times of different rules are not compared.
struct PlayedLevel {
  std::uint64_t hash = 0;  ///< of the level
  std::uint32_t rules = 0;

  friend auto operator<=>(const PlayedLevel&, const PlayedLevel&) = default;  // NOLINT(modernize-use-nullptr)
};

/// A best time and when it was reached.
struct DatedTime {
  BestTime time;
  UtcTime date;

  friend bool operator==(const DatedTime&, const DatedTime&) = default;
};

/// The best time of each level, and the text of the file that keeps them. One line is one level:
///
///     0123456789abcdef 6 743 2026-12-01T18:00:00Z Ann
///
/// the hash of the level, the version of the rules, the ticks, when, and the name of the player. Empty lines and lines
/// that begin with `#` are skipped.
class BestTimes {
 public:
  /// Longest text, bytes.
  static constexpr std::size_t kMaxBytes = 1024 * 1024;
  /// Most best times. When there are more, those that are oldest by their dates are forgotten.
  static constexpr std::size_t kMaxTimes = 10'000;
  /// Most errors that `parse` reports; one more says that there are more.
  static constexpr std::size_t kMaxErrors = 100;

  /// Reads a text, or returns what is wrong with it, in order.
  static std::variant<BestTimes, std::vector<Diagnostic>> parse(std::string_view text);
  /// A text that `parse` reads, of at most kMaxBytes.
  std::string text() const;

  /// The best time; null if there is none. Valid until the times change.
  const DatedTime* find(const PlayedLevel& level) const;
  /// Takes a time if it is less than the best one or the first one. Returns whether it was taken.
  bool offer(const PlayedLevel& level, const DatedTime& time);
  /// Takes all times of others, each as `offer` does, before any is forgotten.
  void merge(const BestTimes& others);
  bool empty() const { return times_.empty(); }
  std::size_t size() const { return times_.size(); }

  friend bool operator==(const BestTimes&, const BestTimes&) = default;

 private:
  bool take(const PlayedLevel& level, const DatedTime& time);
  void limit();

  std::map<PlayedLevel, DatedTime> times_;
};

}  // namespace platon
