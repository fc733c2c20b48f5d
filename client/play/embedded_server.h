#pragma once

#include <memory>
#include <string>

#include "client/net/server_address.h"

namespace platon {

/// A server of the player's own: the same as a dedicated one, on a loopback port, in a thread of this program.
class EmbeddedServer {
 public:
  /// Starts it on this level, or on the rotation that comes with the game when `levelFile` is empty. Throws
  /// ProgramError.
  explicit EmbeddedServer(const std::string& levelFile);
  /// Stops it.
  ~EmbeddedServer();
  EmbeddedServer(const EmbeddedServer&) = delete;
  EmbeddedServer& operator=(const EmbeddedServer&) = delete;

  ServerAddress address() const;

 private:
  struct Running;
  std::unique_ptr<Running> running_;
};

}  // namespace platon
