#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <vector>

#include "client/job/job.h"
#include "client/lobby/near_servers.h"
#include "protocol/transport/server_list.h"

namespace platon {

/// A server of a list that has answered under the key that the list has for it.
struct FoundServer {
  ListedServer listed;
  NearServer answer;
};

/// Reads a list of servers from a web server, in a thread, and then asks these servers again and again how many play on
/// them. A server that answers under another key than the one of the list is left out.
class ListedServers {
 public:
  /// Begins to read the list at a URL. The destructor ends the reading, which may take a second.
  /// Throws SocketError.
  explicit ListedServers(std::string url);

  /// Sends what is due and takes what has arrived.
  void update(Moment now);
  /// Sleeps until something may have arrived, at most so long.
  void wait(std::chrono::milliseconds time) { search_.socket().wait(time); }
  /// Whether the list is still being read.
  bool reading() const { return job_.isPending(); }
  /// Sentences on why the list, or servers in it, are left out.
  const std::vector<std::string>& faults() const { return list_.faults; }
  /// In the order in which they have answered first; at most NearServers::kMaxServers.
  std::vector<FoundServer> list() const;
  /// The key that the list has for this address; nothing if it has none.
  std::optional<CryptoKey> keyOf(const ServerAddress& address) const;

 private:
  struct Reading {
    ServerList list;
    std::vector<SocketAddress> targets;  // of the servers whose names are known
  };

  void take(JobResult<Reading>& result);

  std::string url_;
  ServerList list_;
  NearServers search_;  // at no address until the list is read
  Job<Reading> job_;
};

/// A line for each server: its address in the list, what `describe` says, and its name, in columns.
std::string textOf(const std::vector<FoundServer>& servers);

}  // namespace platon
