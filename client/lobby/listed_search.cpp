#include "client/lobby/listed_search.h"

#include <algorithm>
#include <utility>

#include "protocol/label.h"

namespace platon {
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
  if (isNoMachine(address.ip)) return "its address is not one of a single machine";
  if (address.ip.isThisMachine() && !allowsLoopback_) return "only a list of this machine may name this machine";
  std::size_t neighbours = 0;
  for (const Target& target : targets_) {
    if (target.address == address && target.listed.key == server.key) return "another entry names this server";
    neighbours += target.address.ip.household() == address.ip.household() ? 1 : 0;
  }
  if (neighbours >= kMaxPerHousehold)
    return "the list has " + std::to_string(kMaxPerHousehold) + " others in its household";
  targets_.push_back({server, address});
  targets_.back().listed.name = visibleLabel(server.name);
  return {};
}

void ListedSearch::update(Moment now) {
  takeDatagrams(*socket_, now, [&](const Datagram& datagram) { take(datagram, now); });
  send(now);
}

bool ListedSearch::isDue(const Target& target, Moment now) const {
  if (target.tries == 0) return true;
  return (target.found || target.tries < kMaxTries) && now - target.askedAt >= kInterval;
}

void ListedSearch::send(Moment now) {
  nextAt_ = std::max(nextAt_, now - kPaceMemory);
  for (std::size_t i = 0; i < targets_.size() && nextAt_ <= now; ++i) {
    Target& target = targets_[next_];
    next_ = (next_ + 1) % targets_.size();
    if (isDue(target, now)) ask(target, now);
  }
  socket_->flush(now);
}

void ListedSearch::ask(Target& target, Moment now) {
  if (target.tries == 0) ++asked_;
  ++target.tries;
  ++target.answer.missed;
  target.nonce = random_();
  target.askedAt = now;
  nextAt_ += kPace;
  socket_->send(target.address, encode(Query{target.nonce}), now);
}

void ListedSearch::take(const Datagram& datagram, Moment now) {
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

}  // namespace platon
