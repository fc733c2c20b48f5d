#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "protocol/work/worker.h"
#include "server/base/time_point.h"
#include "server/fleet/agones_call.h"

namespace platon {

/// What the server tells about itself.
struct FleetStatus {
  bool playing = false;  ///< somebody plays, or may resume
  PlayerCount count;     ///< as the counter of Agones shows it
  bool stopped = false;  ///< the server has stopped
};

/// Decides which call is due; asked in each step of the tick loop. It has neither socket nor clock nor thread.
class AgonesSchedule {
 public:
  /// Between two pings, as the documentation of Agones shows it for `periodSeconds: 5`.
  static constexpr std::chrono::seconds kHealthInterval{2};
  /// Pause after a call that failed; doubled after each further failure of this call, up to kMaxPause.
  static constexpr std::chrono::milliseconds kFirstPause{500};
  static constexpr std::chrono::seconds kMaxPause{8};
  /// The number of players is told again after this time, so that places which an allocation has reserved and nobody
  /// has taken become free.
  static constexpr std::chrono::seconds kCountInterval{30};

  /// The server may be removed when nobody has played for this long, and this long after a look at the game server has
  /// shown an allocation: until then somebody may be on the way.
  static constexpr std::chrono::seconds kEmptyTime = kCountInterval;

  explicit AgonesSchedule(TimePoint now) : healthAt_(now) {}

  /// The call to make now; nothing if none is due. The first one is kReady.
  std::optional<AgonesCall> due(const FleetStatus& status, TimePoint now);
  /// Tells how a call that `due` has named ended, with the status it was made for.
  void made(AgonesCall call, const FleetStatus& status, const AgonesAnswer& answer, TimePoint now);
  /// Whether the sidecar knows that the server has stopped.
  bool shutDown() const { return told_ == AgonesCall::kShutdown; }

 private:
  struct Retry {
    TimePoint at{};  // not before
    std::chrono::milliseconds pause{};
  };

  std::optional<AgonesCall> change(const FleetStatus& status, TimePoint now);
  void setRetry(AgonesCall call, bool succeeded, TimePoint now);
  void take(AgonesCall call, const FleetStatus& status, const std::string& allocation, TimePoint now);
  bool mayRetry(AgonesCall call, TimePoint now) const { return now >= retries_[index(call)].at; }
  static std::size_t index(AgonesCall call) { return static_cast<std::size_t>(call); }

  TimePoint emptySince_{};                 // when somebody was last seen to play, or an allocation was seen
  std::optional<std::string> allocation_;  // the last one that was seen; nothing while somebody plays
  bool mayReturn_ = false;                 // the last look was late enough and showed nothing new
  TimePoint healthAt_;                     // next ping
  bool tried_ = false;                     // kReady was tried once
  std::optional<AgonesCall> told_;         // kReady, kAllocate or kShutdown: what the sidecar has taken last
  std::optional<PlayerCount> count_;       // the same for kPlayers
  TimePoint countAt_{};                    // when it is told again
  std::array<Retry, kAgonesCalls> retries_{};
};

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
