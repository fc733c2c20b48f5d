#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "protocol/files/descriptor.h"
#include "protocol/transport/socket_address.h"
#include "server/net/time_point.h"

namespace platon {

/// Reads `192.0.2.1:19777` or `[2001:db8::1]:19777`; port 0 … 65535. Nothing if the text is no such address.
std::optional<SocketAddress> parseSocketAddress(std::string_view text);

/// Answers `GET /metrics` over HTTP. Never waits.
class MetricsServer {
 public:
  /// Most connections at a time. For another one, the oldest of those that have not asked yet ends, or else the oldest.
  static constexpr std::size_t kMaxConnections = 16;
  /// Time in which a connection must send its request and read the answer.
  static constexpr std::chrono::seconds kConnectionTime{5};

  /// Listens; port 0: any that is free. Throws ProgramError: kFailed if another program uses the address, otherwise
  /// kUsage.
  explicit MetricsServer(const SocketAddress& address);

  /// Accepts connections, and receives and sends what they take. `text` makes the page, once for each request.
  void poll(TimePoint now, const std::function<std::string()>& text);

  /// Where it listens.
  SocketAddress address() const { return address_; }
  std::size_t connections() const { return connections_.size(); }

 private:
  struct Connection {
    Descriptor socket;
    TimePoint end;         // when it is dropped
    std::string request;   // received so far
    std::string response;  // to send
    bool answered = false;
    bool finished = false;  // all is sent; waits for the other end to close
  };

  void accept(TimePoint now);
  void makeRoom();
  static void serve(Connection& connection, TimePoint now, const std::function<std::string()>& text);
  static bool exchange(Connection& connection, const std::function<std::string()>& text);

  SocketAddress address_;
  Descriptor listener_;
  std::vector<Connection> connections_;
};

}  // namespace platon
