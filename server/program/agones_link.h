#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "server/app/log.h"
#include "server/fleet/agones_reporter.h"
#include "server/match/match.h"

namespace platon {

/// The server's link to Agones, if it runs under it. docs/fleet.md describes it.
class AgonesLink {
 public:
  /// `port`: of the sidecar; nothing: all calls below do nothing.
  AgonesLink(std::optional<std::uint16_t> port, AgonesReporter::Clock clock) : port_(port), clock_(std::move(clock)) {}

  /// Call when players can reach the server.
  void start(Log& log);
  /// Call in every step of the tick loop. A match that drains is reported to be full.
  void report(const Match& match, Log& log);
  /// Call when the server has stopped. Waits for at most 2 s.
  void finish(Log& log);

 private:
  void logEvents(Log& log);

  std::optional<std::uint16_t> port_;
  AgonesReporter::Clock clock_;
  std::unique_ptr<AgonesReporter> reporter_;  // null before the start
};

}  // namespace platon
