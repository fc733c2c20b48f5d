#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "protocol/time.h"
#include "protocol/transport/client_gate.h"

namespace platon {

/// What a client needs of the way to its server: messages of both channels, and whether it still stands. A link is used
/// once; the next attempt needs another one.
class MessageLink {
 public:
  enum class State { kConnecting, kConnected, kClosed };
  using Receiver = std::function<void(std::span<const std::uint8_t>)>;

  /// Why the server does not take the client: a sentence for the player.
  struct Refused {
    std::string reason;
    bool permanent = true;      ///< false: a later attempt may succeed
    bool asksPassword = false;  ///< the server asks for a password, or for another one
  };

  virtual ~MessageLink() = default;

  /// Passes received messages to `receiver`, and sends what is due. Does not block.
  virtual void service(Time now, const Receiver& receiver) = 0;
  /// Sends the queued messages.
  virtual void flush(Time now) = 0;
  /// Queues a message for the next `flush` or `service`. No effect unless connected.
  virtual void send(std::span<const std::uint8_t> message, bool reliable) = 0;
  /// Closes once all queued messages have arrived.
  virtual void close() = 0;

  virtual State state() const = 0;
  /// Set when the client was refused; the state is then kClosed.
  virtual const std::optional<Refused>& refused() const = 0;
  /// The server's identity, once it has proved it.
  virtual std::optional<CryptoKey> identity() const = 0;
  virtual Traffic traffic() const = 0;
};

/// The links to one server.
struct ServerLinks {
  std::string server;  ///< what the player reads of it: "HOST:PORT"
  /// Starts to connect, as one who knows this of the server. Throws std::runtime_error if that is not possible.
  std::function<std::unique_ptr<MessageLink>(const ServerKnowledge&)> connect;
};

}  // namespace platon
