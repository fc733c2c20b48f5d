#include "server/match/match.h"

#include <algorithm>
#include <cassert>
#include <optional>
#include <utility>
#include <variant>

#include "protocol/label.h"
#include "protocol/version_text.h"

namespace platon {

Match::Match(LevelRotation rotation, MatchSettings settings, MatchProgram program)
    : settings_(std::move(settings)),
      program_(std::move(program)),
      roster_(settings_.maxPlayers, settings_.playersPerOrigin),
      rounds_(std::move(rotation), settings_, program_.bestTimes, output_),
      talk_(settings_.chat, settings_.playersPerOrigin) {
  assert(settings_.maxPlayers >= 1 && settings_.maxPlayers <= kMaxPlayers);
  setServerName(settings_.serverName);
}

void Match::setServerName(std::string_view name) { settings_.serverName = visibleLabel(name); }

void Match::tick() {
  roster_.expire(now_, output_);
  if (idle()) return;
  ++now_;
  greetNewcomers();
  updates_.sendNames(roster_, now_, output_);
  rounds_.played().advance(roster_.decideInputs());
  transfers_.sendChunks(roster_, program_.room, output_);
  updates_.sendTicks(roster_, rounds_.played().history(), now_, output_);
  MatchUpdates::sendRoundTrips(roster_, program_.roundTrip, now_, output_);
  rounds_.proceed(roster_, now_, output_);
}

void Match::receive(ClientId client, const ToServer& message, const IpAddress& address) {
  if (const Hello* hello = std::get_if<Hello>(&message)) return receiveHello(client, *hello, address);
  MatchClient* const known = roster_.find(client);
  if (known == nullptr) return;
  std::visit([this, client, known](const auto& body) { handle(client, *known, body); }, message);
}

// Two connections with the same token would resume the players from each other many times in one tick, if a connection
// that closes could join again.
void Match::receiveHello(ClientId client, const Hello& hello, const IpAddress& address) {
  if (isPlaying(client) || output_.isClosing(client)) return;
  const auto admitted = admit(hello, address);
  if (const Refused* refused = std::get_if<Refused>(&admitted)) {
    output_.sendLast(client, encode(*refused));
    return output_.add(MatchEvent::Kind::kRefused, client, 0, refused->reason);
  }
  const auto& seat = std::get<MatchRoster::Seat>(admitted);
  if (!seat.isResumed) rounds_.awaitPlayer(roster_, output_);
  MatchClient& seated = roster_.seat(client, seat, hello, address, now_, output_);
  if (!seat.isResumed) seated.first().startRound(rounds_.played().ticks());
  welcome(client, seated, hello);
}

std::variant<MatchRoster::Seat, Refused> Match::admit(const Hello& hello, const IpAddress& address) {
  if (hello.rulesVersion != kRulesVersion) {
    return Refused{RefusalCode::kWrongRules, otherVersionText("rules", kRulesVersion, hello.rulesVersion)};
  }
  return roster_.admit(hello, address.household(), closed(), rounds_.played().history().held(), output_);
}

// Why nobody may join; nothing: players may.
std::optional<Refused> Match::closed() const {
  const std::optional<MatchDrain>& drain = rounds_.draining();
  return drain ? std::optional(drain->refusal) : std::nullopt;
}

// Sends all that a client needs to play: Welcome, the slots of its companions, level text, state; with the next tick,
// the names.
void Match::welcome(ClientId id, MatchClient& client, const Hello& hello) {
  const LevelPointer& level = rounds_.level();
  output_.send(id, encode(Welcome{client.first().slot(), round(), level->hash, settings_.maxPlayers, kTicksPerSecond,
                                  settings_.serverName}));
  if (client.players().size() > 1) output_.send(id, encode(LocalSlots{client.slots()}));
  const bool knowsLevel = std::find(hello.levels.begin(), hello.levels.end(), level->hash) != hello.levels.end();
  if (!knowsLevel) transfers_.sendLevel(client, level);
  if (rounds_.played().ticks() > 0) transfers_.sendState(client, rounds_.played(), now_);
  if (const std::optional<RoundEnd> end = rounds_.roundEnd(roster_)) output_.send(id, encode(*end));
}

// What clients are told that have joined or resumed since the last tick.
void Match::greetNewcomers() {
  for (const ClientId client : roster_.takeNewcomers()) {
    if (!isPlaying(client)) continue;
    for (const SharedBytes& names : roster_.names().all()) output_.send(client, names);
    if (const std::optional<VoteCount> told = rounds_.toldVotes()) output_.send(client, encode(*told));
    if (const auto& drain = rounds_.draining()) output_.send(client, encode(Notice{drain->notice}));
  }
}

void Match::handle(ClientId, MatchClient& client, const LevelRequest& request) {
  if (const LevelPointer level = rounds_.findLevel(request.hash)) transfers_.sendLevel(client, level);
}

void Match::handle(ClientId id, MatchClient&, const Leave&) { remove(id); }

void Match::handle(ClientId, MatchClient& client, const Vote& vote) { rounds_.vote(client, vote, now_); }

void Match::handle(ClientId id, MatchClient& client, const LocalChat& chat) {
  talk_.say(id, client, chat, roster_, now_, output_);
}

// A companion that plays may always leave: it can do so no more often than it has joined. Who resumes says all names
// again, which changes nothing.
void Match::handle(ClientId id, MatchClient& client, const Companion& companion) {
  const MatchPlayer* const player = client.player(companion.local);
  const bool ends = !companion.joins && player != nullptr;
  const bool repeats = companion.joins && player != nullptr && player->wanted() == companion.name;
  std::string fault;
  if (ends || (!repeats && client.mayChangeCompanion(now_)))
    fault = changeCompanion(id, client, companion);
  else if (!client.shouldAnswer(companion.local, now_))
    return;
  else if (!repeats)
    fault = "players join here too often: wait two seconds";
  output_.send(id, encode(LocalSlots{client.slots(), fault, companion.local}));
}

// Returns why it cannot be; empty: it is done.
std::string Match::changeCompanion(ClientId id, MatchClient& client, const Companion& companion) {
  if (companion.local >= kMaxLocalPlayers) {
    return "a connection may have at most " + std::to_string(kMaxLocalPlayers) + " players";
  }
  const bool plays = client.player(companion.local) != nullptr;
  if (companion.joins && !plays) return addCompanion(id, client, companion);
  if (companion.joins)
    roster_.renameCompanion(id, companion, output_);
  else
    roster_.removeCompanion(id, companion.local, output_);
  return {};
}

std::string Match::addCompanion(ClientId id, const MatchClient& client, const Companion& companion) {
  const auto admitted = roster_.admitCompanion(client, closed(), rounds_.played().history().held());
  if (const std::string* fault = std::get_if<std::string>(&admitted)) return *fault;
  rounds_.awaitPlayer(roster_, output_);
  const std::uint32_t slot = std::get<std::uint32_t>(admitted);
  roster_.seatCompanion(id, slot, companion, now_, output_).startRound(rounds_.played().ticks());
  return {};
}

void Match::handle(ClientId id, MatchClient& client, const PlayerInputs& inputs) {
  client.arrival().count(inputs.sequence);
  if (inputs.round != round()) return;
  const TickHistory& history = rounds_.played().history();
  roster_.countMissed(client.addInputs(inputs, history.end(), now_));
  if (!client.isCurrent(inputs)) return;
  const bool ahead = inputs.confirmed > history.end();
  if (!ahead && !history.covers(inputs.confirmed)) {
    return resync(id, client, MatchEvent::Kind::kResync, inputs.confirmed);
  }
  if (ahead || inputs.hash != history.hashAfter(inputs.confirmed)) {
    return resync(id, client, MatchEvent::Kind::kDesync, inputs.confirmed);
  }
  client.ticks().acknowledge(inputs.confirmed);
}

void Match::resync(ClientId id, MatchClient& client, MatchEvent::Kind cause, std::uint32_t confirmed) {
  if (!client.transfers().maySendState(now_)) return;
  transfers_.sendState(client, rounds_.played(), now_);
  output_.add(cause, id, client.first().slot(),
              "round " + std::to_string(round()) + " tick " + std::to_string(confirmed) + ", state of tick " +
                  std::to_string(rounds_.played().ticks()));
}

bool Match::kick(std::uint32_t slot, const std::string& reason) {
  return roster_.kick(slot, Bye{ByeCode::kRemoved, visibleLabel(reason)}, output_);
}

bool Match::mute(std::uint32_t slot, bool muted) {
  PlayerNames& names = roster_.names();
  if (slot >= names.slots() || names.isFree(slot)) return false;
  names.mute(slot, muted);
  return true;
}

void Match::say(const std::string& text) { roster_.sendAll(encode(Notice{visibleLabel(text)}), output_); }

void Match::stop(const std::string& reason, const std::string& next) {
  roster_.clear(Bye{ByeCode::kServerStops, visibleLabel(reason), next}, output_);
}

std::vector<RecordingPiece> Match::takeRecording() {
  if (idle()) rounds_.played().endRecording();
  return rounds_.played().takeRecording();
}

}  // namespace platon
