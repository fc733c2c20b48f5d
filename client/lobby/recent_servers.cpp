#include "client/lobby/recent_servers.h"

#include <stdexcept>
#include <string>
#include <utility>
#include <variant>

#include "protocol/files/word_reader.h"

namespace platon {
namespace {

constexpr std::size_t kMaxFileBytes = 64 * 1024;

std::vector<ServerAddress> serversIn(const std::string& text) {
  std::vector<ServerAddress> servers;
  for (TextLines lines(text); servers.size() < RecentServers::kMaxServers && lines.nextEntry();) {
    try {
      servers.push_back(parseServerAddress(lines.line()));
    } catch (const std::invalid_argument&) {
      continue;  // the player has changed the file
    }
  }
  return servers;
}

}  // namespace

RecentServers::RecentServers(std::filesystem::path file) : file_(std::move(file), kMaxFileBytes) {}

std::vector<ServerAddress> RecentServers::list() const {
  const auto text = file_.read();
  return std::holds_alternative<ParseError>(text) ? std::vector<ServerAddress>()
                                                  : serversIn(std::get<std::string>(text));
}

void RecentServers::remember(const ServerAddress& server) const {
  const auto first = [&](const std::string& kept) {
    std::string text = server.text() + "\n";
    for (const ServerAddress& other : serversIn(kept)) {
      if (other.text() != server.text()) text += other.text() + "\n";
    }
    return text;
  };
  file_.change(first, FileReplacement::Wait::kForDisk);
}

}  // namespace platon
