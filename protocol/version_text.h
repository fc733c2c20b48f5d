#pragma once

#include <cstdint>
#include <string>

namespace platon {

/// The sentence for a player whose client and server have different versions of `what`, the protocol or the rules:
/// which of them is newer, and which to update.
inline std::string otherVersionText(const std::string& what, std::uint32_t server, std::uint32_t client) {
  const std::string versions =
      " (" + what + " version " + std::to_string(server) + ", your client " + std::to_string(client) + "): ";
  return server > client ? "the server is newer" + versions + "update your client"
                         : "the server is older" + versions + "its owner must update it";
}

}  // namespace platon
