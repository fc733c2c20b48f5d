#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "protocol/transport/noise.h"
#include "protocol/transport/server_address.h"

namespace platon {

/// Remembers the public key of each server that the player has joined, as ssh does, in a text file: a line `HOST:PORT
/// KEY` for each, which the player may remove. Empty lines and lines that begin with '#' are skipped. Any other line is
/// an error: it may be the damaged line of the server that the player joins.
class KnownServers {
 public:
  /// An empty path: remembers nothing.
  explicit KnownServers(std::filesystem::path file) : file_(std::move(file)) {}

  /// The key of a server; nothing if it is not known. Throws ProgramError (kUsage) if the file exists and cannot be
  /// read, is larger than 1 MiB or has a damaged line.
  std::optional<CryptoKey> find(const ServerAddress& server) const;
  /// Adds a server that is not known. The file stays as it is if it cannot be written, if another program keeps its
  /// lock for kLockTime, or if `find` would throw; returns a sentence about it then, otherwise an empty text. Lines
  /// that other clients add at the same time are kept.
  std::string remember(const ServerAddress& server, const CryptoKey& key) const;
  const std::filesystem::path& file() const { return file_; }

 private:
  std::string read() const;
  std::string faultOf(const std::string& reason) const;
  std::optional<CryptoKey> findIn(const std::string& text, const ServerAddress& server) const;

  std::filesystem::path file_;
};

}  // namespace platon
