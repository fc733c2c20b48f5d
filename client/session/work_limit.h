#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>

#include "client/netcode/prediction.h"
#include "client/session/dialogue.h"
#include "protocol/time.h"
#include "protocol/token_bucket.h"

namespace platon {

/// Bounds the work that a server may demand of a session, in the unit of Prediction::work: a budget for what it may
/// demand of any computer, and a time for which this one may be too slow for it.
class WorkLimit {
 public:
  /// Largest work per second: 30 replays of Prediction::kMaxWorkAhead, and 256 players for 120 ticks. A session that
  /// had to do more for kTime ends.
  static constexpr double kMaxPerSecond = 524'288;
  static constexpr Time kTime = std::chrono::seconds(5);
  /// A session also ends if for kTime every update has much work and comes late after the one before: this computer
  /// cannot keep up, for instance because the level makes every player slow.
  static constexpr Time kSlowUpdate = std::chrono::milliseconds(250);
  static constexpr std::uint64_t kSlowWork = 4096;

  // A server with more than a few players sends ticks 30 times a second.
  static_assert(kTicksPerSecond / 2 * Prediction::kMaxWorkAhead + 2 * kTicksPerSecond * kMaxPlayers <= kMaxPerSecond);

  explicit WorkLimit(Time now) : budget_(kMaxPerSecond, kMaxPerSecond * toSeconds(kTime), now), checkedAt_(now) {}

  void add(std::uint64_t work) { work_ += work; }
  /// Adds the work of starting a round, or of reading a level or a state, without that of their bytes.
  void addMessage() { work_ += 64; }
  void addBytes(std::size_t bytes) { work_ += bytes / 16; }
  /// Adds the work of reading or writing a level that is kept elsewhere, such as on a disk.
  void addStore() { work_ += 4096; }

  /// Why the session ends; nothing while the work is bearable. Call once an update. `predicted`: work of the present
  /// round's prediction, which has not been added.
  std::optional<SessionEnding> check(Time now, std::uint64_t predicted) {
    const std::uint64_t total = work_ + predicted;
    const std::uint64_t demanded = total - std::exchange(charged_, total);
    const Time passed = now - std::exchange(checkedAt_, now);
    const bool isSlow = passed > kSlowUpdate && demanded >= kSlowWork;
    slowTime_ = isSlow ? slowTime_ + std::min(passed, kMaxSlowUpdate) : Time{};
    if (!budget_.take(static_cast<double>(demanded), now))
      return SessionEnding{"protocol error: the server demands more computation than a game needs", true};
    if (slowTime_ > kTime) return SessionEnding{"this computer is too slow for the game of this server", true};
    return std::nullopt;
  }

 private:
  // One longer pause, such as that of a suspended computer, counts as this.
  static constexpr Time kMaxSlowUpdate = std::chrono::seconds(1);

  TokenBucket budget_;
  std::uint64_t work_ = 0;
  std::uint64_t charged_ = 0;  // at the last check
  Time checkedAt_;
  Time slowTime_{};  // of updates that came late one after the other
};

}  // namespace platon
