#pragma once

#include <memory>
#include <string>

#include "client/net/server_address.h"
#include "protocol/transport/noise.h"

namespace platon {

/// A dedicated server on a free loopback port, in a thread of this program.
class EmbeddedServer {
 public:
  /// Starts the server on this level, or on the shipped levels when `levelFile` is empty. Throws ProgramError. When the
  /// file of the level changes, a new round plays it. If it is invalid, the old level stays, and a notice and stderr
  /// say why.
  explicit EmbeddedServer(const std::string& levelFile);
  /// Stops the server.
  ~EmbeddedServer();
  EmbeddedServer(const EmbeddedServer&) = delete;
  EmbeddedServer& operator=(const EmbeddedServer&) = delete;

  ServerAddress address() const;
  /// Public key of the server.
  CryptoKey identity() const;

 private:
  struct Running;
  std::unique_ptr<Running> running_;
};

}  // namespace platon
