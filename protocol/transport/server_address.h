#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "protocol/limits.h"

namespace platon {

/// Address of a server: a host name or IP address, and a UDP port.
struct ServerAddress {
  std::string host;
  std::uint16_t port = kDefaultPort;

  /// "HOST:PORT", or "[HOST]:PORT" for an IPv6 address.
  std::string text() const;

  friend bool operator==(const ServerAddress&, const ServerAddress&) = default;
};

/// Parses `HOST[:PORT]`, where an IPv6 address with a port is in brackets. Throws std::invalid_argument with a sentence
/// that names the error and the format.
ServerAddress parseServerAddress(std::string_view text);

/// Whether a text is such an address, of at most kMaxNextServerBytes: a server may tell its players to go on there.
bool isNextServer(std::string_view text);

}  // namespace platon
