#include "server/fleet/agones_reporter.h"

#include <utility>

#include "protocol/files/blocked_signals.h"

namespace platon {

AgonesReporter::AgonesReporter(Send send, Clock clock)
    : send_(std::move(send)), clock_(std::move(clock)), schedule_(clock_()) {
  const BlockedSignals blocked;
  thread_ = std::thread([this] { run(); });
}

AgonesReporter::~AgonesReporter() {
  {
    const std::lock_guard lock(mutex_);
    ended_ = true;
  }
  changed_.notify_all();
  thread_.join();
}

void AgonesReporter::report(bool playing, const PlayerCount& count) {
  const std::lock_guard lock(mutex_);
  ++status_.steps;
  status_.playing = playing;
  status_.count = count;
}

std::vector<AgonesEvent> AgonesReporter::takeEvents() {
  const std::lock_guard lock(mutex_);
  return std::exchange(events_, {});
}

bool AgonesReporter::finish(std::chrono::milliseconds limit) {
  std::unique_lock lock(mutex_);
  status_.stopped = true;
  changed_.notify_all();
  return changed_.wait_for(lock, limit, [this] { return schedule_.shutDown(); });
}

void AgonesReporter::run() {
  std::unique_lock lock(mutex_);
  while (!ended_) {
    if (!step(lock)) changed_.wait_for(lock, kInterval);
  }
}

// Makes a call if one is due, without the mutex. Returns whether it has.
bool AgonesReporter::step(std::unique_lock<std::mutex>& lock) {
  const FleetStatus status = status_;
  const std::optional<AgonesCall> call = schedule_.due(status, clock_());
  if (!call) return false;
  lock.unlock();
  const AgonesAnswer answer = send_(*call, status.count);
  lock.lock();
  schedule_.made(*call, status, answer, clock_());
  note(*call, answer.fault);
  changed_.notify_all();
  return true;
}

void AgonesReporter::note(AgonesCall call, const std::optional<std::string>& fault) {
  bool& fails = fails_[static_cast<std::size_t>(call)];
  if (std::exchange(fails, fault.has_value()) != fault.has_value()) events_.push_back({call, fault.value_or("")});
}

}  // namespace platon
