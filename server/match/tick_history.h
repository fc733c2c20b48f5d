#pragma once

#include <cstdint>
#include <deque>
#include <span>
#include <vector>

#include "platon/game/input.h"
#include "protocol/to_client.h"

namespace platon {

/// The last decided ticks of a round: their input changes, and the hash of the game after each. They are sent to every
/// client until it acknowledges them.
class TickHistory {
 public:
  /// Ticks kept: 10 s. A client that is further behind needs a full state.
  static constexpr std::size_t kTicks = 600;

  /// A round without decided ticks; `hash` is the short hash of its game.
  TickHistory(std::uint32_t round, std::uint32_t hash);

  /// Adds the next tick: its inputs by slot, and the short hash of the game after it.
  void append(std::span<const Input> inputs, std::uint32_t hash);

  /// Number of decided ticks.
  std::uint32_t end() const { return end_; }
  /// Whether all ticks from `confirmed` on are kept.
  bool covers(std::uint32_t confirmed) const { return confirmed <= end_ && confirmed >= end_ - entries_.size(); }
  /// Short hash of the game after `confirmed` ticks, which must be covered.
  std::uint32_t hashAfter(std::uint32_t confirmed) const;
  /// Sets `message` to the ticks from `confirmed` on, as many as fit, without link report. `confirmed` must be covered
  /// and before the end.
  void collect(std::uint32_t confirmed, ConfirmedTicks& message) const;
  /// Inputs of the last decided tick by slot; slots beyond its end are absent.
  const std::vector<Input>& held() const { return held_; }

 private:
  struct Entry {
    std::vector<InputChange> changes;
    std::uint32_t hash = 0;
  };

  const Entry& entry(std::uint32_t tick) const { return entries_[tick + entries_.size() - end_]; }

  std::uint32_t round_;
  std::uint32_t end_ = 0;
  std::uint32_t baseHash_;     // hash before the first entry
  std::deque<Entry> entries_;  // ticks end_ - size … end_ - 1
  std::vector<Input> held_;
};

}  // namespace platon
