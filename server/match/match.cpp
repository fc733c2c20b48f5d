#include "server/match/match.h"

#include <algorithm>
#include <cassert>
#include <set>

#include "protocol/full_state.h"

namespace platon {
namespace {

std::string versionReason(std::string_view what, std::uint32_t ours, std::uint32_t theirs) {
  const std::string_view mend = theirs < ours ? "update your client" : "use the release of the server";
  return std::string(what) + " differ: the server has version " + std::to_string(ours) + ", your client " +
         std::to_string(theirs) + "; " + std::string(mend);
}

std::string nameOf(const Hello& hello, std::uint32_t slot) {
  return hello.name.empty() ? "Player " + std::to_string(slot + 1) : hello.name;
}

// Names by slot, as few messages as they fit into.
std::vector<std::vector<std::uint8_t>> rostersOf(const std::map<std::uint32_t, std::string>& names) {
  std::vector<std::vector<std::uint8_t>> messages;
  Roster roster;
  for (auto name = names.begin(); name != names.end();) {
    roster.entries.push_back({name->first, name->second});
    if (++name != names.end() && roster.entries.size() < kMaxRosterEntries) continue;
    messages.push_back(encode(roster));
    roster.entries.clear();
  }
  return messages;
}

std::optional<Refused> wrongVersion(const Hello& hello) {
  if (hello.protocolVersion != kProtocolVersion) {
    return Refused{RefusalCode::kWrongProtocol, versionReason("protocols", kProtocolVersion, hello.protocolVersion)};
  }
  if (hello.rulesVersion != kRulesVersion) {
    return Refused{RefusalCode::kWrongRules, versionReason("rules of the game", kRulesVersion, hello.rulesVersion)};
  }
  return std::nullopt;
}

}  // namespace

Match::Match(LevelRotation rotation, MatchSettings settings)
    : rotation_(std::move(rotation)),
      settings_(std::move(settings)),
      game_(rotation_.current()),
      history_(round_, shortHash(game_.hash())) {
  assert(settings_.maxPlayers >= 1 && settings_.maxPlayers <= kMaxPlayers);
  startRound();
}

void Match::receive(ClientId client, const ToServer& message, std::uint32_t origin) {
  if (const Hello* hello = std::get_if<Hello>(&message)) return greet(client, *hello, origin);
  std::visit([this, client](const auto& body) { handle(client, body); }, message);
}

void Match::greet(ClientId client, const Hello& hello, std::uint32_t origin) {
  if (isMember(client) || isDismissed(client)) return;
  std::optional<Refused> refused = wrongVersion(hello);
  MatchPlayer* member = refused ? nullptr : takeBack(client, hello);
  if (!refused && !member) {
    makeRoom(origin, 1);
    const std::optional<std::uint32_t> slot = freeSlot();
    if (slot)
      member = &join(client, hello, *slot);
    else
      refused = full();
  }
  if (member) {
    member->setOrigin(origin);
    return makeRoom(origin, 0);
  }
  outgoing_.push_back({client, true, true, encode(*refused)});
  note(MatchEvent::Kind::kRefused, client, 0, refused->reason);
}

// Told in this very tick that its connection ends: two that take a player from each other get no further turn.
bool Match::isDismissed(ClientId client) const {
  return std::any_of(outgoing_.begin(), outgoing_.end(),
                     [client](const Outgoing& message) { return message.last && message.client == client; });
}

// Else who drops connection after connection would come to hold all slots.
void Match::makeRoom(std::uint32_t origin, std::uint32_t wanted) {
  if (origin == 0) return;
  const auto isOfOrigin = [origin](const Away& away) { return away.member.origin() == origin; };
  auto count = wanted + std::count_if(away_.begin(), away_.end(), isOfOrigin);
  for (const auto& [client, member] : members_) count += member.origin() == origin ? 1 : 0;
  for (; count > settings_.playersPerOrigin; --count) {
    const auto longest = std::find_if(away_.begin(), away_.end(), isOfOrigin);
    if (longest == away_.end()) return;
    giveUp(longest);
  }
}

Refused Match::full() const {
  const std::string players = std::to_string(settings_.maxPlayers);
  return {RefusalCode::kFull, "the server is full (" + players + " players): try again later"};
}

// A slot that was left rests until a tick has been decided without it, so that nobody takes over a player.
std::optional<std::uint32_t> Match::freeSlot() const {
  std::set<std::uint32_t> taken;
  for (const auto& [client, member] : members_) taken.insert(member.slot());
  for (const Away& away : away_) taken.insert(away.member.slot());
  const std::vector<Input>& held = history_.held();
  for (std::uint32_t slot = 0; slot < settings_.maxPlayers; ++slot) {
    const bool rests = !idle() && slot < held.size() && held[slot].has(Input::kPresent);
    if (!taken.contains(slot) && !rests) return slot;
  }
  return std::nullopt;
}

MatchPlayer& Match::join(ClientId client, const Hello& hello, std::uint32_t slot) {
  if (idle() && history_.end() > 0) startRound();
  MatchPlayer& member = members_.emplace(client, MatchPlayer(slot, nameOf(hello, slot), hello.token)).first->second;
  member.joinAt(history_.end());
  introduce(client, member, hello);
  note(MatchEvent::Kind::kJoined, client, slot, member.name());
  return member;
}

MatchPlayer* Match::takeBack(ClientId client, const Hello& hello) {
  std::optional<MatchPlayer> known = hello.token ? extract(*hello.token) : std::nullopt;
  if (!known) return nullptr;
  MatchPlayer& member = members_.emplace(client, std::move(*known)).first->second;
  member.takeUp(nameOf(hello, member.slot()));
  introduce(client, member, hello);
  note(MatchEvent::Kind::kReturned, client, member.slot(), member.name());
  return &member;
}

// The client may be back before its old connection is known to be lost.
std::optional<MatchPlayer> Match::extract(const SessionToken& token) {
  for (auto away = away_.begin(); away != away_.end(); ++away) {
    if (!away->member.has(token)) continue;
    MatchPlayer member = std::move(away->member);
    away_.erase(away);
    return member;
  }
  for (auto& [client, member] : members_) {
    if (!member.has(token)) continue;
    outgoing_.push_back({client, true, true, encode(Bye{ByeCode::kRemoved, "you play over another connection now"})});
    return std::move(members_.extract(client).mapped());
  }
  return std::nullopt;
}

// All that a client needs to play, without being asked for it.
void Match::introduce(ClientId client, MatchPlayer& member, const Hello& hello) {
  const LevelPointer& level = rotation_.current();
  send(client, encode(Welcome{member.slot(), round_, level->hash, settings_.maxPlayers, kTicksPerSecond,
                              settings_.serverName}));
  std::map<std::uint32_t, std::string> present;
  for (const auto& [other, player] : members_) present[player.slot()] = player.name();
  for (const Away& away : away_) present[away.member.slot()] = away.member.name();
  for (const auto& roster : rostersOf(present)) send(client, roster);
  rosterChanges_[member.slot()] = member.name();
  if (std::find(hello.levels.begin(), hello.levels.end(), level->hash) == hello.levels.end()) member.sendLevel(level);
  if (history_.end() > 0) sendState(member);
}

void Match::handle(ClientId client, const LevelRequest& request) {
  const auto found = members_.find(client);
  const LevelPointer level = rotation_.find(request.hash);
  if (found != members_.end() && level) found->second.sendLevel(level);
}

void Match::handle(ClientId client, const Leave&) { remove(client); }

void Match::disconnect(ClientId client) {
  const auto found = members_.find(client);
  if (found == members_.end()) return;
  if (!found->second.canBeTakenUp()) return remove(client);
  note(MatchEvent::Kind::kLost, client, found->second.slot(), found->second.name());
  away_.push_back({std::move(found->second), now_});
  members_.erase(found);
}

void Match::remove(ClientId client) {
  const auto found = members_.find(client);
  if (found == members_.end()) return;
  const MatchPlayer member = std::move(found->second);
  members_.erase(found);
  removed(member, client);
}

void Match::forgetAway() {
  while (!away_.empty() && now_ - away_.front().since >= kAwayTicks) giveUp(away_.begin());
}

void Match::giveUp(std::vector<Away>::iterator away) {
  const MatchPlayer member = std::move(away->member);
  away_.erase(away);
  removed(member, 0);
}

void Match::removed(const MatchPlayer& member, ClientId client) {
  note(MatchEvent::Kind::kLeft, client, member.slot(), member.name());
  if (idle()) recorder_.finish(game_);
  rosterChanges_[member.slot()] = "";
}

void Match::handle(ClientId client, const PlayerInputs& inputs) {
  const auto found = members_.find(client);
  if (found == members_.end()) return;
  MatchPlayer& member = found->second;
  member.hear(inputs.sequence);
  if (inputs.round != round_) return;
  member.take(inputs, history_.end());
  if (!member.isCurrent(inputs)) return;
  const bool ahead = inputs.confirmed > history_.end();
  if (!ahead && !history_.covers(inputs.confirmed)) {
    return resync(client, member, MatchEvent::Kind::kBehind, inputs.confirmed);
  }
  if (ahead || inputs.hash != history_.hashAfter(inputs.confirmed)) {
    return resync(client, member, MatchEvent::Kind::kDesync, inputs.confirmed);
  }
  member.acknowledge(inputs.confirmed);
}

void Match::resync(ClientId client, MatchPlayer& member, MatchEvent::Kind why, std::uint32_t confirmed) {
  if (!member.mayTakeState(now_)) return;
  sendState(member);
  note(why, client, member.slot(),
       "round " + std::to_string(round_) + " tick " + std::to_string(confirmed) + ", state of tick " +
           std::to_string(history_.end()));
}

void Match::sendState(MatchPlayer& member) {
  member.sendState(round_, history_.end(), encode(FullState{history_.held(), game_.save()}), now_);
}

void Match::tick() {
  forgetAway();
  for (const auto& roster : rostersOf(std::exchange(rosterChanges_, {}))) sendAll(roster);
  if (idle()) return;
  ++now_;
  const std::vector<Input> inputs = decideInputs();
  if (settings_.record) recorder_.begin(round_, game_);
  game_.advance(inputs);
  const std::uint64_t hash = game_.hash();
  if (settings_.record) recorder_.record(inputs, game_, hash);
  history_.append(inputs, shortHash(hash));
  sendUpdates();
  watchRound();
}

std::vector<Input> Match::decideInputs() {
  std::vector<Input> inputs;
  const auto decide = [&inputs](MatchPlayer& member) {
    const Input input = member.decide();
    if (!input.has(Input::kPresent)) return;
    if (inputs.size() <= member.slot()) inputs.resize(member.slot() + 1);
    inputs[member.slot()] = input;
  };
  for (auto& [client, member] : members_) decide(member);
  for (Away& away : away_) decide(away.member);
  return inputs;
}

void Match::sendUpdates() {
  const std::uint64_t interval = members_.size() <= kFewPlayers ? 1 : 2;
  for (auto& [client, member] : members_) {
    sendPieces(client, member);
    const bool due = (now_ + member.slot()) % interval == 0;
    const bool follows = member.started() && history_.covers(member.acknowledged());
    if (!due || !follows || member.acknowledged() == history_.end()) continue;
    ConfirmedTicks ticks = history_.collect(member.nextPart(history_.end()));
    member.sentUpTo(ticks.from + ticks.count, history_.end());
    ticks.line = member.takeLine();
    ticks.sequence = member.nextSequence();
    outgoing_.push_back({client, false, false, encode(ticks)});
  }
}

void Match::sendPieces(ClientId client, MatchPlayer& member) {
  for (std::size_t sent = 0; sent < kTransferBytesPerTick;) {
    auto piece = member.nextPiece();
    if (!piece) return;
    sent += piece->size();
    send(client, std::move(*piece));
  }
}

void Match::watchRound() {
  const std::uint32_t tick = history_.end();
  if (!overAt_ && game_.over()) {
    overAt_ = tick;
    sendAll(encode(RoundEnd{round_, tick, rotation_.next()->hash}));
    note(MatchEvent::Kind::kRoundEnd, 0, 0, std::to_string(tick));
  } else if (overAt_ && tick - *overAt_ >= kPauseTicks) {
    rotation_.advance();
    startRound();
    sendAll(encode(RoundStart{round_, rotation_.current()->hash}));
  }
}

void Match::startRound() {
  recorder_.finish(game_);
  ++round_;
  game_ = Game(rotation_.current());
  history_ = TickHistory(round_, shortHash(game_.hash()));
  overAt_.reset();
  for (auto& [client, member] : members_) member.startRound();
  for (Away& away : away_) away.member.startRound();
  note(MatchEvent::Kind::kRoundStart, 0, 0, rotation_.current()->title);
}

void Match::stop(const std::string& reason) {
  const std::vector<std::uint8_t> bye = encode(Bye{ByeCode::kServerStops, reason});
  for (const auto& [client, member] : members_) outgoing_.push_back({client, true, true, bye});
  members_.clear();
  away_.clear();
  recorder_.finish(game_);
}

const MatchPlayer* Match::member(ClientId client) const {
  const auto found = members_.find(client);
  return found == members_.end() ? nullptr : &found->second;
}

void Match::send(ClientId client, std::vector<std::uint8_t> bytes) {
  outgoing_.push_back({client, true, false, std::move(bytes)});
}

void Match::sendAll(const std::vector<std::uint8_t>& bytes) {
  for (const auto& [client, member] : members_) send(client, bytes);
}

void Match::note(MatchEvent::Kind kind, ClientId client, std::uint32_t slot, std::string text) {
  events_.push_back({kind, client, slot, std::move(text)});
}

}  // namespace platon
