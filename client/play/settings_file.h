#pragma once

#include <filesystem>

#include "client/ui/settings.h"

namespace platon {

/// The player's settings between two games: `platon/settings` in the user's folder for configuration.
class SettingsFile {
 public:
  /// Finds the folder from XDG_CONFIG_HOME or HOME; without either nothing is kept.
  SettingsFile();

  /// The usual settings when there is no file, or when it has a mistake, which is told on standard error.
  Settings load() const;
  /// Says on standard error when that fails.
  void save(const Settings& settings) const;

 private:
  std::filesystem::path path_;
};

}  // namespace platon
