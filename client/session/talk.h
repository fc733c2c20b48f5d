#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "protocol/time.h"
#include "protocol/to_client.h"
#include "protocol/token_bucket.h"

namespace platon {

/// What a session is told beside the game: the names of the players and their round trips, what they say, and what the
/// server's operator says. Of the server's texts it keeps what can be seen.
class Talk {
 public:
  /// Texts and emotes that wait to be taken; the oldest ones are dropped.
  static constexpr std::size_t kMaxChats = 64;
  /// A round trip that is older is not known any more: the server tells them every two seconds, but messages may be
  /// lost, and a player who is alone is told none.
  static constexpr Time kRoundTripTimeout = std::chrono::seconds(7);

  explicit Talk(Time now);

  /// The number of slots of the match. Before, nobody has a name.
  void setSlots(std::uint32_t slots) { names_.resize(slots); }

  void receive(const Roster& message, Time now);
  void receive(const RoundTrips& message, Time now);
  void receive(const Notice& message, Time now);
  void receive(const PlayerChat& message, Time now);

  /// Takes one text or emote from the budget of a local player. False when the server would drop it.
  bool maySay(std::uint32_t local, Time now) { return budgets_[local].take(1, now); }

  /// By slot; an empty name means a free slot.
  std::span<const std::string> names() const { return names_; }
  /// Milliseconds, at most kMaxRoundTripMs; nothing for a free slot, a disconnected player, and when the server has not
  /// told it lately. `now` never decreases.
  std::optional<std::uint32_t> roundTripMs(std::uint32_t slot, Time now) const;
  /// The newest text of the operator; each is returned once.
  std::optional<std::string> takeNotice() { return std::exchange(notice_, std::nullopt); }
  /// What players have said, oldest first; each is returned once.
  std::vector<PlayerChat> takeChats() { return std::exchange(chats_, {}); }

 private:
  std::vector<std::string> names_;
  std::vector<std::uint8_t> roundTrips_;  // codes by slot
  Time roundTripsAt_{};
  std::optional<std::string> notice_;
  std::vector<PlayerChat> chats_;
  std::vector<TokenBucket> budgets_;  // by local number
};

}  // namespace platon
