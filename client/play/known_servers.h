#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "client/net/server_address.h"
#include "protocol/transport/noise.h"

namespace platon {

/// Remembers the public key of each server that the player has joined, as ssh does, in a text file: a line `HOST:PORT
/// KEY` for each, which the player may remove.
class KnownServers {
 public:
  /// An empty path: remembers nothing.
  explicit KnownServers(std::filesystem::path file) : file_(std::move(file)) {}

  /// The key of a server; nothing if it is not known, or the file cannot be read.
  std::optional<CryptoKey> find(const ServerAddress& server) const;
  /// Adds a server that is not known. Does nothing if the file cannot be written.
  void remember(const ServerAddress& server, const CryptoKey& key) const;
  const std::filesystem::path& file() const { return file_; }

 private:
  std::filesystem::path file_;
};

}  // namespace platon
