#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "protocol/time.h"
#include "protocol/transport/datagram_socket.h"
#include "protocol/transport/handshake.h"
#include "protocol/transport/socket_address.h"

namespace platon {

/// Addresses at which other machines may reach this one, IPv4 first: without loopback and without addresses that are
/// valid on one link only.
std::vector<std::string> ownAddresses();

/// Addresses that all machines of an IPv4 network receive, of each network that this machine is in.
std::vector<IpAddress> broadcastAddresses();

/// A server that has answered a search.
struct NearServer {
  SocketAddress address;
  Info info;
  Time roundTrip{};
  std::size_t missed = 0;  ///< searches since its last answer
};

/// Searches for servers on this machine and in its networks: asks addresses that many machines receive, again and
/// again, what docs/protocol.md calls Query. The answers are not authenticated: anybody in these networks can invent
/// one.
class NearServers {
 public:
  static constexpr std::size_t kMaxServers = 32;
  static constexpr Time kInterval = std::chrono::seconds(2);
  /// Datagrams that one update takes, so that a flood of answers does not keep its caller.
  static constexpr int kMaxDatagrams = 256;
  static constexpr std::size_t kPatience = 3;  ///< searches without an answer until a server counts as silent

  /// Sends each query from `socket` to all `targets`. `nonce` is a random number that others cannot guess.
  NearServers(std::unique_ptr<DatagramSocket> socket, std::vector<SocketAddress> targets, std::uint64_t nonce);

  /// Sends what is due and takes the answers that have arrived.
  void update(Time now);
  /// In the order in which they have answered first; each server once, by its identity and port. A silent one keeps its
  /// place, so that no other moves under the player's finger, until a new one needs it.
  const std::vector<NearServer>& list() const { return found_; }

  DatagramSocket& socket() { return *socket_; }

 private:
  void search(Time now);
  void take(const Datagram& datagram, Time now);

  std::unique_ptr<DatagramSocket> socket_;
  std::vector<SocketAddress> targets_;
  std::uint64_t nonce_;  // of the present search; it differs from one to the next
  std::optional<Time> searchedAt_;
  std::vector<NearServer> found_;
};

/// Hands each datagram that has arrived at a socket to `take`, at most NearServers::kMaxDatagrams of them.
template <class Take>
void takeDatagrams(DatagramSocket& socket, Time now, Take take) {
  for (int i = 0; i < NearServers::kMaxDatagrams; ++i) {
    const std::optional<Datagram> datagram = socket.receive(now);
    if (!datagram) return;
    take(*datagram);
  }
}

inline constexpr std::uint16_t kNearPorts = 4;
/// A search on this machine and in its IPv4 networks, on kNearPorts ports from the default one on.
NearServers searchNearby();

bool isSilent(const NearServer& server);
/// "2/8 players, 3 ms", and what keeps a player out: "password", "newer version" or "older version" of the protocol; or
/// "no answer".
std::string describe(const NearServer& server);
/// What a line of a printed list says of a server.
struct ServerRow {
  std::string address;
  std::string about;
  std::string name;
};
/// The rows, in columns.
std::string textOf(const std::vector<ServerRow>& rows);
/// A line for each server: its address, what `describe` says, and its name, in columns.
std::string textOf(const std::vector<NearServer>& servers);

}  // namespace platon
