#pragma once

#include <cstdint>
#include <deque>
#include <span>
#include <vector>

#include "platon/game/input.h"
#include "protocol/to_client.h"

namespace platon {

/// What has been decided in a round: the inputs of the last ticks, as changes, and the hash after each, to be sent to
/// every client until it has them.
class TickHistory {
 public:
  /// Ticks that can be repeated: 10 s. Whoever is further behind needs a full state.
  static constexpr std::size_t kTicks = 600;

  /// A round of which nothing is decided; `hash` is the short hash of its game.
  TickHistory(std::uint32_t round, std::uint32_t hash);

  /// The inputs by slot of the next tick, and the short hash of the game after it.
  void append(std::span<const Input> inputs, std::uint32_t hash);

  /// Ticks decided so far.
  std::uint32_t end() const { return end_; }
  /// Whether a client that has the first `confirmed` ticks can be sent the rest.
  bool covers(std::uint32_t confirmed) const { return confirmed <= end_ && confirmed >= end_ - entries_.size(); }
  /// Short hash of the game after `confirmed` ticks, which are covered.
  std::uint32_t hashAfter(std::uint32_t confirmed) const;
  /// The oldest of the ticks from `confirmed` on, covered and not the end, that fit one message; no slack.
  ConfirmedTicks collect(std::uint32_t confirmed) const;
  /// The inputs of the last tick decided, by slot; slots beyond its end are absent.
  const std::vector<Input>& held() const { return held_; }

 private:
  struct Entry {
    std::vector<InputChange> changes;
    std::uint32_t hash = 0;
  };

  const Entry& entry(std::uint32_t tick) const { return entries_[tick + entries_.size() - end_]; }

  std::uint32_t round_;
  std::uint32_t end_ = 0;
  std::uint32_t baseHash_;     // before the first entry
  std::deque<Entry> entries_;  // of ticks end_ - size … end_ - 1
  std::vector<Input> held_;
};

}  // namespace platon
