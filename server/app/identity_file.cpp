#include "server/app/identity_file.h"

#include <cstdlib>
#include <filesystem>

#include "protocol/program_error.h"
#include "protocol/transport/server_identity.h"

namespace platon {
namespace {

std::filesystem::path environment(const char* name) {
  const char* const value = std::getenv(name);
  return value == nullptr ? std::filesystem::path() : std::filesystem::path(value);
}

std::filesystem::path stateFolder() {
  if (const auto state = environment("STATE_DIRECTORY"); !state.empty()) return state;
  if (const auto data = environment("XDG_DATA_HOME"); !data.empty()) return data / "platon";
  if (const auto home = environment("HOME"); !home.empty()) return home / ".local/share/platon";
  return {};
}

ServerIdentity readAndWarn(const std::string& keyFile, Log& log) {
  const ServerIdentity identity = readKeyFile(keyFile);
  if (const std::string reason = keyFileWarning(keyFile); !reason.empty())
    log.warning("the key of the server is not private", {{"file", keyFile}, {"reason", reason}});
  return identity;
}

}  // namespace

std::string defaultKeyFile() {
  const std::filesystem::path folder = stateFolder();
  return folder.empty() ? "" : (folder / "server.key").string();
}

ServerIdentity loadIdentity(const std::string& keyFile, Log& log) {
  if (!keyFile.empty()) return readAndWarn(keyFile, log);
  const std::filesystem::path path = defaultKeyFile();
  std::string fault = "no folder for it: set STATE_DIRECTORY or HOME";
  if (!path.empty()) {
    std::error_code ignored;  // the file cannot be created then
    std::filesystem::create_directories(path.parent_path(), ignored);
    try {
      return readAndWarn(path.string(), log);
    } catch (const ProgramError& error) {
      fault = error.what();
    }
  }
  log.warning("the key of the server is not kept: after a restart, clients will not recognise the server",
              {{"reason", fault}});
  return ServerIdentity::random();
}

}  // namespace platon
