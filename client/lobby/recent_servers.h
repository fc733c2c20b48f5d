#pragma once

#include <cstddef>
#include <filesystem>
#include <vector>

#include "protocol/files/kept_file.h"
#include "protocol/transport/server_address.h"

namespace platon {

/// The servers that the player has joined, the newest first, in a text file with an address `HOST:PORT` in each line.
/// Lines that are no address are ignored.
class RecentServers {
 public:
  static constexpr std::size_t kMaxServers = 6;

  /// An empty path: remembers nothing.
  explicit RecentServers(std::filesystem::path file);

  /// At most kMaxServers; none if the file cannot be read.
  std::vector<ServerAddress> list() const;
  /// Puts a server first. The file stays as it is if it cannot be read or written.
  void remember(const ServerAddress& server) const;

 private:
  KeptFile file_;
};

}  // namespace platon
