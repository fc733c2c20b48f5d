#pragma once

#include <filesystem>
#include <optional>

#include "client/net/server_address.h"
#include "protocol/session_token.h"

namespace platon {

/// Where the token of a server's player outlives the program: after a crash the next start has it and gets the player
/// back. One file a server, for its owner's eyes only. It is locked as long as this lives, so that of two programs
/// that play on the same server at once only the first has the file: the other must not take its player.
class SessionFile {
 public:
  /// Takes hold of the file of this server, making folder and file. Where that is not to be had, or the folder is
  /// empty, all the rest has no effect.
  SessionFile(const std::filesystem::path& folder, const ServerAddress& server);
  ~SessionFile();
  SessionFile(const SessionFile&) = delete;
  SessionFile& operator=(const SessionFile&) = delete;

  /// What was kept last and not forgotten.
  std::optional<SessionToken> token() const;
  void keep(const SessionToken& token);
  /// Removes the file, and lets go of it: nothing is kept after that. An empty one goes by itself.
  void forget();

 private:
  std::filesystem::path path_;
  int handle_ = -1;  // -1: none
};

}  // namespace platon
