#include "client/lobby/listed_servers.h"

#include <sodium.h>

#include <algorithm>
#include <utility>
#include <variant>

#include "client/lobby/download.h"
#include "protocol/label.h"
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

namespace {

// Multicast, broadcast and what is reserved, and the addresses of no machine, which lead to this one.
bool isNoMachine(const IpAddress& ip) {
  if (ip.isIpv4()) return ip.ipv4()[0] == 0 || ip.ipv4()[0] >= 224;
  return ip.bytes[0] == 0xff || ip == IpAddress{};
}

}  // namespace

ListedSearch::ListedSearch(std::unique_ptr<DatagramSocket> socket, std::function<std::uint64_t()> random,
                           bool allowsLoopback)
    : socket_(std::move(socket)), random_(std::move(random)), allowsLoopback_(allowsLoopback) {}

std::string ListedSearch::add(const ListedServer& server, const SocketAddress& address) {
  if (isNoMachine(address.ip)) return "its address is not that of a single machine";
  if (address.ip.isThisMachine() && !allowsLoopback_) return "only a list on this machine may name this machine";
  std::size_t neighbours = 0;
  for (const Target& target : targets_) {
    if (target.address == address && target.listed.key == server.key) return "another entry names this server";
    neighbours += target.address.ip.household() == address.ip.household() ? 1 : 0;
  }
  if (neighbours >= kMaxPerHousehold)
    return "the list has " + std::to_string(kMaxPerHousehold) + " others at its address or in its IPv6 network";
  targets_.push_back({server, address});
  targets_.back().listed.name = visibleLabel(server.name);
  return {};
}

void ListedSearch::update(Time now) {
  takeDatagrams(*socket_, now, [&](const Datagram& datagram) { take(datagram, now); });
  send(now);
}

bool ListedSearch::isDue(const Target& target, Time now) const {
  if (target.tries == 0) return true;
  return (target.found || target.tries < kMaxTries) && now - target.askedAt >= kInterval;
}

void ListedSearch::send(Time now) {
  nextAt_ = std::max(nextAt_, now - kPaceMemory);
  for (std::size_t i = 0; i < targets_.size() && nextAt_ <= now; ++i) {
    Target& target = targets_[next_];
    next_ = (next_ + 1) % targets_.size();
    if (isDue(target, now)) ask(target, now);
  }
  socket_->flush(now);
}

void ListedSearch::ask(Target& target, Time now) {
  if (target.tries == 0) ++asked_;
  ++target.tries;
  ++target.answer.missed;
  target.nonce = random_();
  target.askedAt = now;
  nextAt_ += kPace;
  socket_->send(target.address, encode(Query{target.nonce}), now);
}

void ListedSearch::take(const Datagram& datagram, Time now) {
  const std::optional<Info> info = decodeInfo(datagram.bytes);
  if (!info) return;
  const auto asked = std::find_if(targets_.begin(), targets_.end(), [&](const Target& target) {
    return target.tries > 0 && target.nonce == info->nonce && target.listed.key == info->identity;
  });
  if (asked == targets_.end() || (asked->found && asked->answer.missed == 0)) return;
  if (!asked->found) {
    if (found_.size() >= kMaxServers && !makeRoom()) return;
    found_.push_back(static_cast<std::size_t>(asked - targets_.begin()));
    asked->found = true;
  }
  asked->answer = {datagram.peer, *info, now - asked->askedAt};
}

// Drops the first silent server from those that were found; it has had its tries.
bool ListedSearch::makeRoom() {
  const auto silent =
      std::find_if(found_.begin(), found_.end(), [&](std::size_t i) { return isSilent(targets_[i].answer); });
  if (silent == found_.end()) return false;
  targets_[*silent].found = false;
  found_.erase(silent);
  return true;
}

std::vector<FoundServer> ListedSearch::list() const {
  std::vector<FoundServer> servers;
  for (const std::size_t i : found_) servers.push_back({targets_[i].listed, targets_[i].answer});
  return servers;
}

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

void ListedServers::update(Time now) {
  if (auto result = reading_.poll()) take(*result, now);
  takeNames(now);
  search_.update(now);
}

void ListedServers::take(JobResult<ServerList>& result, Time now) {
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

void ListedServers::takeNames(Time now) {
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
    list_.faults.emplace_back("some servers of the list are left out: their names were not resolved in time");
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
