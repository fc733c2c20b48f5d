#include "server/app/dedicated_server.h"

#include <thread>

#include "protocol/to_client.h"
#include "protocol/to_server.h"

namespace platon {
namespace {

// Beyond the players, so that those who find no place can be told.
constexpr std::uint32_t kSpareConnections = 8;
constexpr std::chrono::milliseconds kIdleWait{250};
// A flood of datagrams shall not keep an empty server busy.
constexpr std::chrono::milliseconds kIdleStep{2};
constexpr std::chrono::milliseconds kByeWait{500};
constexpr std::chrono::seconds kReportInterval{10};

TimePoint steadyNow() { return std::chrono::steady_clock::now(); }

HostSettings withConnections(const ServerSettings& settings) {
  HostSettings host = settings.host;
  host.connections = settings.match.maxPlayers + kSpareConnections;
  return host;
}

MatchSettings withTheRest(const ServerSettings& settings) {
  MatchSettings match = settings.match;
  match.record = !settings.recordings.empty();
  match.playersPerOrigin = settings.host.connectionsPerAddress;
  return match;
}

std::optional<RecordingFolder> folderOf(const ServerSettings& settings) {
  if (settings.recordings.empty()) return std::nullopt;
  return RecordingFolder(settings.recordings);
}

void write(Log& log, const MatchEvent& event) {
  using Kind = MatchEvent::Kind;
  const LogField client{"client", std::uint64_t{event.client}};
  const LogField slot{"slot", std::uint64_t{event.slot}};
  switch (event.kind) {
    case Kind::kJoined:
      return log.info("joined", {client, slot, {"name", event.text}});
    case Kind::kRefused:
      return log.info("refused", {client, {"reason", event.text}});
    case Kind::kLost:
      return log.info("connection lost", {client, slot, {"name", event.text}});
    case Kind::kReturned:
      return log.info("returned", {client, slot, {"name", event.text}});
    case Kind::kLeft:
      return log.info("left", {client, slot, {"name", event.text}});
    case Kind::kDesync:
      return log.warning("state differs", {client, slot, {"at", event.text}});
    case Kind::kBehind:
      return log.info("state sent", {client, slot, {"at", event.text}});
    case Kind::kRoundStart:
      return log.info("round starts", {{"level", event.text}});
    case Kind::kRoundEnd:
      return log.info("round over", {{"ticks", event.text}});
  }
}

}  // namespace

DedicatedServer::DedicatedServer(const ServerSettings& settings, std::vector<LevelPointer> levels, Log log)
    : log_(std::move(log)),
      host_(withConnections(settings), steadyNow()),
      recordings_(folderOf(settings)),
      match_(LevelRotation(std::move(levels)), withTheRest(settings)),
      clock_(steadyNow()),
      reportAt_(steadyNow() + kReportInterval) {}

void DedicatedServer::step(TimePoint now) {
  const TimePoint begun = steadyNow();
  const bool wasIdle = match_.idle();
  receive(now);
  if (wasIdle) clock_ = TickClock(now);
  const bool ticks = !wasIdle && clock_.take(now);
  if (ticks) match_.tick();
  deliver(now);
  report(now);
  if (ticks) tickTimes_.add(steadyNow() - begun);
}

void DedicatedServer::receive(TimePoint now) {
  for (const HostEvent& event : host_.service(now)) take(event, now);
}

void DedicatedServer::take(const HostEvent& event, TimePoint now) {
  if (event.gone) return match_.disconnect(event.client);
  if (!host_.listensTo(event.client)) return;
  const auto message = decodeToServer(event.bytes);
  if (message) {
    const bool wasMember = match_.isMember(event.client);
    match_.receive(event.client, *message, event.origin);
    const bool isMember = match_.isMember(event.client);
    if (isMember) host_.admit(event.client);
    if (wasMember && !isMember) host_.close(event.client, now);  // who has left does not greet again
    return;
  }
  ++brokenMessages_;
  match_.remove(event.client);
  host_.send(event.client, true, encode(Bye{ByeCode::kRemoved, "your client sent a message that makes no sense"}));
  host_.close(event.client, now);
}

void DedicatedServer::deliver(TimePoint now) {
  for (const Outgoing& message : match_.takeOutgoing()) {
    host_.send(message.client, message.reliable, message.bytes);
    if (message.last) host_.close(message.client, now);
  }
  host_.flush(now);
  for (const MatchEvent& event : match_.takeEvents()) write(log_, event);
  record();
}

void DedicatedServer::record() {
  for (const RecordingPiece& piece : match_.takeRecording()) {
    recordings_->write(piece, std::chrono::system_clock::now(), log_);
  }
}

void DedicatedServer::report(TimePoint now) {
  if (now < reportAt_) return;
  reportAt_ = now + kReportInterval;
  const HostCounters& counters = host_.counters();
  if (counters == reported_ && brokenMessages_ == reportedBroken_) return;
  log_.warning("kept out", {{"brokenDatagrams", counters.brokenDatagrams - reported_.brokenDatagrams},
                            {"excessDatagrams", counters.excessDatagrams - reported_.excessDatagrams},
                            {"excessConnects", counters.excessConnects - reported_.excessConnects},
                            {"expired", counters.expired - reported_.expired},
                            {"brokenMessages", brokenMessages_ - reportedBroken_}});
  reported_ = counters;
  reportedBroken_ = brokenMessages_;
}

void DedicatedServer::wait() const {
  if (!match_.idle()) return std::this_thread::sleep_until(clock_.next());
  host_.wait(kIdleWait);
  std::this_thread::sleep_for(kIdleStep);
}

void DedicatedServer::run(const std::atomic<bool>& stopAsked) {
  while (!stopAsked) {
    step(steadyNow());
    wait();
  }
  stop("the server stops");
}

void DedicatedServer::stop(const std::string& reason) {
  match_.stop(reason);
  record();
  const TimePoint end = steadyNow() + kByeWait;
  for (TimePoint now = steadyNow(); now < end && !host_.empty(); now = steadyNow()) {
    deliver(now);
    host_.wait(std::chrono::milliseconds(10));
    host_.service(now);
  }
  log_.info("ran", {{"ticks", tickTimes_.count()},
                    {"p50Us", tickTimes_.quantile(0.5)},
                    {"p99Us", tickTimes_.quantile(0.99)},
                    {"longestUs", tickTimes_.longest()}});
}

}  // namespace platon
