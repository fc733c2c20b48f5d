#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "protocol/files/file_writer.h"
#include "server/times/best_times.h"

namespace platon {

/// Reads a file of best times; one that does not exist has none, if its folder exists. On failure returns what is wrong
/// with it, each error as `file:line:column: error: …`.
std::variant<BestTimes, std::vector<std::string>> readBestTimes(const std::string& path);

/// Adds the best times of a text to those of a file, as FileWriter needs it. Returns why that failed, or an empty text.
/// A damaged file is not changed. May wait for the disk.
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
