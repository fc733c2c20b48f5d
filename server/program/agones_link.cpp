#include "server/program/agones_link.h"

#include <string>

#include "server/fleet/agones_call.h"

namespace platon {
namespace {

constexpr std::chrono::milliseconds kCallLimit{1000};
constexpr std::chrono::milliseconds kFinishLimit{2000};

AgonesAnswer makeCall(AgonesCall call, std::uint16_t port, const PlayerCount& count,
                      const AgonesReporter::Clock& clock) {
  const bool asks = call == AgonesCall::kGameServer;
  const LoopbackAnswer answer = sendOverLoopback(agonesRequest(call, port, count), port,
                                                 asks ? LoopbackPart::kBody : LoopbackPart::kStatus, kCallLimit, clock);
  if (answer.fault || !asks) return {answer.fault};
  const std::optional<std::string> allocation = lastAllocation(answer.body);
  return allocation ? AgonesAnswer{{}, *allocation} : AgonesAnswer{"its answer describes no game server"};
}

}  // namespace

void AgonesLink::start(Log& log) {
  if (!port_) return;
  const auto send = [port = *port_, clock = clock_](AgonesCall call, const PlayerCount& count) {
    return makeCall(call, port, count, clock);
  };
  reporter_ = std::make_unique<AgonesReporter>(send, clock_);
  log.info("agones at port " + std::to_string(*port_));
}

void AgonesLink::report(const Match& match, Log& log) {
  if (!reporter_) return;
  const std::uint32_t limit = match.settings().maxPlayers;
  const auto players = static_cast<std::uint32_t>(match.allPlayers());
  reporter_->report(!match.idle(), {match.draining() ? limit : players, limit});
  logEvents(log);
}

void AgonesLink::finish(Log& log) {
  if (!reporter_) return;
  const bool knows = reporter_->finish(kFinishLimit);
  logEvents(log);
  if (!knows) log.warning("agones was not told that the server stops");
  reporter_.reset();
}

void AgonesLink::logEvents(Log& log) {
  for (const AgonesEvent& event : reporter_->takeEvents()) {
    const LogField call{"call", std::string(nameOf(event.call))};
    if (event.fault.empty())
      log.info("agones call succeeds again", {call});
    else
      log.warning("agones call fails", {call, {"reason", event.fault}});
  }
}

}  // namespace platon
