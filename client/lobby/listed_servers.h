#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <vector>

#include "client/lobby/listed_search.h"
#include "client/lobby/name_lookup.h"
#include "protocol/transport/server_list.h"
#include "protocol/work/worker.h"

namespace platon {

/// Reads a list of servers from a web server, in a thread, and then asks these servers again and again how many play on
/// them. A server that answers under another key than the one of the list is left out.
class ListedServers {
 public:
  /// For so long the names of the servers are looked up. The servers with numeric addresses are asked at once.
  static constexpr Moment kLookupTime = std::chrono::seconds(20);

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
  void update(Moment now);
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
  void take(JobResult<ServerList>& result, Moment now);
  void takeNames(Moment now);
  void ask(const ListedServer& server, const IpAddress& ip);
  void leaveOut(const ListedServer& server, const std::string& why);

  std::string url_;
  NameLookup::Resolve resolve_;
  ServerList list_;
  ListedSearch search_;  // of no server until the list is read
  Worker<ServerList> reading_;
  std::optional<NameLookup> lookup_;  // nothing: all names were looked up
  Moment lookupEnd_{};
};

/// A line for each server: its address in the list, what `describe` says, and its name, in columns.
std::string textOf(const std::vector<FoundServer>& servers);

}  // namespace platon
