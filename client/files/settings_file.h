#pragma once

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>

#include "client/ui/settings.h"
#include "protocol/files/file_writer.h"
#include "protocol/time.h"

namespace platon {

/// Keeps the player's settings between games in the KeptFile `settings`. A save writes the settings, followed by the
/// lines of unknown settings that the file holds then. A file with invalid lines is copied to `settings.broken` before
/// it is replaced, and stays if that fails. The copy replaces the one of an earlier file. An error is reported on
/// standard error.
class SettingsFile {
 public:
  /// Uses the file in `folder`. With an empty `folder` nothing is loaded or saved.
  explicit SettingsFile(const std::filesystem::path& folder);

  /// Returns the settings of the file, or the defaults without a file. An invalid line is reported on standard error
  /// and does not affect the others. A file that cannot be read, or is larger than 1 MiB, is never written.
  Settings load();
  /// What `load` has found wrong with the file, a sentence for the player; empty: nothing.
  const std::string& fault() const { return fault_; }
  /// Saves the settings without waiting for the disk, when they have changed and then stayed the same for kCalmTime.
  /// What could not be saved is tried again. Call in each frame. The first call tells what the settings are without a
  /// change.
  void update(const Settings& settings, Time now);
  /// Saves the settings now and waits for the disk, at most for some seconds.
  void save(const Settings& settings);

  static constexpr Time kCalmTime = std::chrono::seconds(1);

 private:
  static constexpr Time kLookInterval = std::chrono::milliseconds(250);

  void look(const Settings& settings, Time now);
  void report(const std::optional<std::string>& fault) const;

  std::filesystem::path path_;
  std::string fault_;
  std::optional<FileWriter> writer_;  // nothing if the file must not be written
  std::optional<std::string> saved_;  // the last text that was to be written, or the first one
  std::string text_;                  // as of the last look
  Time changedAt_{};                  // when it was seen for the first time
  Time lookAt_{};
};

}  // namespace platon
