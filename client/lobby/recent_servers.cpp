#include "client/lobby/recent_servers.h"

#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <system_error>

#include "client/lobby/kept_file.h"
#include "protocol/files/text_file.h"

namespace platon {
namespace {

constexpr std::size_t kMaxFileBytes = 64 * 1024;

std::vector<ServerAddress> serversIn(const std::string& text) {
  std::vector<ServerAddress> servers;
  std::istringstream lines(text);
  for (std::string line; servers.size() < RecentServers::kMaxServers && std::getline(lines, line);) {
    try {
      servers.push_back(parseServerAddress(line));
    } catch (const std::invalid_argument&) {
      continue;  // the player has changed the file
    }
  }
  return servers;
}

}  // namespace

std::vector<ServerAddress> RecentServers::list() const {
  return file_.empty() ? std::vector<ServerAddress>() : serversIn(readKeptFile(file_, kMaxFileBytes).value_or(""));
}

void RecentServers::remember(const ServerAddress& server) const {
  if (file_.empty()) return;
  const std::optional<std::string> kept = readKeptFile(file_, kMaxFileBytes);
  if (!kept) return;
  std::string text = server.text() + "\n";
  for (const ServerAddress& other : serversIn(*kept)) {
    if (other.text() != server.text()) text += other.text() + "\n";
  }
  std::error_code ignored;  // the file cannot be written then
  std::filesystem::create_directories(file_.parent_path(), ignored);
  replaceTextFile(file_.string(), text);
}

}  // namespace platon
