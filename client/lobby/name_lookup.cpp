#include "client/lobby/name_lookup.h"

#include <utility>

#include "protocol/transport/udp_socket.h"

namespace platon {

NameLookup::NameLookup(std::vector<std::string> hosts, const Resolve& resolve)
    : hosts_(hosts.begin(), hosts.end()), finding_(startThread, std::chrono::milliseconds(0)) {
  for (std::string& host : hosts) {
    finding_.add([resolve, name = std::move(host)](const std::stop_token&) { return resolve(name); });
  }
}

std::vector<NameLookup::Answer> NameLookup::take() {
  std::vector<Answer> answers;
  for (auto found = finding_.poll(); found; found = finding_.take()) {
    answers.push_back({std::move(hosts_.front()), found->value.value_or(std::nullopt)});
    hosts_.pop_front();
  }
  return answers;
}

std::optional<IpAddress> NameLookup::firstAddressOf(const std::string& host) {
  try {
    return resolve(host, 0).front().ip;
  } catch (const SocketError&) {
    return std::nullopt;
  }
}

}  // namespace platon
