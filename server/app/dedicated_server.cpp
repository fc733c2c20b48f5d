#include "server/app/dedicated_server.h"

#include <thread>

#include "protocol/to_client.h"
#include "protocol/to_server.h"

namespace platon {
namespace {

// Connections beyond the number of players, so that a client can be told that the server is full.
constexpr std::uint32_t kSpareConnections = 8;
constexpr std::chrono::milliseconds kIdleWait{250};
// Shortest sleep without players, so that a flood of datagrams does not keep the server busy.
constexpr std::chrono::milliseconds kMinIdleWait{2};
constexpr std::chrono::milliseconds kFarewellTime{500};
constexpr std::chrono::seconds kRejectedLogInterval{10};

TimePoint steadyNow() { return std::chrono::steady_clock::now(); }

HostSettings hostSettings(const ServerSettings& settings) {
  HostSettings host = settings.host;
  host.connections = settings.match.maxPlayers + kSpareConnections;
  return host;
}

MatchSettings matchSettings(const ServerSettings& settings) {
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
    case Kind::kConnectionLost:
      return log.info("connection lost", {client, slot, {"name", event.text}});
    case Kind::kResumed:
      return log.info("resumed", {client, slot, {"name", event.text}});
    case Kind::kLeft:
      return log.info("left", {client, slot, {"name", event.text}});
    case Kind::kDesync:
      return log.warning("desync", {client, slot, {"at", event.text}});
    case Kind::kResync:
      return log.info("resync", {client, slot, {"at", event.text}});
    case Kind::kRoundStart:
      return log.info("round started", {{"level", event.text}});
    case Kind::kRoundEnd:
      return log.info("round over", {{"ticks", std::uint64_t{event.ticks}}});
  }
}

}  // namespace

DedicatedServer::DedicatedServer(const ServerSettings& settings, std::vector<LevelPointer> levels, Log log)
    : log_(std::move(log)),
      host_(hostSettings(settings), steadyNow()),
      recordings_(folderOf(settings)),
      match_(LevelRotation(std::move(levels)), matchSettings(settings)),
      clock_(steadyNow()),
      nextLogAt_(steadyNow() + kRejectedLogInterval) {}

void DedicatedServer::step(TimePoint now) {
  const TimePoint begun = steadyNow();
  const bool wasIdle = match_.idle();
  receive(now);
  if (wasIdle) clock_ = TickClock(now);
  const bool ticks = !wasIdle && clock_.take(now);
  if (ticks) match_.tick();
  send(now);
  logRejected(now);
  if (ticks) tickTimes_.add(steadyNow() - begun);
}

void DedicatedServer::receive(TimePoint now) {
  for (const HostEvent& event : host_.service(now)) handle(event, now);
}

void DedicatedServer::handle(const HostEvent& event, TimePoint now) {
  if (event.disconnected) return match_.disconnect(event.client);
  if (!host_.isOpen(event.client)) return;
  const auto message = decodeToServer(event.bytes);
  if (message) {
    const bool wasPlaying = match_.isPlaying(event.client);
    match_.receive(event.client, *message, event.origin);
    const bool isPlaying = match_.isPlaying(event.client);
    if (isPlaying) host_.admit(event.client);
    if (wasPlaying && !isPlaying) host_.close(event.client, now);  // a connection serves one player only
    return;
  }
  ++malformedMessages_;
  match_.remove(event.client);
  host_.send(event.client, true, encode(Bye{ByeCode::kRemoved, "your client sent a malformed message"}));
  host_.close(event.client, now);
}

void DedicatedServer::send(TimePoint now) {
  for (const Outgoing& message : match_.takeOutgoing()) {
    host_.send(message.client, message.reliable, message.bytes);
    if (message.last) host_.close(message.client, now);
  }
  host_.flush(now);
  for (const MatchEvent& event : match_.takeEvents()) write(log_, event);
  writeRecordings();
}

void DedicatedServer::writeRecordings() {
  for (const RecordingPiece& piece : match_.takeRecording()) {
    recordings_->write(piece, std::chrono::system_clock::now(), log_);
  }
}

void DedicatedServer::logRejected(TimePoint now) {
  if (now < nextLogAt_) return;
  nextLogAt_ = now + kRejectedLogInterval;
  const HostCounters& counters = host_.counters();
  if (counters == logged_ && malformedMessages_ == loggedMalformed_) return;
  log_.warning("traffic rejected", {{"invalidDatagrams", counters.invalidDatagrams - logged_.invalidDatagrams},
                                    {"excessDatagrams", counters.excessDatagrams - logged_.excessDatagrams},
                                    {"excessConnects", counters.excessConnects - logged_.excessConnects},
                                    {"expired", counters.expired - logged_.expired},
                                    {"malformedMessages", malformedMessages_ - loggedMalformed_}});
  logged_ = counters;
  loggedMalformed_ = malformedMessages_;
}

void DedicatedServer::wait() const {
  if (!match_.idle()) return std::this_thread::sleep_until(clock_.next());
  host_.wait(kIdleWait);
  std::this_thread::sleep_for(kMinIdleWait);
}

void DedicatedServer::run(const std::function<bool()>& stopRequested) {
  while (!stopRequested()) {
    step(steadyNow());
    wait();
  }
  stop("the server stops");
}

void DedicatedServer::stop(const std::string& reason) {
  match_.stop(reason);
  writeRecordings();
  const TimePoint end = steadyNow() + kFarewellTime;
  for (TimePoint now = steadyNow(); now < end && !host_.empty(); now = steadyNow()) {
    send(now);
    host_.wait(std::chrono::milliseconds(10));
    host_.service(now);
  }
  log_.info("tick times", {{"ticks", tickTimes_.count()},
                           {"p50Us", tickTimes_.quantile(0.5)},
                           {"p99Us", tickTimes_.quantile(0.99)},
                           {"longestUs", tickTimes_.longest()}});
}

}  // namespace platon
