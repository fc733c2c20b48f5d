#include "client/lobby/near_servers.h"

#include <ifaddrs.h>
#include <net/if.h>
#include <netinet/in.h>
#include <sodium.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstring>
#include <utility>

#include "protocol/label.h"
#include "protocol/limits.h"
#include "protocol/transport/udp_socket.h"

namespace platon {

namespace {

IpAddress ipv4Of(const sockaddr& address) {
  sockaddr_in ipv4{};
  std::memcpy(&ipv4, &address, sizeof ipv4);
  std::array<std::uint8_t, 4> bytes{};
  std::memcpy(bytes.data(), &ipv4.sin_addr, bytes.size());
  return IpAddress::ofIpv4(bytes);
}

std::optional<IpAddress> addressOf(const ifaddrs& each) {
  if (each.ifa_addr == nullptr || (each.ifa_flags & IFF_UP) == 0 || (each.ifa_flags & IFF_LOOPBACK) != 0) return {};
  if (each.ifa_addr->sa_family == AF_INET) return ipv4Of(*each.ifa_addr);
  if (each.ifa_addr->sa_family != AF_INET6) return {};
  sockaddr_in6 ipv6{};
  std::memcpy(&ipv6, each.ifa_addr, sizeof ipv6);
  if (IN6_IS_ADDR_LINKLOCAL(&ipv6.sin6_addr)) return {};
  IpAddress address;
  std::memcpy(address.bytes.data(), &ipv6.sin6_addr, address.bytes.size());
  return address;
}

// Loopback has no broadcast address here: the flag is missing, and another machine cannot be reached by it.
std::optional<IpAddress> broadcastOf(const ifaddrs& each) {
  if (each.ifa_addr == nullptr || each.ifa_addr->sa_family != AF_INET || each.ifa_broadaddr == nullptr) return {};
  if ((each.ifa_flags & IFF_UP) == 0 || (each.ifa_flags & IFF_BROADCAST) == 0) return {};
  return ipv4Of(*each.ifa_broadaddr);
}

// What `find` says of each address of each network interface, where it says something.
template <class Find>
std::vector<IpAddress> allOf(Find find) {
  ifaddrs* first = nullptr;
  if (getifaddrs(&first) != 0) return {};
  const std::unique_ptr<ifaddrs, void (*)(ifaddrs*)> all(first, freeifaddrs);
  std::vector<IpAddress> found;
  for (const ifaddrs* each = first; each != nullptr; each = each->ifa_next) {
    if (const std::optional<IpAddress> address = find(*each)) found.push_back(*address);
  }
  return found;
}

}  // namespace

std::vector<std::string> ownAddresses() {
  std::vector<IpAddress> found = allOf(addressOf);
  std::stable_partition(found.begin(), found.end(), [](const IpAddress& address) { return address.isIpv4(); });
  std::vector<std::string> texts;
  for (const IpAddress& address : found) texts.push_back(address.text());
  return texts;
}

std::vector<IpAddress> broadcastAddresses() { return allOf(broadcastOf); }

NearServers::NearServers(std::unique_ptr<DatagramSocket> socket, std::vector<SocketAddress> targets,
                         std::uint64_t nonce)
    : socket_(std::move(socket)), targets_(std::move(targets)), nonce_(nonce) {}

void NearServers::update(Time now) {
  takeDatagrams(*socket_, now, [&](const Datagram& datagram) { take(datagram, now); });
  if (!searchedAt_ || now - *searchedAt_ >= kInterval) search(now);
}

void NearServers::search(Time now) {
  for (NearServer& server : found_) ++server.missed;
  ++nonce_;
  searchedAt_ = now;
  const Bytes query = encode(Query{nonce_});
  for (const SocketAddress& target : targets_) socket_->send(target, query, now);
  socket_->flush(now);
}

void NearServers::take(const Datagram& datagram, Time now) {
  std::optional<Info> info = decodeInfo(datagram.bytes);
  if (!info || info->nonce != nonce_ || !searchedAt_) return;
  info->name = visibleLabel(info->name);
  const auto known = std::find_if(found_.begin(), found_.end(), [&](const NearServer& server) {
    return server.info.identity == info->identity && server.address.port == datagram.peer.port;
  });
  const NearServer server{datagram.peer, *info, now - *searchedAt_};
  if (known == found_.end()) {
    const auto silent = std::find_if(found_.begin(), found_.end(), isSilent);
    if (found_.size() < kMaxServers)
      found_.push_back(server);
    else if (silent != found_.end())
      *silent = server;
  } else if (known->missed != 0) {  // else a second answer: a server may receive a query at several addresses
    *known = server;
  }
}

NearServers searchNearby() {
  auto socket = std::make_unique<UdpSocket>();
  socket->allowBroadcast();
  std::vector<IpAddress> machines{IpAddress::ofIpv4({127, 0, 0, 1})};
  for (const IpAddress& network : broadcastAddresses()) machines.push_back(network);
  std::vector<SocketAddress> targets;
  for (const IpAddress& machine : machines) {
    for (std::uint16_t i = 0; i < kNearPorts; ++i)
      targets.push_back({machine, static_cast<std::uint16_t>(kDefaultPort + i)});
  }
  std::uint64_t nonce = 0;
  randombytes_buf(&nonce, sizeof nonce);
  return {std::move(socket), std::move(targets), nonce};
}

bool isSilent(const NearServer& server) { return server.missed > NearServers::kPatience; }

std::string describe(const NearServer& server) {
  if (isSilent(server)) return "no answer";
  const auto milliseconds = std::chrono::round<std::chrono::milliseconds>(server.roundTrip).count();
  std::string text = std::to_string(server.info.players) + "/" + std::to_string(server.info.maxPlayers) + " players, " +
                     std::to_string(milliseconds) + " ms";
  if (server.info.needsPassword) text += ", password";
  if (server.info.version != kProtocolVersion)
    text += server.info.version > kProtocolVersion ? ", newer version" : ", older version";
  return text;
}

std::string textOf(const std::vector<ServerRow>& rows) {
  std::string text;
  for (const ServerRow& row : rows) {
    std::string line = row.address;
    line.resize(std::max<std::size_t>(line.size() + 2, 24), ' ');
    line += row.about;
    if (!row.name.empty()) line.resize(std::max<std::size_t>(line.size() + 2, 56), ' ');
    text += line + row.name + "\n";
  }
  return text;
}

std::string textOf(const std::vector<NearServer>& servers) {
  std::vector<ServerRow> rows;
  for (const NearServer& server : servers) rows.push_back({server.address.text(), describe(server), server.info.name});
  return textOf(rows);
}

}  // namespace platon
