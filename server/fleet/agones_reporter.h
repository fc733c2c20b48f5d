#pragma once

#include <array>
#include <chrono>
#include <functional>
#include <string>
#include <vector>

#include "protocol/work/worker.h"
#include "server/fleet/agones_schedule.h"

namespace platon {

/// The beginning or the end of a failure of one kind of call.
struct AgonesEvent {
  AgonesCall call = AgonesCall::kReady;
  std::string fault;  ///< empty: it succeeds again

  friend bool operator==(const AgonesEvent&, const AgonesEvent&) = default;
};

/// Tells Agones about the server. A thread makes the calls: the server never waits for it, except at its end. A tick
/// loop that stalls reports nothing, so Agones hears nothing from it.
class AgonesReporter {
 public:
  /// Makes a call, which takes a second at most.
  using Send = std::function<AgonesAnswer(AgonesCall call, const PlayerCount& count)>;
  using Clock = std::function<TimePoint()>;

  /// `send` is called by the thread. The destructor waits for a call that is under way.
  AgonesReporter(Send send, Clock clock);

  /// Call in every step of the tick loop.
  void report(bool playing, const PlayerCount& count);
  /// Failures that have begun or ended since the last call, in order.
  std::vector<AgonesEvent> takeEvents();
  /// Tells that the server has stopped, and waits until Agones knows it, for at most `limit`. Returns whether it does.
  bool finish(std::chrono::milliseconds limit);

 private:
  // Time between two looks at what is due in `finish`.
  static constexpr std::chrono::milliseconds kInterval{100};

  struct Made {
    AgonesCall call = AgonesCall::kReady;
    FleetStatus status;
  };

  void step();
  void take(const JobResult<AgonesAnswer>& answered);

  Send send_;
  Clock clock_;
  FleetStatus status_;
  AgonesSchedule schedule_;
  Made made_;  // the last call
  std::array<bool, kAgonesCalls> fails_{};
  std::vector<AgonesEvent> events_;
  Worker<AgonesAnswer> calling_;
};

}  // namespace platon
