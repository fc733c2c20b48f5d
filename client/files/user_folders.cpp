#include "client/files/user_folders.h"

#include <cstdlib>
#include <sstream>
#include <string_view>
#include <variant>

#include "protocol/files/text_file.h"

namespace platon {

namespace {

constexpr const char* kName = "platon";
constexpr std::size_t kMaxFolderTextBytes = std::size_t{1} << 16;  // of the file that names the folders

// Follows the XDG Base Directory Specification.
std::filesystem::path folder(const char* variable, const char* defaultInHome) {
  const char* const base = std::getenv(variable);
  if (base != nullptr && *base != '\0') return std::filesystem::path(base) / kName;
  const char* const home = std::getenv("HOME");
  if (home == nullptr || *home == '\0') return {};
  return std::filesystem::path(home) / defaultInHome / kName;
}

std::filesystem::path inData(const char* name) {
  const std::filesystem::path data = dataFolder();
  return data.empty() ? data : data / name;
}

}  // namespace

std::filesystem::path configFolder() { return folder("XDG_CONFIG_HOME", ".config"); }

std::filesystem::path dataFolder() { return folder("XDG_DATA_HOME", ".local/share"); }

std::filesystem::path bestTimesFile() { return inData("best_times"); }

std::filesystem::path reachedLevelsFile() { return inData("reached_levels"); }

std::filesystem::path runsFolder() { return inData("runs"); }

std::filesystem::path ghostsFolder() { return inData("ghosts"); }

std::filesystem::path ownLevelsFolder() { return inData("levels"); }

std::filesystem::path stateFolder() { return folder("XDG_STATE_HOME", ".local/state"); }

std::filesystem::path picturesFolder() {
  const char* const chosen = std::getenv("XDG_PICTURES_DIR");
  if (chosen != nullptr && *chosen != '\0') return chosen;
  const char* const home = std::getenv("HOME");
  if (home == nullptr || *home == '\0') return {};
  const auto read = readTextFile(configFolder().parent_path() / "user-dirs.dirs", kMaxFolderTextBytes);
  const auto* const text = std::get_if<std::string>(&read);
  std::istringstream file(text == nullptr ? std::string() : *text);
  for (std::string line; std::getline(file, line);) {
    constexpr std::string_view kStart = "XDG_PICTURES_DIR=\"$HOME/";
    if (line.starts_with(kStart) && line.ends_with('"')) {
      return std::filesystem::path(home) / line.substr(kStart.size(), line.size() - kStart.size() - 1);
    }
  }
  return std::filesystem::path(home) / "Pictures";
}

std::filesystem::path cacheFolder() { return folder("XDG_CACHE_HOME", ".cache"); }

std::string serverFileName(const ServerAddress& server) {
  constexpr std::string_view kDigits = "0123456789abcdef";
  std::string name;
  for (const char c : server.host) {
    const bool plain =
        (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '.' || c == '-';
    const auto code = static_cast<unsigned char>(c);
    if (plain)
      name += c;
    else
      (name += '%').append({kDigits[code / 16u], kDigits[code % 16u]});
  }
  return name + "_" + std::to_string(server.port);
}

}  // namespace platon
