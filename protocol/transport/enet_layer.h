#pragma once

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdint>
#include <optional>
#include <span>

#include <enet/enet.h>
#include <enet/time.h>

#include "protocol/limits.h"
#include "protocol/time.h"
#include "protocol/transport/datagram_socket.h"
#include "protocol/transport/noise.h"
#include "protocol/transport/sealed_channel.h"

namespace platon {

/// What ENet sends to and receives from instead of a socket: the contents of sealed datagrams. ENet's address of a
/// session has the session's number as host and its slot as port.
class EnetPort {
 public:
  EnetPort() = default;
  virtual ~EnetPort() = default;
  EnetPort(const EnetPort&) = delete;
  EnetPort& operator=(const EnetPort&) = delete;

  virtual void sendFromEnet(const ENetAddress& session, ByteSpan bytes) = 0;

  struct Received {
    ENetAddress session;
    ByteSpan bytes;  ///< not empty, at most ENET_PROTOCOL_MAXIMUM_MTU; valid until the next call
  };
  virtual std::optional<Received> receiveForEnet() = 0;
};

/// While it exists, ENet uses this port and this time in this thread. Every call of ENet that sends, receives or reads
/// the time happens inside one. libenet calls enet_socket_send, enet_socket_receive and enet_time_get through the
/// dynamic linker, which takes the definitions beside this class instead of those of the library.
class EnetScope {
 public:
  EnetScope(EnetPort& port, Time now);
  ~EnetScope();
  EnetScope(const EnetScope&) = delete;
  EnetScope& operator=(const EnetScope&) = delete;

 private:
  EnetPort* outer_;
  enet_uint32 outerTime_;
};

/// Whether libenet really calls the functions of this program. False if it was linked in a way that hides them; nothing
/// would then be sealed, so the programs must not start.
bool enetUsesOurCalls();

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

/// Who sent a datagram.
enum class EnetSender { kClient, kServer };

/// A command of ENet, as far as it is checked.
struct EnetCommand {
  std::uint8_t command = 0;  ///< ENET_PROTOCOL_COMMAND_…
  std::uint8_t channel = 0;
  std::uint16_t sequence = 0;  ///< of an acknowledgement, that of the command which it acknowledges
  std::uint16_t offset = 0;    ///< in the content
  std::uint16_t bytes = 0;     ///< with its data
};

/// The commands of one datagram.
struct EnetCommands {
  static constexpr std::size_t kMaxCommands = ENET_PROTOCOL_MAXIMUM_PACKET_COMMANDS;
  /// Most commands of a client, acknowledgements aside: it acknowledges all that the server sends, but says little.
  static constexpr std::size_t kMaxOfClient = 16;

  std::uint16_t peer = 0;  ///< number of the connection at the receiver; ENET_PROTOCOL_MAXIMUM_PEER_ID: none yet
  std::size_t count = 0;
  std::array<EnetCommand, kMaxCommands> commands{};
  enet_uint32 connectId = 0;  ///< of CONNECT, in network byte order; a repeated one has the same

  bool isConnect() const { return commands[0].command == ENET_PROTOCOL_COMMAND_CONNECT; }
};

/// Reads the content of a datagram in the layout of ENet 1.3 without checksum. Nothing if it holds anything that our
/// programs do not send: commands of the other side, unreliable sequenced packets, fragments, compression, empty
/// packets, a packet on the wrong channel, too many commands, or lengths that do not match. Several of
/// these cost ENet memory or time without bound.
std::optional<EnetCommands> readEnetCommands(ByteSpan content, EnetSender sender);

/// Whether the reliable commands are at most a few ahead of those that have arrived. ENet would keep all others until
/// the gap is filled. True for a receiver that is closing and has no channels: ENet drops what a sender repeats that
/// does not know yet.
bool areSequencesNear(const EnetCommands& commands, const ENetPeer& receiver);

/// Calls `visit` with each reliable command that `sender` has sent and that is outstanding: not acknowledged so far.
/// ENet waits for the acknowledgement, or has given the command up for lost and is about to send it again.
template <class Visit>
void forEachOutstanding(const ENetPeer& sender, Visit visit) {
  for (const ENetList* list : {&sender.sentReliableCommands, &sender.outgoingCommands}) {
    for (ENetListIterator each = enet_list_begin(list); each != enet_list_end(list); each = enet_list_next(each)) {
      const auto& command = *reinterpret_cast<const ENetOutgoingCommand*>(each);
      const bool isReliable = (command.command.header.command & ENET_PROTOCOL_COMMAND_FLAG_ACKNOWLEDGE) != 0;
      if (isReliable && command.sendAttempts > 0) visit(command);
    }
  }
}

/// Bytes that a command adds to a datagram, with its data.
std::size_t bytesOf(const ENetOutgoingCommand& command);

/// Removes from a content all acknowledgements of commands that are not outstanding at their sender, `receiver`, and
/// repeated ones. ENet would take them for a sign of life and believe the time in them. `commands` are those of the
/// content, before and after.
void removeFalseAcknowledgements(Bytes& content, EnetCommands& commands, const ENetPeer& receiver);

}  // namespace platon
