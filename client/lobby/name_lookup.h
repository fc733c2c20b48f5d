#pragma once

#include <cstddef>
#include <deque>
#include <functional>
#include <optional>
#include <string>
#include <vector>

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

}  // namespace platon
