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
  MatchPlayer* const player = roster_.find(client);
  if (player == nullptr) return;
  std::visit([this, client, player](const auto& body) { handle(client, *player, body); }, message);
}

// Two connections with the same token would resume the player from each other many times in one tick, if a connection
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
  MatchPlayer& player = roster_.seat(client, seat, hello, address, now_, output_);
  if (!seat.isResumed) player.inputs().startRound(rounds_.played().ticks());
  welcome(client, player, hello);
}

std::variant<MatchRoster::Seat, Refused> Match::admit(const Hello& hello, const IpAddress& address) {
  if (hello.rulesVersion != kRulesVersion) {
    return Refused{RefusalCode::kWrongRules, otherVersionText("rules", kRulesVersion, hello.rulesVersion)};
  }
  const std::optional<MatchDrain>& drain = rounds_.draining();
  const std::optional<Refused> closed = drain ? std::optional(drain->refusal) : std::nullopt;
  return roster_.admit(hello, address.household(), closed, rounds_.played().history().held(), output_);
}

// Sends all that a client needs to play: Welcome, level text, state; with the next tick, the names.
void Match::welcome(ClientId client, MatchPlayer& player, const Hello& hello) {
  const LevelPointer& level = rounds_.level();
  output_.send(client, encode(Welcome{player.slot(), round(), level->hash, settings_.maxPlayers, kTicksPerSecond,
                                      settings_.serverName}));
  const bool knowsLevel = std::find(hello.levels.begin(), hello.levels.end(), level->hash) != hello.levels.end();
  if (!knowsLevel) transfers_.sendLevel(player, level);
  if (rounds_.played().ticks() > 0) transfers_.sendState(player, rounds_.played(), now_);
  if (const std::optional<RoundEnd> end = rounds_.roundEnd(roster_)) output_.send(client, encode(*end));
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

void Match::handle(ClientId, MatchPlayer& player, const LevelRequest& request) {
  if (const LevelPointer level = rounds_.findLevel(request.hash)) transfers_.sendLevel(player, level);
}

void Match::handle(ClientId client, MatchPlayer&, const Leave&) { remove(client); }

void Match::handle(ClientId, MatchPlayer& player, const Vote& vote) { rounds_.vote(player, vote, now_); }

void Match::handle(ClientId client, MatchPlayer& player, const LocalChat& message) {
  talk_.say(client, player, message.chat, roster_, now_, output_);
}

void Match::handle(ClientId client, MatchPlayer& player, const PlayerInputs& inputs) {
  player.inputs().countMessage(inputs.sequence);
  if (inputs.round != round()) return;
  const TickHistory& history = rounds_.played().history();
  roster_.countMissed(player.addInputs(inputs, history.end(), now_));
  if (!player.isCurrent(inputs)) return;
  const bool ahead = inputs.confirmed > history.end();
  if (!ahead && !history.covers(inputs.confirmed)) {
    return resync(client, player, MatchEvent::Kind::kResync, inputs.confirmed);
  }
  if (ahead || inputs.hash != history.hashAfter(inputs.confirmed)) {
    return resync(client, player, MatchEvent::Kind::kDesync, inputs.confirmed);
  }
  player.ticks().acknowledge(inputs.confirmed);
}

void Match::resync(ClientId client, MatchPlayer& player, MatchEvent::Kind cause, std::uint32_t confirmed) {
  if (!player.transfers().maySendState(now_)) return;
  transfers_.sendState(player, rounds_.played(), now_);
  output_.add(cause, client, player.slot(),
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
