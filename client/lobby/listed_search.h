#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "client/lobby/near_servers.h"
#include "protocol/transport/server_list.h"

namespace platon {

/// A server of a list that has answered under the key that the list has for it.
struct FoundServer {
  ListedServer listed;
  NearServer answer;
};

/// Asks the servers of a list again and again how many play on them. Whoever makes the list chooses who is asked, so
/// the work is bounded: a list must not turn those who read it into a flood.
class ListedSearch {
 public:
  static constexpr std::size_t kMaxServers = NearServers::kMaxServers;
  static constexpr std::size_t kMaxPerHousehold = 16;            ///< servers of an IPv4 address or of 64 bits of IPv6
  static constexpr std::size_t kMaxTries = 3;                    ///< queries to a server that never answers
  static constexpr Moment kInterval = NearServers::kInterval;    ///< between two queries to a server
  static constexpr Moment kPace = std::chrono::milliseconds(3);  ///< between two queries on average
  static constexpr Moment kPaceMemory = std::chrono::milliseconds(48);  ///< for so long unsent queries are made up for

  /// `random` returns numbers that others cannot guess. `allowsLoopback`: the list is one of this machine.
  ListedSearch(std::unique_ptr<DatagramSocket> socket, std::function<std::uint64_t()> random, bool allowsLoopback);

  /// Asks a server at this address, too. Returns a clause with the reason if it is not asked; else an empty text.
  std::string add(const ListedServer& server, const SocketAddress& address);
  /// Sends what is due and takes the answers that have arrived.
  void update(Moment now);
  /// Whether a server has not been asked yet.
  bool isBehind() const { return asked_ < targets_.size(); }
  /// In the order in which they have answered first, at most kMaxServers. A silent one keeps its place until a new one
  /// needs it.
  std::vector<FoundServer> list() const;

  DatagramSocket& socket() { return *socket_; }

 private:
  struct Target {
    ListedServer listed;
    SocketAddress address;
    std::size_t tries = 0;
    std::uint64_t nonce = 0;  // of the last query; no other target learns it
    Moment askedAt{};
    bool found = false;  // it is in found_
    NearServer answer{};
  };

  bool isDue(const Target& target, Moment now) const;
  void ask(Target& target, Moment now);
  void send(Moment now);
  void take(const Datagram& datagram, Moment now);
  bool makeRoom();

  std::unique_ptr<DatagramSocket> socket_;
  std::function<std::uint64_t()> random_;
  bool allowsLoopback_;
  std::vector<Target> targets_;
  std::vector<std::size_t> found_;  // indices of targets
  std::size_t asked_ = 0;           // targets that were asked at least once
  std::size_t next_ = 0;            // the target whose turn it is
  Moment nextAt_{};                 // when the next query may be sent
};

}  // namespace platon
