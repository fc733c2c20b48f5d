#include "server/fleet/agones_reporter.h"

#include <algorithm>
#include <utility>

namespace platon {

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
