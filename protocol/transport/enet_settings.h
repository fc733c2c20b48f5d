#pragma once

#include <enet/enet.h>
#include <enet/time.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <span>

#include "protocol/limits.h"
#include "protocol/transport/datagram_socket.h"
#include "protocol/transport/sealed_channel.h"

namespace platon {

/// How server and client both use ENet. The constants apply to every connection, on both sides.

/// ENet ends a connection after this many unacknowledged retransmissions, or when nothing was acknowledged for
/// kEnetTimeoutMs. Both limits are generous: server and client end a silent connection earlier by themselves.
inline constexpr enet_uint32 kEnetTimeoutAttempts = 32;
inline constexpr enet_uint32 kEnetTimeoutMs = 10000;
/// Time between ENet's pings. It may be long: the absence of per-tick messages shows a lost connection earlier.
inline constexpr enet_uint32 kEnetPingIntervalMs = 2000;

/// Longest content of a datagram: what is left after sealing. ENet splits a packet that does not fit with its commands,
/// so no message is longer than kMaxMessageBytes.
inline constexpr enet_uint32 kEnetMtu = kMaxDatagramBytes - SealedChannel::kOverhead;
static_assert(kMaxMessageBytes + sizeof(ENetProtocolHeader) + sizeof(ENetProtocolSendFragment) <= kEnetMtu);

/// Creates a host whose datagrams go through EnetScope. Nullptr if there is no memory or no socket; ENet opens one, but
/// nothing uses it. `seed`: random.
inline ENetHost* createEnetHost(std::size_t peers, std::uint32_t seed) {
  ENetHost* const host = enet_host_create(nullptr, peers, kChannels, 0, 0);
  if (host == nullptr) return nullptr;
  host->randomSeed = seed;
  host->mtu = kEnetMtu;
  host->maximumPacketSize = kMaxMessageBytes;
  host->duplicatePeers = 1;  // a session has one connection
  return host;
}

/// Services a host without waiting. ENet would tell every peer its share of the bandwidth whenever one joins: commands
/// that grow with the square of the peers and that nobody needs.
inline int serviceEnet(ENetHost& host, ENetEvent& event) {
  host.recalculateBandwidthLimits = 0;
  return enet_host_service(&host, &event, 0);
}

/// Applies the constants above to a connection that begins.
inline void configurePeer(ENetPeer& peer) {
  enet_peer_timeout(&peer, kEnetTimeoutAttempts, kEnetTimeoutMs, kEnetTimeoutMs);
  enet_peer_ping_interval(&peer, kEnetPingIntervalMs);
}

/// Stops ENet from dropping unreliable packets when the round trip grows, and fixes the size of datagrams. The other
/// side chooses both when it connects, so call it before every service of the host.
inline void fixSettings(ENetPeer& peer) {
  peer.packetThrottle = peer.packetThrottleLimit = ENET_PEER_PACKET_THROTTLE_SCALE;
  peer.packetThrottleAcceleration = ENET_PEER_PACKET_THROTTLE_SCALE;
  peer.packetThrottleDeceleration = 0;
  peer.mtu = kEnetMtu;
}

/// Limits the time until an unacknowledged reliable command is sent again; ENet would double it each time. Call it
/// before every service of the host.
inline void limitRetransmissionTimeout(ENetPeer& peer, enet_uint32 maxMs) {
  for (ENetListIterator each = enet_list_begin(&peer.sentReliableCommands);
       each != enet_list_end(&peer.sentReliableCommands); each = enet_list_next(each)) {
    auto* const command = reinterpret_cast<ENetOutgoingCommand*>(each);
    command->roundTripTimeout = std::min(command->roundTripTimeout, maxMs);
    const enet_uint32 due = command->sentTime + command->roundTripTimeout;
    if (ENET_TIME_LESS(due, peer.nextTimeout)) peer.nextTimeout = due;
  }
}

/// Lets ENet send only those of the reliable commands again that are due now and for which `may` is true. Call it
/// before every service of the host, after limitRetransmissionTimeout. `now`: time of this service.
template <class May>
void postponeRetransmissions(ENetPeer& peer, enet_uint32 now, May may) {
  for (ENetListIterator each = enet_list_begin(&peer.sentReliableCommands);
       each != enet_list_end(&peer.sentReliableCommands); each = enet_list_next(each)) {
    auto* const command = reinterpret_cast<ENetOutgoingCommand*>(each);
    const enet_uint32 waited = ENET_TIME_DIFFERENCE(now, command->sentTime);
    if (waited >= command->roundTripTimeout && !may(*command)) command->roundTripTimeout = waited + 1;
  }
}

/// Queues a message on the channel of its kind. No effect if ENet cannot take it.
inline void sendMessage(ENetPeer& peer, std::span<const std::uint8_t> message, bool reliable) {
  const enet_uint32 flags = reliable ? ENET_PACKET_FLAG_RELIABLE : ENET_PACKET_FLAG_UNSEQUENCED;
  ENetPacket* const packet = enet_packet_create(message.data(), message.size(), flags);
  const std::uint8_t channel = reliable ? kReliableChannel : kTickChannel;
  if (packet != nullptr && enet_peer_send(&peer, channel, packet) != 0) enet_packet_destroy(packet);
}

}  // namespace platon
