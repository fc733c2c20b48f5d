#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "client/desync/desync_detector.h"
#include "protocol/time.h"

namespace platon {

/// Human-readable report of a desync.
struct DesyncReport {
  std::string summary;                  ///< one line without a full stop: ticks, field and both values
  std::string text;                     ///< everything except the recording, several lines
  std::vector<std::uint8_t> recording;  ///< of the client's game
};

DesyncReport reportOf(Desync desync);

/// The desync reports of a session, at most one in kInterval.
class DesyncReports {
 public:
  static constexpr Time kInterval = std::chrono::minutes(1);

  /// Reports a desync, if there is one. `now` never decreases.
  void add(std::optional<Desync> desync, Time now);
  /// The last report; each is returned once.
  std::optional<DesyncReport> take() { return std::exchange(last_, std::nullopt); }

 private:
  std::optional<DesyncReport> last_;
  std::optional<Time> reportedAt_;
};

/// The folder to which desync reports are written. Holds at most kMaxReports reports of a few MiB each, because a
/// malicious server can cause any number of desyncs.
class DesyncFolder {
 public:
  static constexpr int kMaxReports = 10;

  /// The folder is created with the first report. Empty path: no reports are written.
  explicit DesyncFolder(std::filesystem::path folder) : folder_(std::move(folder)) {}

  /// Writes the report and its recording. Returns a log message: the summary, and the path of the report or why it was
  /// not written.
  std::string write(const DesyncReport& report) const;

 private:
  std::filesystem::path folder_;
};

}  // namespace platon
