#include "client/lobby/near_servers.h"

#include <sodium.h>

#include <algorithm>
#include <chrono>
#include <utility>

#include "client/lobby/own_addresses.h"
#include "protocol/label.h"
#include "protocol/limits.h"
#include "protocol/transport/udp_socket.h"

namespace platon {

NearServers::NearServers(std::unique_ptr<DatagramSocket> socket, std::vector<SocketAddress> targets,
                         std::uint64_t nonce)
    : socket_(std::move(socket)), targets_(std::move(targets)), nonce_(nonce) {}

void NearServers::update(Moment now) {
  takeDatagrams(*socket_, now, [&](const Datagram& datagram) { take(datagram, now); });
  if (!searchedAt_ || now - *searchedAt_ >= kInterval) search(now);
}

void NearServers::search(Moment now) {
  for (NearServer& server : found_) ++server.missed;
  ++nonce_;
  searchedAt_ = now;
  const Bytes query = encode(Query{nonce_});
  for (const SocketAddress& target : targets_) socket_->send(target, query, now);
  socket_->flush(now);
}

void NearServers::take(const Datagram& datagram, Moment now) {
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
