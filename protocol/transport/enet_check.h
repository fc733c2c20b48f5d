#pragma once

#include <enet/enet.h>

#include <array>
#include <cstdint>
#include <optional>

#include "protocol/transport/noise.h"

namespace platon {

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
