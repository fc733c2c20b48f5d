#include "client/lobby/listed_servers.h"

#include <sodium.h>

#include <algorithm>
#include <memory>
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

// The names, each once.
std::vector<std::string> namesIn(const std::vector<ListedServer>& servers) {
  std::vector<std::string> names;
  for (const ListedServer& server : servers) {
    const std::string& host = server.address.host;
    if (!IpAddress::parse(host) && std::find(names.begin(), names.end(), host) == names.end()) names.push_back(host);
  }
  return names;
}

ServerList readAt(const std::string& url, const std::stop_token& stop) {
  auto read = readServerList(download(url, kMaxServerListBytes, stop));
  if (const auto* error = std::get_if<ParseError>(&read)) throw DownloadError(error->what);
  return std::get<ServerList>(std::move(read));
}

}  // namespace

ListedServers::ListedServers(std::string url, NameLookup::Resolve resolve, ThreadStart start)
    : url_(std::move(url)),
      resolve_(std::move(resolve)),
      search_(std::make_unique<UdpSocket>(), randomNumber, isOfThisMachine(url_)),
      reading_(std::move(start)) {
  reading_.add([url = url_](const std::stop_token& stop) { return readAt(url, stop); });
}

void ListedServers::update(Moment now) {
  if (auto result = reading_.poll()) take(*result, now);
  takeNames(now);
  search_.update(now);
}

void ListedServers::take(JobResult<ServerList>& result, Moment now) {
  if (!result.value) {
    list_.faults = {"cannot read the list of servers at " + url_ + ": " + result.fault};
    return;
  }
  list_ = std::move(*result.value);
  for (const ListedServer& server : list_.servers) {
    if (const auto ip = IpAddress::parse(server.address.host)) ask(server, *ip);
  }
  lookup_.emplace(namesIn(list_.servers), resolve_);
  lookupEnd_ = now + kLookupTime;
}

void ListedServers::takeNames(Moment now) {
  if (!lookup_) return;
  for (const NameLookup::Answer& answer : lookup_->take()) {
    for (const ListedServer& server : list_.servers) {
      if (server.address.host != answer.host) continue;
      if (answer.address)
        ask(server, *answer.address);
      else
        leaveOut(server, "no address was found for its name");
    }
  }
  if (lookup_->isPending() && now >= lookupEnd_)
    list_.faults.emplace_back("servers of the list are left out: their names were not found in time");
  if (!lookup_->isPending() || now >= lookupEnd_) lookup_.reset();
}

void ListedServers::ask(const ListedServer& server, const IpAddress& ip) {
  const std::string why = search_.add(server, {ip, server.address.port});
  if (!why.empty()) leaveOut(server, why);
}

void ListedServers::leaveOut(const ListedServer& server, const std::string& why) {
  list_.faults.push_back("server " + server.address.text() + " of the list is left out: " + why);
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
