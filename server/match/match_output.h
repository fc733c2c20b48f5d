#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "server/base/client_id.h"

namespace platon {

/// Immutable bytes with any number of owners, such as a message to many clients. A copy shares them. A range, from
/// which a std::span can be made.
class SharedBytes {
 public:
  /// No bytes.
  SharedBytes() : SharedBytes(std::vector<std::uint8_t>()) {}
  SharedBytes(std::vector<std::uint8_t> bytes)
      : bytes_(std::make_shared<const std::vector<std::uint8_t>>(std::move(bytes))) {}

  const std::uint8_t* data() const { return bytes_->data(); }
  std::size_t size() const { return bytes_->size(); }
  const std::uint8_t* begin() const { return data(); }
  const std::uint8_t* end() const { return data() + size(); }

 private:
  std::shared_ptr<const std::vector<std::uint8_t>> bytes_;
};

/// A message to one client.
struct Outgoing {
  ClientId client = 0;
  bool reliable = false;  ///< otherwise unsequenced
  bool last = false;      ///< close the connection once the message has arrived
  SharedBytes bytes;
};

/// Something that happened in a match, for the log of the server.
struct MatchEvent {
  enum class Kind {
    kJoined,          ///< text: the player's name
    kRefused,         ///< text: the reason
    kConnectionLost,  ///< the player can be resumed; text: its name
    kResumed,         ///< text: the player's name
    kRenamed,         ///< a companion; text: the player's new name
    kLeft,            ///< text: the player's name
    kDesync,          ///< the client's game differs; text: round, tick of the client's hash, tick of the state sent
    kResync,          ///< the client lacked ticks that can no longer be repeated; text: as for kDesync
    kChat,            ///< text: what the player says
    kRoundStart,      ///< text: the level's title
    kRoundEnd,        ///< ticks: length of the round; text: why it ended: finished, time, vote or operator
  };

  Kind kind = Kind::kJoined;
  ClientId client = 0;     ///< of the kinds before kRoundStart; 0 when the player has no client
  std::uint32_t slot = 0;  ///< of the kinds before kRoundStart except kRefused
  std::string text;
  std::uint32_t ticks = 0;  ///< of kRoundEnd
};

/// What comes out of a match, in order: messages to its clients, and events for the log of the server.
class MatchOutput {
 public:
  void send(ClientId client, SharedBytes bytes) { messages_.push_back({client, true, false, std::move(bytes)}); }
  void sendUnsequenced(ClientId client, SharedBytes bytes) {
    messages_.push_back({client, false, false, std::move(bytes)});
  }
  /// Its connection closes once the message has arrived.
  void sendLast(ClientId client, SharedBytes bytes) { messages_.push_back({client, true, true, std::move(bytes)}); }
  /// Whether a last message to the client waits.
  bool isClosing(ClientId client) const {
    return std::any_of(messages_.begin(), messages_.end(),
                       [client](const Outgoing& message) { return message.last && message.client == client; });
  }
  void add(MatchEvent::Kind kind, ClientId client, std::uint32_t slot, std::string text, std::uint32_t ticks = 0) {
    events_.push_back({kind, client, slot, std::move(text), ticks});
  }

  /// The messages since the last call. They are valid until the next one.
  std::span<const Outgoing> takeMessages() {
    taken_.clear();
    std::swap(taken_, messages_);
    return taken_;
  }
  /// The events since the last call.
  std::vector<MatchEvent> takeEvents() { return std::exchange(events_, {}); }

 private:
  std::vector<Outgoing> messages_;
  std::vector<Outgoing> taken_;
  std::vector<MatchEvent> events_;
};

}  // namespace platon
