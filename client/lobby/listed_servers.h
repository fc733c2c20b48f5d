#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "client/lobby/near_servers.h"
#include "protocol/transport/server_list.h"
#include "protocol/transport/socket_address.h"
#include "protocol/work/worker.h"

namespace platon {

/// Finds the addresses of machines by their names, one after the other in a thread. The system may take half a minute
/// for a single name, and cannot be told to stop.
class NameLookup {
 public:
  /// The first address of a name; nothing if it has none. One that throws counts as nothing. Called in the thread.
  using Resolve = std::function<std::optional<IpAddress>(const std::string& host)>;
  struct Answer {
    std::string host;
    std::optional<IpAddress> address;  ///< nothing: none was found
  };

  /// Begins with the first of `hosts`. The destructor ends the lookup after the present name, without waiting for it.
  explicit NameLookup(std::vector<std::string> hosts, const Resolve& resolve = firstAddressOf);

  /// The answers since the last call, in the order of the hosts.
  std::vector<Answer> take();
  /// Whether answers are still to be taken.
  bool isPending() const { return finding_.isPending(); }

  /// As the system says.
  static std::optional<IpAddress> firstAddressOf(const std::string& host);

 private:
  std::deque<std::string> hosts_;  // whose answers have not been taken
  Worker<std::optional<IpAddress>> finding_;
};

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
  static constexpr std::size_t kMaxPerHousehold = 16;          ///< servers of an IPv4 address or of 64 bits of IPv6
  static constexpr std::size_t kMaxTries = 3;                  ///< queries to a server that never answers
  static constexpr Time kInterval = NearServers::kInterval;    ///< between two queries to a server
  static constexpr Time kPace = std::chrono::milliseconds(3);  ///< between two queries on average
  static constexpr Time kPaceMemory = std::chrono::milliseconds(48);  ///< for so long unsent queries are made up for

  /// `random` returns numbers that others cannot guess. `allowsLoopback`: the list is one of this machine.
  ListedSearch(std::unique_ptr<DatagramSocket> socket, std::function<std::uint64_t()> random, bool allowsLoopback);

  /// Asks a server at this address, too. Returns a clause with the reason if it is not asked; else an empty text.
  std::string add(const ListedServer& server, const SocketAddress& address);
  /// Sends what is due and takes the answers that have arrived.
  void update(Time now);
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
    Time askedAt{};
    bool found = false;  // it is in found_
    NearServer answer{};
  };

  bool isDue(const Target& target, Time now) const;
  void ask(Target& target, Time now);
  void send(Time now);
  void take(const Datagram& datagram, Time now);
  bool makeRoom();

  std::unique_ptr<DatagramSocket> socket_;
  std::function<std::uint64_t()> random_;
  bool allowsLoopback_;
  std::vector<Target> targets_;
  std::vector<std::size_t> found_;  // indices of targets
  std::size_t asked_ = 0;           // targets that were asked at least once
  std::size_t next_ = 0;            // the target whose turn it is
  Time nextAt_{};                   // when the next query may be sent
};

/// Reads a list of servers from a web server, in a thread, and then asks these servers again and again how many play on
/// them. A server that answers under another key than the one of the list is left out.
class ListedServers {
 public:
  /// For so long the names of the servers are looked up. The servers with numeric addresses are asked at once.
  static constexpr Time kLookupTime = std::chrono::seconds(20);

  /// Begins to read the list at a URL, in a thread that `start` starts. The destructor ends the reading, which may take
  /// a second, and does not wait for names that are looked up. Throws SocketError.
  explicit ListedServers(std::string url, NameLookup::Resolve resolve = NameLookup::firstAddressOf,
                         ThreadStart start = &startThread);
  ListedServers(const ListedServers&) = delete;
  ListedServers& operator=(const ListedServers&) = delete;

  /// Ends the reading without waiting for it, for a caller that cannot wait: afterwards only hasStopped may be called.
  void stop() { reading_.drop(); }
  /// Whether the destructor need not wait any more.
  bool hasStopped() const { return reading_.isIdle(); }

  /// Sends what is due and takes what has arrived.
  void update(Time now);
  /// Sleeps until something may have arrived, at most so long.
  void wait(std::chrono::milliseconds time) { search_.socket().wait(time); }
  /// Whether the list is still being read, or a server in it has not been asked yet.
  bool reading() const { return reading_.isPending() || lookup_ || search_.isBehind(); }
  /// Sentences on why the list, or servers in it, are left out.
  const std::vector<std::string>& faults() const { return list_.faults; }
  /// In the order in which they have answered first; at most ListedSearch::kMaxServers.
  std::vector<FoundServer> list() const { return search_.list(); }
  /// The key that the list has for this address; nothing if it has none.
  std::optional<CryptoKey> keyOf(const ServerAddress& address) const;

 private:
  void take(JobResult<ServerList>& result, Time now);
  void takeNames(Time now);
  void ask(const ListedServer& server, const IpAddress& ip);
  void leaveOut(const ListedServer& server, const std::string& why);

  std::string url_;
  NameLookup::Resolve resolve_;
  ServerList list_;
  ListedSearch search_;  // of no server until the list is read
  Worker<ServerList> reading_;
  std::optional<NameLookup> lookup_;  // nothing: all names were looked up
  Time lookupEnd_{};
};

/// A line for each server: its address in the list, what `describe` says, and its name, in columns.
std::string textOf(const std::vector<FoundServer>& servers);

}  // namespace platon
