#include "server/app/dedicated_server.h"

#include <algorithm>
#include <thread>

#include "platon_version.h"
#include "protocol/to_client.h"
#include "protocol/to_server.h"
#include "protocol/transport/udp_socket.h"
#include "server/app/server_options.h"

namespace platon {
namespace {

// Connections beyond the number of players, so that a client can be told that the server is full.
// Clients that have not said who they are yet must not keep others out.
constexpr std::uint32_t kSpareConnections = 64;
// Reliable messages of a client that are not left to chunks. The others are enough for the chunks of each tick up to a
// round trip of 400 ms.
constexpr std::size_t kReservedRoom = Host::kMaxQueuedMessages * 5 / 8;
// Datagrams between two ticks beyond which the server reads more often.
constexpr std::uint64_t kFloodPackets = 128;
constexpr std::chrono::milliseconds kFloodInterval{2};
// Shortest sleep without players, so that a flood of datagrams does not keep the server busy.
constexpr std::chrono::milliseconds kMinIdleWait{2};
constexpr std::chrono::milliseconds kFarewellTime{500};
constexpr std::chrono::seconds kRejectedLogInterval{10};  // also of dropped ticks

// A household whose connections were all lost needs as many new ones before the old ones end.
HostSettings hostSettings(const ServerSettings& settings, const ServerIdentity& identity) {
  HostSettings host;
  host.connections = settings.match.maxPlayers + kSpareConnections;
  host.connectionsPerAddress = 2 * settings.playersPerAddress;
  host.needsPassword = !settings.password.empty();
  if (host.needsPassword) host.presharedKey = presharedKeyOf(settings.password, identity.publicKey());
  return host;
}

MatchSettings matchSettings(const ServerSettings& settings) {
  MatchSettings match = settings.match;
  match.record = !settings.recordings.empty();
  match.playersPerOrigin = settings.playersPerAddress;
  return match;
}

// The thread of the writer owns the folder: it may outlive the server when the disk does not answer.
RecordingWriter::Write writeTo(const ServerSettings& settings) {
  return [folder = std::make_shared<RecordingFolder>(settings.recordings, settings.recordLimit)](
             const RecordingPiece& piece, RecordingWriter::Time now, std::vector<RecordingEvent>& events) {
    folder->write(piece, now, events);
  };
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
    case Kind::kRenamed:
      return log.info("renamed", {client, slot, {"name", event.text}});
    case Kind::kLeft:
      return log.info("left", {client, slot, {"name", event.text}});
    case Kind::kDesync:
      return log.warning("desync", {client, slot, {"at", event.text}});
    case Kind::kResync:
      return log.info("resync", {client, slot, {"at", event.text}});
    case Kind::kChat:
      return log.info("chat", {client, slot, {"text", event.text}});
    case Kind::kRoundStart:
      return log.info("round started", {{"title", event.text}});
    case Kind::kRoundEnd:
      return log.info("round over", {{"ticks", std::uint64_t{event.ticks}}, {"cause", event.text}});
  }
}

void write(Log& log, const RecordingEvent& event) {
  using Kind = RecordingEvent::Kind;
  const LogField file{"file", event.file};
  switch (event.kind) {
    case Kind::kFinished:
      return log.info("recording finished", {file, {"ticks", event.ticks}, {"bytes", event.bytes}});
    case Kind::kStopped:
      return log.warning("recording stopped", {file, {"reason", event.reason}});
    case Kind::kRemoved:
      return log.info("recording removed", {file, {"bytes", event.bytes}});
  }
}

}  // namespace

BestTimeStore bestTimesOf(const std::string& path) {
  if (path.empty()) return BestTimeStore(utcNow);
  auto read = readBestTimes(path);
  if (auto* times = std::get_if<BestTimes>(&read)) return {utcNow, path, std::move(*times)};
  throw usageError(std::get<std::vector<std::string>>(read));
}

TimePoint steadyNow() { return std::chrono::steady_clock::now(); }

UtcTime utcNow() { return std::chrono::floor<std::chrono::seconds>(std::chrono::system_clock::now()); }

DedicatedServer::DedicatedServer(const ServerSettings& settings, std::vector<LevelPointer> levels, Log log,
                                 TimePoint start)
    : DedicatedServer(std::make_unique<UdpSocket>(settings.bind, settings.port), settings, std::move(levels),
                      std::move(log), start) {}

