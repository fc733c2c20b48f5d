#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "protocol/transport/socket_address.h"

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

  /// Begins with the first of `hosts`. Where there is no thread, no name has an address.
  explicit NameLookup(std::vector<std::string> hosts, const Resolve& resolve = firstAddressOf);
  /// Ends the lookup after the present name, without waiting for it.
  ~NameLookup();
  NameLookup(const NameLookup&) = delete;
  NameLookup& operator=(const NameLookup&) = delete;

  /// The answers since the last call, in the order of the hosts.
  std::vector<Answer> take();
  /// Whether answers are still to be taken.
  bool isPending() const { return pending_ > 0; }

  /// As the system says.
  static std::optional<IpAddress> firstAddressOf(const std::string& host);

 private:
  struct State;

  std::shared_ptr<State> state_;  // shared with the thread, which may outlive this
  std::size_t pending_;
};

}  // namespace platon
