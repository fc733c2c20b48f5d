#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include "client/session/known_levels.h"
#include "protocol/files/descriptor.h"
#include "protocol/session_token.h"
#include "protocol/transport/server_address.h"

namespace platon {

/// Keeps the session token of a server on disk, so that a client that has crashed resumes its player at the next start.
/// One file per server, readable only by its owner. The object locks the file while it exists: of two clients on the
/// same server, only the first uses the file, and the second cannot resume the first one's player. It is no KeptFile,
/// which is locked only while it is changed.
class SessionFile {
 public:
  /// Locks the file of this server; creates folder and file if needed. If that fails, or `folder` is empty, the object
  /// stores nothing.
  SessionFile(const std::filesystem::path& folder, const ServerAddress& server);
  ~SessionFile();
  SessionFile(const SessionFile&) = delete;
  SessionFile& operator=(const SessionFile&) = delete;

  /// The stored token, if there is one.
  std::optional<SessionToken> token() const;
  void keep(const SessionToken& token);
  /// Removes the file. The object stores nothing after that. The destructor removes a file without a token.
  void forget();

 private:
  std::filesystem::path path_;
  Descriptor file_;  // none: stores nothing
};

/// Levels that servers have sent, on disk, so that none is sent twice. Each server has a folder of its own, because a
/// client tells a server which levels it has: otherwise, servers could recognise a player by the levels of others. The
/// name of a file is the hash of its text, which is checked when the file is read. A cache that cannot be read or
/// written stores nothing.
class LevelCache : public LevelStore {
 public:
  /// Bounds of all servers together; the levels that were used longest ago are removed.
  static constexpr std::size_t kMaxLevels = 256;
  static constexpr std::uint64_t kMaxBytes = std::uint64_t{64} << 20;

  /// Levels of a server below `folder`; an empty path: none.
  LevelCache(const std::filesystem::path& folder, const ServerAddress& server);

  std::vector<std::uint64_t> newest(std::size_t count) const override;
  std::shared_ptr<const Level> load(std::uint64_t hash) override;
  void keep(const Level& level) override;

 private:
  void limit() const;

  std::filesystem::path all_;     // empty: no cache
  std::filesystem::path folder_;  // of the server
};

}  // namespace platon
