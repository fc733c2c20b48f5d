#include "server/fleet/agones_schedule.h"

#include <algorithm>

namespace platon {

std::optional<AgonesCall> AgonesSchedule::due(const FleetStatus& status, TimePoint now) {
  if (status.stopped) {
    const bool isDue = !shutDown() && mayRetry(AgonesCall::kShutdown, now);
    return isDue ? std::optional(AgonesCall::kShutdown) : std::nullopt;
  }
  if (!tried_) return AgonesCall::kReady;
  if (now >= healthAt_) return AgonesCall::kHealth;
  if (const auto call = change(status, now)) return call;
  const bool counts = count_ != status.count || now >= countAt_;
  return told_ && counts && mayRetry(AgonesCall::kPlayers, now) ? std::optional(AgonesCall::kPlayers) : std::nullopt;
}

// The call that leads to the state which the server should have: ready or allocated. An allocated server looks when it
// is empty, to know the last allocation, and again before it returns to ready: an allocation in between has sent
// somebody.
std::optional<AgonesCall> AgonesSchedule::change(const FleetStatus& status, TimePoint now) {
  if (status.playing) {
    emptySince_ = now;
    allocation_.reset();
    mayReturn_ = false;
  }
  AgonesCall call = status.playing && told_ ? AgonesCall::kAllocate : AgonesCall::kReady;
  if (told_ == call || !mayRetry(call, now)) return std::nullopt;
  if (told_ == AgonesCall::kAllocate && !mayReturn_) {
    if (allocation_ && now - emptySince_ < kEmptyTime) return std::nullopt;
    call = AgonesCall::kGameServer;
  }
  return mayRetry(call, now) ? std::optional(call) : std::nullopt;
}

void AgonesSchedule::made(AgonesCall call, const FleetStatus& status, const AgonesAnswer& answer, TimePoint now) {
  tried_ = true;
  if (call == AgonesCall::kReady) mayReturn_ = false;
  if (call == AgonesCall::kHealth) {
    healthAt_ = now + kHealthInterval;
    return;
  }
  setRetry(call, !answer.fault, now);
  if (!answer.fault) take(call, status, answer.allocation, now);
}

void AgonesSchedule::setRetry(AgonesCall call, bool succeeded, TimePoint now) {
  Retry& retry = retries_[index(call)];
  retry.pause = succeeded ? std::chrono::milliseconds(0)
                          : std::clamp<std::chrono::milliseconds>(2 * retry.pause, kFirstPause, kMaxPause);
  retry.at = now + retry.pause;
}

// Takes the answer to a call that has succeeded.
void AgonesSchedule::take(AgonesCall call, const FleetStatus& status, const std::string& allocation, TimePoint now) {
  if (call == AgonesCall::kPlayers) {
    count_ = status.count;
    countAt_ = now + kCountInterval;
  } else if (call == AgonesCall::kGameServer) {
    mayReturn_ = allocation_ == allocation && now - emptySince_ >= kEmptyTime;
    if (allocation_ != allocation) emptySince_ = now;
    allocation_ = allocation;
  } else {
    told_ = call;
  }
}

}  // namespace platon
