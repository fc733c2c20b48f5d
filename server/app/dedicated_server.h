#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "server/admin/bans.h"
#include "server/app/log.h"
#include "server/app/recording_writer.h"
#include "server/app/ticks.h"
#include "server/base/tick_clock.h"
#include "server/base/time_point.h"
#include "server/match/level_rotation.h"
#include "server/match/match.h"
#include "server/net/host.h"
#include "server/times/best_times.h"

namespace platon {

/// The time of the server, which passes evenly.
TimePoint steadyNow();

/// The time of day, in seconds.
UtcTime utcNow();

/// The best times that a server keeps in this file; without a file they end with it. Throws ProgramError if the file
/// cannot be read.
BestTimeStore bestTimesOf(const std::string& path);

struct ServerSettings {
  std::string bind = "::";                                     ///< address to listen on; "::": all
  std::uint16_t port = 0;                                      ///< 0: any that is free
  std::optional<ServerIdentity> identity;                      ///< nothing: a new one
  std::string password;                                        ///< empty: none
  std::uint32_t playersPerAddress = 4;                         ///< of one household; loopback has no limit
  LevelRotation::Start start = LevelRotation::Start::kForOne;  ///< which level is played first
  MatchSettings match;     ///< `record` and `playersPerOrigin` are ignored: the server derives them
  std::string recordings;  ///< folder for a recording of each round; empty: no recordings
  std::uint64_t recordLimit = std::uint64_t{10} << 30;  ///< bytes of all recordings in this folder
  std::string bestTimes;                                ///< file of the best times; empty: they end with the server
};

/// A match on a socket. `platon-server` runs one, and so does a client without a server address.
class DedicatedServer {
 public:
  /// Opens the socket; `levels` must not be empty. Throws SocketError if that fails, and ProgramError if no recording
  /// can be written or the best times cannot be read.
  /// `start`: the time by the clock of the server.
  DedicatedServer(const ServerSettings& settings, std::vector<LevelPointer> levels, Log log,
                  TimePoint start = steadyNow());
  /// The same on another socket.
  DedicatedServer(std::unique_ptr<DatagramSocket> socket, const ServerSettings& settings,
                  std::vector<LevelPointer> levels, Log log, TimePoint start = steadyNow());

  /// Receives messages, runs one tick if it is due, and sends messages.
  void step(TimePoint now);
  /// Sleeps until the next tick is due or, without players, until a datagram or a signal arrives or the idle wait has
  /// passed. In a flood it sleeps only shortly.
  void wait();
  /// Steps at the times that are due until `stopRequested`, which is called before each step, returns true; then stops.
  void run(const std::function<bool()>& stopRequested);
  /// Sets where `run` tells all clients at its end that they can go on (isNextServer); empty: nowhere.
  void setNextServer(std::string next) { next_ = std::move(next); }
  /// Tells all clients the reason, waits at most half a second for their acknowledgements, and logs the tick times.
  void stop(const std::string& reason);

  /// Plays these levels after the current one.
  void setLevels(std::vector<LevelPointer> levels) { match_.setLevels(std::move(levels)); }
  /// Plays new versions of the levels from the next round on: as many as there are, in the same order.
  void updateLevels(std::vector<LevelPointer> levels) { match_.updateLevels(std::move(levels)); }
  void setName(std::string_view name);
  /// From now on refuses clients whose address is banned, and tells the log of some (BanNotices). The list must outlive
  /// the server.
  void refuseBanned(const BanList& bans) { bans_ = &bans; }
  /// Sets the clock by which `run` and `stop` go; it never decreases, and while it stands still no tick passes. Without
  /// it, they go by the monotonic clock of the system.
  void setClock(std::function<TimePoint()> now) { now_ = std::move(now); }
  /// Longest sleep of `run` while the server has no players.
  void setIdleWait(std::chrono::milliseconds wait) { idleWait_ = wait; }

  /// The port that it listens on.
  SocketAddress address() const { return host_.address(); }
  std::uint16_t port() const { return address().port; }
  const ServerIdentity& identity() const { return identity_; }
  Log& log() { return log_; }
  const Match& match() const { return match_; }
  Match& match() { return match_; }
  const Host& host() const { return host_; }
  /// Durations of the steps that ran a tick: receiving, advancing the game, sending.
  const TickTimes& tickTimes() const { return tickTimes_; }
  /// The same of the last one to two minutes by the clock of `run`.
  TickTimes recentTickTimes() const { return recentTickTimes_.all(now_()); }
  /// Ticks that were dropped so far, because the server was paused or too slow.
  std::uint64_t droppedTicks() const { return droppedTicks_; }
  /// Recordings that could not be written to their end so far.
  std::uint64_t stoppedRecordings() const { return stoppedRecordings_; }
  /// How often the best times could not be written so far.
  std::uint64_t unwrittenBestTimes() const { return bestTimes_.failures(); }
  /// Games of clients that differed from the server's so far.
  std::uint64_t desyncs() const { return desyncs_; }

  static constexpr std::chrono::milliseconds kIdleWait{250};

 private:
  HostRules hostRules();
  MatchProgram matchProgram();
  void receive(TimePoint now);
  void handle(const HostEvent& event, TimePoint now);
  void sendLast(ClientId client, std::span<const std::uint8_t> message, TimePoint now);
  bool refusesBanned(ClientId client, const IpAddress& address, TimePoint now);
  const Ban* banOf(const IpAddress& address) const;
  void logBanned(const IpAddress& address, const Ban& ban);
  void send(TimePoint now);
  void writeRecordings();
  void finishRecordings();
  void logBestTimes(const std::optional<std::string>& fault);
  void logRejected(TimePoint now);
  void logDropped(TimePoint now);
  void updateInfo();

  Log log_;
  ServerIdentity identity_;
  Host host_;
  std::optional<RecordingWriter> recordings_;
  std::uint64_t stoppedRecordings_ = 0;
  std::string bestTimeFile_;
  BestTimeStore bestTimes_;
  bool bestTimesUnwritten_ = false;  // the log says so
  Match match_;
  TickClock clock_;
  const BanList* bans_ = nullptr;  // null: nobody is banned
  BanNotices banNotices_;
  TimePoint receivedAt_{};                // the last time of `receive`
  std::uint64_t receivedBeforeTick_ = 0;  // datagrams up to the last tick
  bool flooded_ = false;                  // many datagrams came between the last two ticks
  std::vector<Rejection> logged_;         // at the last logRejected
  TimePoint nextLogAt_;
  std::uint64_t droppedTicks_ = 0;
  std::uint64_t loggedDroppedTicks_ = 0;  // of these, those that the log tells
  TimePoint nextDroppedLogAt_{};
  TickTimes tickTimes_;
  RecentTickTimes recentTickTimes_;
  std::uint64_t desyncs_ = 0;
  std::string next_;  // where clients can go on after the end; empty: nowhere
  std::chrono::milliseconds idleWait_ = kIdleWait;
  std::function<TimePoint()> now_ = [] { return std::chrono::steady_clock::now(); };
};

}  // namespace platon
