#include "server/fleet/agones_reporter.h"

#include <algorithm>
#include <utility>

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

AgonesReporter::AgonesReporter(Send send, Clock clock)
    : send_(std::move(send)), clock_(std::move(clock)), schedule_(clock_()) {}

void AgonesReporter::report(bool playing, const PlayerCount& count) {
  status_.playing = playing;
  status_.count = count;
  step();
}

std::vector<AgonesEvent> AgonesReporter::takeEvents() { return std::exchange(events_, {}); }

bool AgonesReporter::finish(std::chrono::milliseconds limit) {
  status_.stopped = true;
  for (step(); !schedule_.shutDown() && limit.count() > 0; limit -= kInterval) {
    if (auto answer = calling_.wait(std::min(limit, kInterval))) take(*answer);
    step();
  }
  return schedule_.shutDown();
}

// Takes an answer, and makes the call that is due then.
void AgonesReporter::step() {
  if (auto answer = calling_.poll()) take(*answer);
  if (calling_.isPending()) return;
  const std::optional<AgonesCall> call = schedule_.due(status_, clock_());
  if (!call) return;
  made_ = {*call, status_};
  calling_.add([send = send_, made = made_](const std::stop_token&) { return send(made.call, made.status.count); });
}

void AgonesReporter::take(const JobResult<AgonesAnswer>& answered) {
  const AgonesAnswer answer = answered.value ? *answered.value : AgonesAnswer{answered.fault};
  schedule_.made(made_.call, made_.status, answer, clock_());
  bool& fails = fails_[static_cast<std::size_t>(made_.call)];
  if (std::exchange(fails, answer.fault.has_value()) != answer.fault.has_value())
    events_.push_back({made_.call, answer.fault.value_or("")});
}

}  // namespace platon
