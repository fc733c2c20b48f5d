#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "client/ui/settings.h"

namespace platon {

/// The file `settings` that keeps the player's settings between games.
class SettingsFile {
 public:
  /// Uses the file in `folder`. With an empty `folder` nothing is loaded or saved.
  explicit SettingsFile(const std::filesystem::path& folder);

  /// Returns the settings of the file, or the defaults without a file. An invalid line is reported on standard error
  /// and does not affect the others.
  Settings load();
  /// Writes the settings, followed by the lines of unknown settings that `load` found. Replaces the file by a rename,
  /// so that it is never half written. Reports an error on standard error.
  void save(const Settings& settings) const;

 private:
  std::filesystem::path path_;
  std::vector<std::string> unknownLines_;
};

}  // namespace platon
