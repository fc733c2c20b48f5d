#pragma once

#include <filesystem>
#include <string>
#include <utility>

#include "client/desync/desync_report.h"

namespace platon {

/// The folder that reports of desyncs are written to. Never more than a few, of a few MiB at most: a server that
/// lies could cause any number.
class DesyncFolder {
 public:
  static constexpr int kMaxReports = 10;

  /// Made when the first report comes; empty: none are written.
  explicit DesyncFolder(std::filesystem::path folder) : folder_(std::move(folder)) {}

  /// Writes the report and its recording. What to log, one sentence: the summary, and where the report is or why not.
  std::string keep(const DesyncReport& report) const;

 private:
  std::filesystem::path folder_;
};

}  // namespace platon