DedicatedServer::DedicatedServer(std::unique_ptr<DatagramSocket> socket, const ServerSettings& settings,
                                 std::vector<LevelPointer> levels, Log log, TimePoint start)
    : log_(std::move(log)),
      identity_(settings.identity ? *settings.identity : ServerIdentity::random()),
      host_(std::move(socket), identity_, hostSettings(settings, identity_), timeOf(start), hostRules()),
      bestTimeFile_(settings.bestTimes),
      bestTimes_(bestTimesOf(settings.bestTimes)),
      match_(LevelRotation(std::move(levels), settings.start), matchSettings(settings), matchProgram()),
      clock_(start),
      nextLogAt_(start + kRejectedLogInterval) {
  if (!settings.recordings.empty()) recordings_.emplace(writeTo(settings));
  updateInfo();
}

HostRules DedicatedServer::hostRules() {
  HostRules rules;
  rules.ban = [this](const IpAddress& address) {
    const Ban* const ban = banOf(address);
    return ban ? std::optional(refusalOf(*ban)) : std::nullopt;
  };
  rules.banned = [this](const IpAddress& address) {
    if (const Ban* const ban = banOf(address)) logBanned(address, *ban);
  };
  rules.mayMove = [this](ClientId client, const IpAddress& to) { return match_.move(client, to); };
  return rules;
}

MatchProgram DedicatedServer::matchProgram() {
  MatchProgram program;
  program.room = [this](ClientId client) {
    const std::size_t room = host_.room(client);
    return room - std::min(room, kReservedRoom);
  };
  program.roundTrip = [this](ClientId client) { return host_.roundTripMs(client); };
  program.bestTimes = &bestTimes_;
  return program;
}

void DedicatedServer::setName(std::string_view name) {
  match_.setServerName(name);
  updateInfo();
}

// What lists of servers show.
void DedicatedServer::updateInfo() {
  Info info;
  info.players = static_cast<std::uint16_t>(match_.players());
  info.maxPlayers = static_cast<std::uint16_t>(match_.settings().maxPlayers);
  info.name = match_.settings().serverName;
  info.program = kVersion;
  host_.gate().setInfo(std::move(info));
}

void DedicatedServer::step(TimePoint now) {
  const TimePoint begun = steadyNow();
  const bool wasIdle = match_.idle();
  receive(now);
  if (wasIdle) clock_ = TickClock(now);
  const bool ticks = !wasIdle && clock_.take(now);
  if (ticks) {
    match_.tick();
    const std::uint64_t received = host_.gate().traffic().receivedPackets;
    flooded_ = received - receivedBeforeTick_ > kFloodPackets;
    receivedBeforeTick_ = received;
  }
  send(now);
  logBestTimes(bestTimes_.poll(now));
  logRejected(now);
  logDropped(now);
  if (!ticks) return;
  const std::chrono::nanoseconds time = steadyNow() - begun;
  tickTimes_.add(time);
  recentTickTimes_.add(now, time);
}

void DedicatedServer::receive(TimePoint now) {
  receivedAt_ = now;
  for (const HostEvent& event : host_.service(timeOf(now))) handle(event, now);
}

void DedicatedServer::handle(const HostEvent& event, TimePoint now) {
  if (event.disconnected) return match_.disconnect(event.client);
  if (!host_.isOpen(event.client)) return;
  const auto message = decodeToServer(event.bytes);
  if (!message) {
    ++host_.rejections().message;
    match_.remove(event.client);
    return sendLast(event.client, encode(Bye{ByeCode::kRemoved, "your client sent a malformed message"}), now);
  }
  const bool wasPlaying = match_.isPlaying(event.client);
  const IpAddress address = host_.addressOf(event.client);
  if (!wasPlaying && refusesBanned(event.client, address, now)) return;
  match_.receive(event.client, *message, address);
  const bool isPlaying = match_.isPlaying(event.client);
  if (isPlaying) host_.admit(event.client);
  if (wasPlaying && !isPlaying) host_.close(event.client, timeOf(now));  // who plays again needs another connection
}

void DedicatedServer::sendLast(ClientId client, std::span<const std::uint8_t> message, TimePoint now) {
  host_.send(client, true, message);
  host_.close(client, timeOf(now));
}

// The address of a client may have been banned after the client had connected.
bool DedicatedServer::refusesBanned(ClientId client, const IpAddress& address, TimePoint now) {
  const Ban* const ban = banOf(address);
  if (!ban) return false;
  ++host_.rejections().banned;
  logBanned(address, *ban);
  sendLast(client, encode(Refused{RefusalCode::kOther, refusalOf(*ban)}), now);
  return true;
}

// The ban that the address is under; null if there is none.
const Ban* DedicatedServer::banOf(const IpAddress& address) const {
  return bans_ ? bans_->find(address, utcNow()) : nullptr;
}

