#pragma once

#include <filesystem>
#include <optional>

#include "protocol/files/descriptor.h"
#include "protocol/session_token.h"
#include "protocol/transport/server_address.h"

namespace platon {

/// Keeps the session token of a server on disk, so that a client that has crashed resumes its player at the next start.
/// One file per server, readable only by its owner. The object locks the file while it exists: of two clients on the
/// same server, only the first uses the file, and the second cannot resume the first one's player.
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

}  // namespace platon
