#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "protocol/files/private_file.h"
#include "protocol/transport/noise.h"
#include "protocol/transport/server_address.h"

namespace platon {

/// Remembers the public key of each server that the player has joined, as ssh does, in a text file: a line `HOST:PORT
/// KEY` for each, which the player may remove. Empty lines and lines that begin with '#' are skipped. Any other line is
/// an error: it may be the damaged line of the server that the player joins.
class KnownServers {
 public:
  /// An empty path: remembers nothing.
  explicit KnownServers(std::filesystem::path file);

  /// The key of a server; nothing if it is not known. Throws ProgramError (kUsage) if the file exists and cannot be
  /// read, is larger than 1 MiB or has a damaged line.
  std::optional<CryptoKey> find(const ServerAddress& server) const;
  /// Adds a server that is not known. The file stays as it is if it cannot be changed or if `find` would throw; returns
  /// a sentence about it then, otherwise an empty text.
  std::string remember(const ServerAddress& server, const CryptoKey& key) const;
  const std::filesystem::path& file() const { return file_.path(); }

 private:
  std::optional<CryptoKey> findIn(const std::string& text, const ServerAddress& server) const;

  KeptFile file_;
};

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

/// The levels whose goal the player has reached alone, at any speed, without a time: a text file with the hash of a
/// level in each line. Lines that begin with `#` and those that are no hash are left out. A file that cannot be read
/// has none, and is not written.
class ReachedLevels {
 public:
  /// Most levels; those that were reached first are forgotten.
  static constexpr std::size_t kMaxLevels = 10'000;

  /// Reads the file. An empty path: nothing is kept.
  explicit ReachedLevels(std::filesystem::path file);

  bool has(std::uint64_t level) const;
  /// Adds a level to what the file holds now, unless it is known already. Returns why that failed, a sentence that
  /// names the file, or an empty text. Does not wait for the disk, but for another program that adds one.
  std::string add(std::uint64_t level);

 private:
  KeptFile file_;
  std::vector<std::uint64_t> levels_;  // in the order in which they were reached
};

}  // namespace platon
