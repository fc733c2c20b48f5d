#pragma once

#include <condition_variable>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "server/fleet/agones_schedule.h"

namespace platon {

/// The beginning or the end of a failure of one kind of call.
struct AgonesEvent {
  AgonesCall call = AgonesCall::kReady;
  std::string fault;  ///< empty: it succeeds again

  friend bool operator==(const AgonesEvent&, const AgonesEvent&) = default;
};

/// Tells Agones about the server, from a thread of its own: the server never waits for it, except at its end.
class AgonesReporter {
 public:
  /// Makes a call, which takes a second at most.
  using Send = std::function<AgonesAnswer(AgonesCall call, const PlayerCount& count)>;
  using Clock = std::function<TimePoint()>;

  /// Time between two looks at what is due.
  static constexpr std::chrono::milliseconds kInterval{100};

  /// `send` and `clock` are called by the thread.
  AgonesReporter(Send send, Clock clock);
  /// Waits for a call that is under way.
  ~AgonesReporter();
  AgonesReporter(const AgonesReporter&) = delete;
  AgonesReporter& operator=(const AgonesReporter&) = delete;

  /// Call in every step of the tick loop.
  void report(bool playing, const PlayerCount& count);
  /// Failures that have begun or ended since the last call, in order.
  std::vector<AgonesEvent> takeEvents();
  /// Tells that the server has stopped, and waits until Agones knows it, for at most `limit`. Returns whether it does.
  bool finish(std::chrono::milliseconds limit);

 private:
  void run();
  bool step(std::unique_lock<std::mutex>& lock);
  void note(AgonesCall call, const std::optional<std::string>& fault);

  const Send send_;
  const Clock clock_;
  std::mutex mutex_;
  std::condition_variable changed_;
  FleetStatus status_;  // this and all below: under the mutex
  AgonesSchedule schedule_;
  std::array<bool, kAgonesCalls> fails_{};
  std::vector<AgonesEvent> events_;
  bool ended_ = false;  // this is being destroyed
  std::thread thread_;  // last: uses the members above from its start
};

}  // namespace platon
