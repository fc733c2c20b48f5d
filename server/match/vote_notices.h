#pragma once

#include <cstdint>
#include <optional>

#include "platon/game/game.h"
#include "protocol/to_client.h"

namespace platon {

/// Whether the vote has passed: more than half of the voters wish the next level.
constexpr bool votePasses(const VoteCount& count) { return 2 * count.votes > count.voters; }

/// Which counts of the vote clients are told: each that differs from the last one, but at most one in kMinTicks, and
/// none while nobody votes.
class VoteNotices {
 public:
  static constexpr std::uint64_t kMinTicks = kTicksPerSecond / 4;

  /// Forgets what clients were told in the last round.
  void startRound() { told_ = VoteCount(); }
  /// The count to tell all clients of at tick `now` of the match, if there is one. `now` never decreases.
  std::optional<VoteCount> take(VoteCount count, std::uint64_t now) {
    if (count.votes == 0) count.voters = 0;
    const bool same = count.votes == told_.votes && count.voters == told_.voters;
    if (same || now < nextAt_) return std::nullopt;
    nextAt_ = now + kMinTicks;
    return told_ = count;
  }
  /// What a newcomer is told.
  std::optional<VoteCount> told() const { return told_.votes > 0 ? std::optional(told_) : std::nullopt; }

 private:
  VoteCount told_;
  std::uint64_t nextAt_ = 0;
};

}  // namespace platon
