#pragma once

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "client/ui/settings.h"
#include "protocol/files/file_writer.h"
#include "protocol/moment.h"

namespace platon {

/// The file `settings` that keeps the player's settings between games. A save writes the settings, followed by the
/// lines of unknown settings that `load` found, and replaces the file by a rename, so that it is never half written. An
/// error is reported on standard error.
class SettingsFile {
 public:
  /// Uses the file in `folder`. With an empty `folder` nothing is loaded or saved.
  explicit SettingsFile(const std::filesystem::path& folder);

  /// Returns the settings of the file, or the defaults without a file. An invalid line is reported on standard error
  /// and does not affect the others.
  Settings load();
  /// Saves the settings without waiting for the disk, when they have changed and then stayed the same for kCalmTime.
  /// Call in each frame. The first call tells what the settings are without a change.
  void update(const Settings& settings, Moment now);
  /// Saves the settings now and waits for the disk, at most for some seconds.
  void save(const Settings& settings);

  static constexpr Moment kCalmTime = std::chrono::seconds(1);

 private:
  static constexpr Moment kLookInterval = std::chrono::milliseconds(250);

  void look(const Settings& settings, Moment now);
  void report(const std::optional<std::string>& fault) const;
  std::string textOf(const Settings& settings) const;

  std::filesystem::path path_;
  std::vector<std::string> unknownLines_;
  std::optional<FileWriter> writer_;  // nothing without a path
  std::optional<std::string> saved_;  // the last text that was to be written, or the first one
  std::string text_;                  // as of the last look
  Moment changedAt_{};                // when it was seen for the first time
  Moment lookAt_{};
};

}  // namespace platon
