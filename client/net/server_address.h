#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "protocol/limits.h"

namespace platon {

/// Address of a server: a host name or IPv4 address, and a UDP port.
struct ServerAddress {
  std::string host;
  std::uint16_t port = kDefaultPort;

  /// "HOST:PORT"
  std::string text() const;
};

/// Parses `HOST[:PORT]`. Throws std::invalid_argument with a sentence that names the error and the format.
ServerAddress parseServerAddress(std::string_view text);

}  // namespace platon
