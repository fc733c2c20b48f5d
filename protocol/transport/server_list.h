#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "protocol/files/word_reader.h"
#include "protocol/transport/server_address.h"
#include "protocol/transport/server_identity.h"

namespace platon {

inline constexpr std::size_t kMaxListedServers = 1000;
inline constexpr std::size_t kMaxServerListBytes = std::size_t{1} << 19;

/// A server in a list: where it is, its name, a label, and its public key, signed with the secret of that key. Who
/// makes a list can leave servers out, but cannot list one under a key that it does not have.
struct ListedServer {
  ServerAddress address;
  std::string name;
  CryptoKey key{};
  Signature signature{};

  friend bool operator==(const ListedServer&, const ListedServer&) = default;
};

/// The signed entry of the server with this identity.
ListedServer listedServer(const ServerIdentity& identity, const ServerAddress& address, std::string_view name);

/// The list as JSON, for any web server:
///
///     {"platonServers": [{"address": "play.example.org:7777", "name": "Example", "key": "…", "signature": "…"}]}
std::string serverListText(const std::vector<ListedServer>& servers);

/// What a text holds.
struct ServerList {
  std::vector<ListedServer> servers;
  std::vector<std::string> faults;  ///< a sentence for each entry that was left out
};

/// Reads such a text. Leaves out an entry that is damaged, whose signature is not that of its key, or whose address
/// another entry has. Skips keys of objects that it does not know. An error if the text is no list at all.
std::variant<ServerList, ParseError> readServerList(std::string_view text);

}  // namespace platon
