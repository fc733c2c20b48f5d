#include "server/match/tick_history.h"

#include <cassert>

namespace platon {

TickHistory::TickHistory(std::uint32_t round, std::uint32_t hash) : round_(round), baseHash_(hash) {}

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

}  // namespace platon
