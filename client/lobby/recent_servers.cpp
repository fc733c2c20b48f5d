#include "client/lobby/recent_servers.h"

#include <algorithm>
#include <sstream>
#include <stdexcept>
#include <string>
#include <system_error>
#include <variant>

#include "protocol/files/text_file.h"

namespace platon {
namespace {

constexpr std::size_t kMaxBytes = 64 * 1024;

}  // namespace

std::vector<ServerAddress> RecentServers::list() const {
  std::vector<ServerAddress> servers;
  if (file_.empty()) return servers;
  const auto text = readTextFile(file_.string(), kMaxBytes);
  if (!std::holds_alternative<std::string>(text)) return servers;
  std::istringstream lines(std::get<std::string>(text));
  for (std::string line; servers.size() < kMaxServers && std::getline(lines, line);) {
    try {
      servers.push_back(parseServerAddress(line));
    } catch (const std::invalid_argument&) {
      continue;  // the player has changed the file
    }
  }
  return servers;
}

void RecentServers::remember(const ServerAddress& server) const {
  if (file_.empty()) return;
  std::string text = server.text() + "\n";
  for (const ServerAddress& other : list()) {
    if (other.text() != server.text()) text += other.text() + "\n";
  }
  std::error_code ignored;  // the file cannot be written then
  std::filesystem::create_directories(file_.parent_path(), ignored);
  replaceTextFile(file_.string(), text);
}

}  // namespace platon
