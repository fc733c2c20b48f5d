#include "client/play/known_servers.h"

#include <fstream>
#include <sstream>

#include "protocol/transport/server_identity.h"

namespace platon {

std::optional<CryptoKey> KnownServers::find(const ServerAddress& server) const {
  std::ifstream file(file_);
  for (std::string line; std::getline(file, line);) {
    std::istringstream words(line);
    std::string address;
    std::string key;
    if (words >> address >> key && address == server.text()) return keyOf(key);
  }
  return std::nullopt;
}

void KnownServers::remember(const ServerAddress& server, const CryptoKey& key) const {
  if (file_.empty() || find(server)) return;
  std::error_code ignored;  // the file cannot be opened then
  std::filesystem::create_directories(file_.parent_path(), ignored);
  std::ofstream file(file_, std::ios::app);
  file << server.text() + " " + textOf(key) + "\n";
}

}  // namespace platon
