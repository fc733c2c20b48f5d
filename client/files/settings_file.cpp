#include "client/files/settings_file.h"

#include <cstdio>
#include <fstream>
#include <iterator>
#include <system_error>
#include <utility>

#include "protocol/files/text_file.h"

namespace platon {

SettingsFile::SettingsFile(const std::filesystem::path& folder) {
  if (!folder.empty()) path_ = folder / "settings";
}

Settings SettingsFile::load() {
  std::ifstream file(path_, std::ios::binary);
  if (!file) return {};
  const std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  SettingsResult result = parseSettings(text);
  for (const std::string& error : result.errors) {
    std::fprintf(stderr, "platon-client: %s: %s\n", path_.c_str(), error.c_str());
  }
  unknownLines_ = std::move(result.unknownLines);
  return result.settings;
}

void SettingsFile::save(const Settings& settings) const {
  if (path_.empty()) return;
  std::error_code ignored;  // writing reports the error
  std::filesystem::create_directories(path_.parent_path(), ignored);
  std::string text = settings.text();
  for (const std::string& line : unknownLines_) text += line + "\n";
  if (const std::string fault = replaceTextFile(path_.string(), text); !fault.empty()) {
    std::fprintf(stderr, "platon-client: cannot write %s: %s; the settings are not saved\n", path_.c_str(),
                 fault.c_str());
  }
}

}  // namespace platon
