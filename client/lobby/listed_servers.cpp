#include "client/lobby/listed_servers.h"

#include <sodium.h>

#include <algorithm>
#include <utility>
#include <variant>

#include "client/lobby/download.h"
#include "protocol/transport/udp_socket.h"

namespace platon {

namespace {

std::uint64_t randomNumber() {
  std::uint64_t number = 0;
  randombytes_buf(&number, sizeof number);
  return number;
}

// The first address of each; a name that is not known has none.
std::vector<SocketAddress> targetsOf(const std::vector<ListedServer>& servers, const std::stop_token& stop) {
  std::vector<SocketAddress> targets;
  for (const ListedServer& server : servers) {
    if (stop.stop_requested()) break;
    try {
      targets.push_back(resolve(server.address.host, server.address.port).front());
    } catch (const SocketError&) {
      continue;
    }
  }
  return targets;
}

ServerList readAt(const std::string& url, const std::stop_token& stop) {
  auto read = readServerList(download(url, kMaxServerListBytes, stop));
  if (const auto* error = std::get_if<ParseError>(&read)) throw DownloadError(error->what);
  return std::get<ServerList>(std::move(read));
}

}  // namespace

ListedServers::ListedServers(std::string url)
    : url_(std::move(url)),
      search_(std::make_unique<UdpSocket>(), {}, randomNumber()),
      job_([url = url_](const std::stop_token& stop) {
        Reading reading{readAt(url, stop), {}};
        reading.targets = targetsOf(reading.list.servers, stop);
        return reading;
      }) {}

void ListedServers::update(Moment now) {
  if (auto result = job_.poll()) take(*result);
  search_.update(now);
}

void ListedServers::take(JobResult<Reading>& result) {
  if (!result.value) {
    list_.faults = {"cannot read the list of servers at " + url_ + ": " + result.fault};
    return;
  }
  list_ = std::move(result.value->list);
  search_.setTargets(std::move(result.value->targets));
}

std::vector<FoundServer> ListedServers::list() const {
  std::vector<FoundServer> found;
  for (const NearServer& answer : search_.list()) {
    const auto listed = std::find_if(list_.servers.begin(), list_.servers.end(), [&](const ListedServer& server) {
      return server.key == answer.info.identity && server.address.port == answer.address.port;
    });
    if (listed != list_.servers.end()) found.push_back({*listed, answer});
  }
  return found;
}

std::optional<CryptoKey> ListedServers::keyOf(const ServerAddress& address) const {
  const auto listed = std::find_if(list_.servers.begin(), list_.servers.end(),
                                   [&](const ListedServer& server) { return server.address == address; });
  return listed == list_.servers.end() ? std::nullopt : std::optional(listed->key);
}

std::string textOf(const std::vector<FoundServer>& servers) {
  std::vector<ServerRow> rows;
  for (const FoundServer& server : servers)
    rows.push_back({server.listed.address.text(), describe(server.answer), server.listed.name});
  return textOf(rows);
}

}  // namespace platon
