#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "protocol/limits.h"

namespace platon {

/// Where a server is: a host name or IPv4 address, and a UDP port.
struct ServerAddress {
  std::string host;
  std::uint16_t port = kDefaultPort;

  /// "HOST:PORT"
  std::string text() const;
};

/// Reads `HOST[:PORT]`. Throws std::invalid_argument with one sentence saying what is wrong and how it is written.
ServerAddress parseServerAddress(std::string_view text);

}  // namespace platon
