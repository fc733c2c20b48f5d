#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "platon/game/diagnostics.h"
#include "protocol/files/file_writer.h"
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
  /// Most bytes of `text()` and of a file.
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

/// Reads a file of best times; one that does not exist has none, if its folder exists. On failure returns what is wrong
/// with it, each error as `file:line:column: error: …`.
std::variant<BestTimes, std::vector<std::string>> readBestTimes(const std::string& path);

/// Adds the best times of a text to those of a file, as FileWriter needs it. Returns why that failed, or an empty text.
/// A damaged file is not changed. May wait for the disk, and for another server.
std::string addBestTimes(const std::string& path, std::string_view text);

/// The best times of a running server by the present rules, and the file that keeps them. New times are added to what
/// the file holds when it is written, so that several servers can share it.
class BestTimeStore : public BestTimeKeeper {
 public:
  using Clock = std::function<UtcTime()>;

  /// Best times that end with the server.
  explicit BestTimeStore(Clock clock) : clock_(std::move(clock)) {}
  /// Best times that are kept in a file, which holds `times`.
  BestTimeStore(Clock clock, const std::string& path, BestTimes times);

  std::optional<BestTime> best(std::uint64_t level) const override;
  bool offer(std::uint64_t level, const BestTime& time, bool lasts = true) override;

  const BestTimes& times() const { return times_; }
  /// Whether a time is not in the file yet.
  bool pending() const { return file_ && file_->pending(); }
  /// How often the file could not be written so far (FileWriter::failures).
  std::uint64_t failures() const { return file_ ? file_->failures() : 0; }
  /// Call now and then: starts to write the file, again after a failure. Returns, once, why it could not be written.
  std::optional<std::string> poll(FileWriter::Time now);
  /// Writes what is pending, as FileWriter::finish does. Returns why the times are not in the file.
  std::optional<std::string> finish() { return file_ ? file_->finish() : std::nullopt; }

 private:
  Clock clock_;
  BestTimes times_;
  BestTimes kept_;  // those of them that are in the file, or will be
  BestTimes unwritten_;
  std::unique_ptr<FileWriter> file_;  // null: none
};

}  // namespace platon
