#pragma once

#include <enet/enet.h>
#include <enet/time.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <span>

#include "protocol/limits.h"

namespace platon {

/// How server and client both use ENet. The constants apply to every connection, on both sides.

/// ENet ends a connection after this many unacknowledged retransmissions, or when nothing was acknowledged for
/// kEnetTimeoutMs. Both limits are generous: server and client end a silent connection earlier by themselves.
inline constexpr enet_uint32 kEnetTimeoutAttempts = 32;
inline constexpr enet_uint32 kEnetTimeoutMs = 30000;
/// Time between ENet's pings. It may be long: the absence of per-tick messages shows a lost connection earlier.
inline constexpr enet_uint32 kEnetPingIntervalMs = 2000;

/// Sets ENet's clock, which otherwise is the wall clock, to a monotonic time. Call it before every other use of ENet.
inline void setEnetTime(std::chrono::nanoseconds monotonic) {
  enet_time_set(static_cast<enet_uint32>(std::chrono::duration_cast<std::chrono::milliseconds>(monotonic).count()));
}

/// Applies the constants above to a connection that begins.
inline void configurePeer(ENetPeer& peer) {
  enet_peer_timeout(&peer, kEnetTimeoutAttempts, kEnetTimeoutMs, kEnetTimeoutMs);
  enet_peer_ping_interval(&peer, kEnetPingIntervalMs);
}

/// Stops ENet from dropping unreliable packets when the round trip grows. The other side can turn this on again at any
/// time, so call it before every service of the host.
inline void unthrottle(ENetPeer& peer) {
  peer.packetThrottle = peer.packetThrottleLimit = ENET_PEER_PACKET_THROTTLE_SCALE;
  peer.packetThrottleAcceleration = ENET_PEER_PACKET_THROTTLE_SCALE;
  peer.packetThrottleDeceleration = 0;
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

/// Queues a message on the channel of its kind. No effect if ENet cannot take it.
inline void sendMessage(ENetPeer& peer, std::span<const std::uint8_t> message, bool reliable) {
  const enet_uint32 flags = reliable ? ENET_PACKET_FLAG_RELIABLE : ENET_PACKET_FLAG_UNSEQUENCED;
  ENetPacket* const packet = enet_packet_create(message.data(), message.size(), flags);
  const std::uint8_t channel = reliable ? kReliableChannel : kTickChannel;
  if (packet != nullptr && enet_peer_send(&peer, channel, packet) != 0) enet_packet_destroy(packet);
}

}  // namespace platon
