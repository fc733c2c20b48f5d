#pragma once

#include <atomic>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "server/app/log.h"
#include "server/app/recording_folder.h"
#include "server/app/tick_clock.h"
#include "server/app/tick_times.h"
#include "server/match/match.h"
#include "server/net/host.h"
#include "server/net/time_point.h"

namespace platon {

struct ServerSettings {
  HostSettings host;       ///< `connections` is set by the server
  MatchSettings match;     ///< `record` and `playersPerOrigin` are set by the server
  std::string recordings;  ///< folder for a recording of each round; empty: none are made
};

/// A match on a socket: what `platon-server` runs, and a client that plays on its own.
class DedicatedServer {
 public:
  /// Opens the socket; `levels` has at least one. Throws HostError, and ProgramError when no recording can be
  /// written.
  DedicatedServer(const ServerSettings& settings, std::vector<LevelPointer> levels, Log log);

  /// Takes in what has arrived, runs at most one tick, if it is due, and sends.
  void step(TimePoint now);
  /// Sleeps until the next step has something to do, or a signal is caught.
  void wait() const;
  /// Steps and waits until `stopAsked` becomes true, then says good-bye.
  void run(const std::atomic<bool>& stopAsked);
  /// Says good-bye to all players and waits a moment for them to hear it. Logs how long ticks took.
  void stop(const std::string& reason);

  /// These levels follow on the one that is being played.
  void setLevels(std::vector<LevelPointer> levels) { match_.setLevels(std::move(levels)); }
  void setName(std::string name) { match_.setServerName(std::move(name)); }

  /// The port it listens on.
  std::uint16_t port() const { return host_.port(); }
  Log& log() { return log_; }
  const Match& match() const { return match_; }
  /// Messages that did not make sense.
  std::uint64_t brokenMessages() const { return brokenMessages_; }
  const HostCounters& hostCounters() const { return host_.counters(); }
  /// How long the steps with a tick took, all that is done in them: what has come is taken in, the game is moved, what
  /// is told is sent.
  const TickTimes& tickTimes() const { return tickTimes_; }

 private:
  void receive(TimePoint now);
  void take(const HostEvent& event, TimePoint now);
  void deliver(TimePoint now);
  void record();
  void report(TimePoint now);

  Log log_;
  Host host_;
  std::optional<RecordingFolder> recordings_;
  Match match_;
  TickClock clock_;
  std::uint64_t brokenMessages_ = 0;
  HostCounters reported_;
  std::uint64_t reportedBroken_ = 0;
  TimePoint reportAt_;
  TickTimes tickTimes_;
};

}  // namespace platon
