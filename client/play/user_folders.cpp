#include "client/play/user_folders.h"

#include <cstdlib>

namespace platon {

namespace {

constexpr const char* kName = "platon";

// As the XDG Base Directory Specification has it.
std::filesystem::path folder(const char* variable, const char* belowHome) {
  const char* const said = std::getenv(variable);
  if (said != nullptr && *said != '\0') return std::filesystem::path(said) / kName;
  const char* const home = std::getenv("HOME");
  if (home == nullptr || *home == '\0') return {};
  return std::filesystem::path(home) / belowHome / kName;
}

}  // namespace

std::filesystem::path configFolder() { return folder("XDG_CONFIG_HOME", ".config"); }

std::filesystem::path dataFolder() { return folder("XDG_DATA_HOME", ".local/share"); }

}  // namespace platon
