#include "server/fleet/agones_schedule.h"

#include <algorithm>

namespace platon {

std::optional<AgonesCall> AgonesSchedule::due(const FleetStatus& status, TimePoint now) {
  if (status.steps != steps_) {
    steps_ = status.steps;
    advancedAt_ = now;
  }
  if (status.stopped) {
    const bool isDue = !shutDown() && mayRetry(AgonesCall::kShutdown, now);
    return isDue ? std::optional(AgonesCall::kShutdown) : std::nullopt;
  }
  if (!tried_) return AgonesCall::kReady;
  if (now >= healthAt_ && now - advancedAt_ < kStallTime) return AgonesCall::kHealth;
  const AgonesCall state = stateOf(status, now);
  if (told_ != state && mayRetry(state, now)) return state;
  const bool counts = count_ != status.count || now >= countAt_;
  return told_ && counts && mayRetry(AgonesCall::kPlayers, now) ? std::optional(AgonesCall::kPlayers) : std::nullopt;
}

// The state that the server should have: kReady or kAllocate.
AgonesCall AgonesSchedule::stateOf(const FleetStatus& status, TimePoint now) {
  if (status.playing) playedAt_ = now;
  const bool waits = told_ == AgonesCall::kAllocate && now - playedAt_ < kEmptyTime;
  return (status.playing && told_) || waits ? AgonesCall::kAllocate : AgonesCall::kReady;
}

void AgonesSchedule::made(AgonesCall call, const FleetStatus& status, bool succeeded, TimePoint now) {
  tried_ = true;
  if (call == AgonesCall::kHealth) {
    healthAt_ = now + kHealthInterval;
    return;
  }
  Retry& retry = retries_[index(call)];
  retry.pause = succeeded ? std::chrono::milliseconds(0)
                          : std::clamp<std::chrono::milliseconds>(2 * retry.pause, kFirstPause, kMaxPause);
  retry.at = now + retry.pause;
  if (!succeeded) return;
  if (call == AgonesCall::kPlayers) {
    count_ = status.count;
    countAt_ = now + kCountInterval;
  } else {
    told_ = call;
  }
}

}  // namespace platon
