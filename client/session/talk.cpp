#include "client/session/talk.h"

#include "protocol/chat.h"
#include "protocol/label.h"
#include "protocol/limits.h"

namespace platon {

Talk::Talk(Time now) : budgets_(kMaxLocalPlayers, TokenBucket(kChatsPerSecond, kChatBurst, now)) {}

void Talk::receive(const Roster& message, Time) {
  for (const RosterEntry& entry : message.entries) {
    if (entry.slot < names_.size()) names_[entry.slot] = visibleLabel(entry.name);
  }
}

void Talk::receive(const RoundTrips& message, Time now) {
  roundTrips_ = message.codes;
  roundTripsAt_ = now;
}

void Talk::receive(const Notice& message, Time) {
  std::string text = visibleLabel(message.text);
  if (!text.empty()) notice_ = std::move(text);
}

void Talk::receive(const PlayerChat& message, Time) {
  const PlayerChat said{message.slot, {visibleLabel(message.chat.text), message.chat.emote}};
  if (!isChat(said.chat)) return;
  if (chats_.size() == kMaxChats) chats_.erase(chats_.begin());
  chats_.push_back(said);
}

std::optional<std::uint32_t> Talk::roundTripMs(std::uint32_t slot, Time now) const {
  const bool isFree = slot >= names_.size() || names_[slot].empty();
  const bool isKnown = slot < roundTrips_.size() && now - roundTripsAt_ <= kRoundTripTimeout;
  return isFree || !isKnown ? std::nullopt : roundTripOf(roundTrips_[slot]);
}

}  // namespace platon
