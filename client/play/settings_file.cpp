#include "client/play/settings_file.h"

#include <cstdio>
#include <fstream>
#include <iterator>
#include <string>
#include <system_error>

#include "client/play/user_folders.h"

namespace platon {

SettingsFile::SettingsFile() {
  const std::filesystem::path folder = configFolder();
  if (!folder.empty()) path_ = folder / "settings";
}

Settings SettingsFile::load() const {
  std::ifstream file(path_);
  if (!file) return {};
  const std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  const SettingsResult result = parseSettings(text);
  if (result.error.empty()) return result.settings;
  std::fprintf(stderr, "platon-client: %s: %s\n", path_.c_str(), result.error.c_str());
  return {};
}

void SettingsFile::save(const Settings& settings) const {
  if (path_.empty()) return;
  std::error_code ignored;  // the stream finds out
  std::filesystem::create_directories(path_.parent_path(), ignored);
  std::ofstream file(path_);
  file << settings.text();
  if (!file.flush()) std::fprintf(stderr, "platon-client: cannot write %s; settings are not kept\n", path_.c_str());
}

}  // namespace platon
