#include "server/match/updates.h"

#include <algorithm>
#include <cassert>

#include "server/match/roster.h"

namespace platon {
namespace {

// Ticks between two messages of ticks to a client. With more players, each message costs more, and there are more
// messages.
std::uint32_t intervalFor(std::size_t players) {
  if (players <= MatchUpdates::kFewPlayers) return 1;
  return players <= MatchUpdates::kManyPlayers ? 2 : 3;
}

}  // namespace

void TickHistory::append(std::span<const Input> inputs, std::uint32_t hash) {
  if (held_.size() < inputs.size()) held_.resize(inputs.size());
  Entry entry;
  entry.hash = hash;
  for (std::uint32_t slot = 0; slot < held_.size(); ++slot) {
    const Input input = slot < inputs.size() ? inputs[slot] : Input{};
    if (input == held_[slot]) continue;
    entry.changes.push_back({end_, slot, input});
    held_[slot] = input;
  }
  if (entries_.size() == kTicks) {
    baseHash_ = entries_.front().hash;
    entries_.pop_front();
  }
  entries_.push_back(std::move(entry));
  ++end_;
}

std::uint32_t TickHistory::hashAfter(std::uint32_t confirmed) const {
  assert(covers(confirmed));
  return confirmed == end_ - entries_.size() ? baseHash_ : entry(confirmed - 1).hash;
}

void TickHistory::collect(std::uint32_t confirmed, ConfirmedTicks& message) const {
  assert(covers(confirmed) && confirmed < end_);
  message.round = round_;
  message.from = confirmed;
  message.count = 0;
  message.link.reset();
  message.changes.clear();
  for (std::uint32_t tick = confirmed; tick < end_ && message.count < kMaxTicksPerMessage; ++tick) {
    const Entry& next = entry(tick);
    if (message.changes.size() + next.changes.size() > kMaxChangesPerMessage) break;
    message.changes.insert(message.changes.end(), next.changes.begin(), next.changes.end());
    message.hash = next.hash;
    ++message.count;
  }
}

void TickDelivery::startRound(bool started) {
  acknowledged_ = continueAt_ = 0;
  messagesSinceFull_ = kFullRepeatInterval;
  started_ = started;
}

std::uint32_t TickDelivery::nextToSend(std::uint32_t end, std::uint32_t interval) const {
  const std::uint32_t from = std::max(continueAt_, acknowledged_);
  const bool all = continueAt_ != 0 || messagesSinceFull_ + 1 >= kFullRepeatInterval;
  const std::uint32_t recent = std::max(kRecentTicks, kRecentMessages * interval);
  return all || end < recent ? from : std::max(from, end - recent);
}

void TickDelivery::sent(std::uint32_t from, std::uint32_t tick, std::uint32_t end) {
  continueAt_ = tick < end ? tick : 0;
  lastTicks_ = tick - from;
  messagesSinceFull_ = from == acknowledged_ ? 0 : messagesSinceFull_ + 1;
}

// Several changes at a time when many clients join.
void MatchUpdates::sendNames(MatchRoster& roster, std::uint64_t now, MatchOutput& output) {
  if (now < nextNamesAt_) return;
  const std::vector<SharedBytes> changes = roster.names().takeChanges();
  for (const SharedBytes& message : changes) roster.sendAll(message, output);
  if (!changes.empty()) nextNamesAt_ = now + kNamesTicks;
}

// When many players change buttons, a message may hold fewer ticks than are decided before the next one. The rest
// follows in the next ticks.
void MatchUpdates::sendTicks(MatchRoster& roster, const TickHistory& history, std::uint64_t now, MatchOutput& output) {
  const std::uint32_t interval = intervalFor(roster.players());
  for (auto& [id, client] : roster.connected()) {
    TickDelivery& delivery = client.ticks();
    const bool due = (now + client.first().slot()) % interval == 0 || delivery.fallsBehind(interval);
    const bool follows = delivery.started() && history.covers(delivery.acknowledged());
    if (!due || !follows || delivery.acknowledged() == history.end()) continue;
    history.collect(delivery.nextToSend(history.end(), interval), ticks_);
    delivery.sent(ticks_.from, ticks_.from + ticks_.count, history.end());
    ticks_.link = client.arrival().take();
    ticks_.sequence = delivery.nextSequence();
    output.sendUnsequenced(id, encode(ticks_));
  }
}

// The newest message makes up for a lost one.
void MatchUpdates::sendRoundTrips(const MatchRoster& roster, const std::function<std::uint32_t(ClientId)>& roundTrip,
                                  std::uint64_t now, MatchOutput& output) {
  if (!roundTrip || roster.connected().size() < 2 || now % kRoundTripsTicks != 0) return;
  RoundTrips message;
  for (const auto& [id, client] : roster.connected()) {
    const std::uint8_t code = codeOfRoundTrip(roundTrip(id));
    for (const auto& [local, player] : client.players()) {
      message.codes.resize(std::max<std::size_t>(message.codes.size(), player.slot() + 1), kNoRoundTrip);
      message.codes[player.slot()] = code;
    }
  }
  const SharedBytes bytes = encode(message);
  for (const auto& [id, client] : roster.connected()) output.sendUnsequenced(id, bytes);
}

}  // namespace platon