// Call only for an address that has been shown to be the client's: a forged one must not displace others in the log.
void DedicatedServer::logBanned(const IpAddress& address, const Ban& ban) {
  if (!banNotices_.take(address.household(), receivedAt_)) return;
  log_.info("refused banned address", {{"address", address.text()}, {"ban", ban.range.text()}});
}

void DedicatedServer::send(TimePoint now) {
  for (const Outgoing& message : match_.takeOutgoing()) {
    host_.send(message.client, message.reliable, message.bytes);
    if (message.last) host_.close(message.client, timeOf(now));
  }
  host_.flush(timeOf(now));
  const std::vector<MatchEvent> events = match_.takeEvents();
  for (const MatchEvent& event : events) {
    write(log_, event);
    desyncs_ += event.kind == MatchEvent::Kind::kDesync ? 1 : 0;
  }
  if (!events.empty()) updateInfo();
  writeRecordings();
}

void DedicatedServer::writeRecordings() {
  if (!recordings_) return;
  for (RecordingPiece& piece : match_.takeRecording()) {
    recordings_->write(std::move(piece), std::chrono::system_clock::now());
  }
  for (const RecordingEvent& event : recordings_->takeEvents()) {
    write(log_, event);
    stoppedRecordings_ += event.kind == RecordingEvent::Kind::kStopped ? 1 : 0;
  }
}

void DedicatedServer::finishRecordings() {
  if (!recordings_) return;
  const bool finished = recordings_->finish();
  writeRecordings();
  if (!finished) log_.warning("recording stopped", {{"reason", "the disk does not answer"}});
}

// Logs why the best times could not be written, and the end of such a failure.
void DedicatedServer::logBestTimes(const std::optional<std::string>& fault) {
  if (!fault && (!bestTimesUnwritten_ || bestTimes_.pending())) return;
  const LogField file{"file", bestTimeFile_};
  bestTimesUnwritten_ = fault.has_value();
  if (fault)
    log_.warning("best times not written", {file, {"reason", *fault}});
  else
    log_.info("best times written", {file});
}

void DedicatedServer::logRejected(TimePoint now) {
  if (now < nextLogAt_) return;
  nextLogAt_ = now + kRejectedLogInterval;
  const std::vector<Rejection> rejected = host_.rejections().list();
  std::vector<LogField> fields;
  for (std::size_t i = 0; i < rejected.size(); ++i) {
    const std::uint64_t before = logged_.empty() ? 0 : logged_[i].count;
    if (rejected[i].count != before) fields.push_back({rejected[i].reason, rejected[i].count - before});
  }
  if (!fields.empty()) log_.warning("traffic rejected", fields);
  logged_ = rejected;
}

// A server that is always too slow says so at times, not in every tick.
void DedicatedServer::logDropped(TimePoint now) {
  droppedTicks_ += clock_.takeDropped();
  if (droppedTicks_ == loggedDroppedTicks_ || now < nextDroppedLogAt_) return;
  nextDroppedLogAt_ = now + kRejectedLogInterval;
  log_.warning("ticks dropped", {{"ticks", droppedTicks_ - std::exchange(loggedDroppedTicks_, droppedTicks_)}});
}

// In a flood, the system's buffer does not hold what arrives in a whole tick.
void DedicatedServer::wait() {
  if (!match_.idle()) {
    const std::chrono::nanoseconds left = clock_.next() - now_();
    return std::this_thread::sleep_for(flooded_ ? std::min<std::chrono::nanoseconds>(left, kFloodInterval) : left);
  }
  host_.wait(idleWait_);
  std::this_thread::sleep_for(kMinIdleWait);
}

void DedicatedServer::run(const std::function<bool()>& stopRequested) {
  while (!stopRequested()) {
    step(now_());
    wait();
  }
  stop(next_.empty() ? "the server stops" : "the server stops; go on at " + next_);
}

void DedicatedServer::stop(const std::string& reason) {
  match_.stop(reason, next_);
  writeRecordings();
  const TimePoint end = steadyNow() + kFarewellTime;
  for (; steadyNow() < end && !host_.empty(); host_.wait(std::chrono::milliseconds(10))) {
    send(now_());
    host_.service(timeOf(now_()));
  }
  finishRecordings();
  logBestTimes(bestTimes_.finish());
  log_.info("tick times", {{"ticks", tickTimes_.count()},
                           {"p50Us", tickTimes_.quantile(0.5)},
                           {"p99Us", tickTimes_.quantile(0.99)},
                           {"longestUs", tickTimes_.longest()}});
}

}  // namespace platon
