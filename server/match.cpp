#include "server/match.h"

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

}  // namespace

Match::Match(LevelRotation rotation, MatchSettings settings)
    : rotation_(std::move(rotation)),
      settings_(std::move(settings)),
      game_(rotation_.current()),
      history_(round_, shortHash(game_.hash())) {
  assert(settings_.maxPlayers >= 1 && settings_.maxPlayers <= kMaxPlayers);
  startRound();
}

void Match::receive(ClientId client, const ToServer& message) {
  std::visit([this, client](const auto& body) { handle(client, body); }, message);
}

void Match::handle(ClientId client, const Hello& hello) {
  if (isMember(client)) return;
  const auto refused = refusal(hello);
  if (!refused) return join(client, hello);
  outgoing_.push_back({client, true, true, encode(*refused)});
  note(MatchEvent::Kind::kRefused, client, 0, refused->reason);
}

std::optional<Refused> Match::refusal(const Hello& hello) const {
  if (hello.protocolVersion != kProtocolVersion) {
    return Refused{RefusalCode::kWrongProtocol, versionReason("protocols", kProtocolVersion, hello.protocolVersion)};
  }
  if (hello.rulesVersion != kRulesVersion) {
    return Refused{RefusalCode::kWrongRules, versionReason("rules of the game", kRulesVersion, hello.rulesVersion)};
  }
  if (freeSlot()) return std::nullopt;
  const std::string players = std::to_string(settings_.maxPlayers);
  return Refused{RefusalCode::kFull, "the server is full (" + players + " players): try again later"};
}

// A slot that was left rests until a tick has been decided without it, so that nobody takes over a player.
std::optional<std::uint32_t> Match::freeSlot() const {
  std::set<std::uint32_t> taken;
  for (const auto& [client, member] : members_) taken.insert(member.slot());
  const std::vector<Input>& held = history_.held();
  for (std::uint32_t slot = 0; slot < settings_.maxPlayers; ++slot) {
    const bool rests = !members_.empty() && slot < held.size() && held[slot].has(Input::kPresent);
    if (!taken.contains(slot) && !rests) return slot;
  }
  return std::nullopt;
}

void Match::join(ClientId client, const Hello& hello) {
  const std::uint32_t slot = *freeSlot();
  if (members_.empty() && history_.end() > 0) startRound();
  Member& member = members_.emplace(client, Member(slot, nameOf(hello, slot))).first->second;
  member.joinAt(history_.end());
  introduce(client, member);
  note(MatchEvent::Kind::kJoined, client, slot, member.name());
}

void Match::introduce(ClientId client, const Member& member) {
  Welcome welcome;
  welcome.slot = member.slot();
  welcome.round = round_;
  welcome.levelHash = rotation_.current()->hash;
  welcome.maxPlayers = settings_.maxPlayers;
  welcome.serverName = settings_.serverName;
  send(client, encode(welcome));
  for (const auto& [other, present] : members_) {
    send(client, encode(RosterEntry{present.slot(), present.name()}));
    if (other != client) send(other, encode(RosterEntry{member.slot(), member.name()}));
  }
}

void Match::handle(ClientId client, const LevelRequest& request) {
  const auto found = members_.find(client);
  const LevelPointer level = rotation_.find(request.hash);
  if (found != members_.end() && level) found->second.sendLevel(level);
}

void Match::handle(ClientId client, const Leave&) { disconnect(client); }

void Match::disconnect(ClientId client) {
  const auto found = members_.find(client);
  if (found == members_.end()) return;
  const std::uint32_t slot = found->second.slot();
  note(MatchEvent::Kind::kLeft, client, slot, found->second.name());
  members_.erase(found);
  if (idle()) recorder_.finish(game_);
  sendAll(encode(RosterEntry{slot, ""}));
}

void Match::handle(ClientId client, const PlayerInputs& inputs) {
  const auto found = members_.find(client);
  if (found == members_.end() || inputs.round != round_) return;
  Member& member = found->second;
  member.take(inputs, history_.end());
  if (!member.isCurrent(inputs)) return;
  const bool ahead = inputs.confirmed > history_.end();
  if (!ahead && !history_.covers(inputs.confirmed)) {
    return resync(client, member, MatchEvent::Kind::kBehind, inputs.confirmed);
  }
  if (ahead || inputs.hash != history_.hashAfter(inputs.confirmed)) {
    return resync(client, member, MatchEvent::Kind::kMismatch, inputs.confirmed);
  }
  member.acknowledge(inputs.confirmed);
}

void Match::resync(ClientId client, Member& member, MatchEvent::Kind why, std::uint32_t confirmed) {
  if (!member.mayTakeState(now_)) return;
  const std::uint32_t tick = history_.end();
  member.sendState(round_, tick, encode(FullState{history_.held(), game_.save()}), now_);
  note(why, client, member.slot(),
       "round " + std::to_string(round_) + " tick " + std::to_string(confirmed) + ", state of tick " +
           std::to_string(tick));
}

void Match::tick() {
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
  for (auto& [client, member] : members_) {
    const Input input = member.decide();
    if (!input.has(Input::kPresent)) continue;
    if (inputs.size() <= member.slot()) inputs.resize(member.slot() + 1);
    inputs[member.slot()] = input;
  }
  return inputs;
}

void Match::sendUpdates() {
  const std::uint64_t interval = members_.size() <= kFewPlayers ? 1 : 2;
  for (auto& [client, member] : members_) {
    if (auto piece = member.nextPiece()) send(client, std::move(*piece));
    const bool due = (now_ + member.slot()) % interval == 0;
    const bool follows = member.started() && history_.covers(member.acknowledged());
    if (!due || !follows || member.acknowledged() == history_.end()) continue;
    ConfirmedTicks ticks = history_.collect(member.nextPart());
    member.sentUpTo(ticks.from + ticks.count, history_.end());
    ticks.slack = member.takeSlack();
    outgoing_.push_back({client, false, false, encode(ticks)});
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
  note(MatchEvent::Kind::kRoundStart, 0, 0, rotation_.current()->title);
}

void Match::stop(const std::string& reason) {
  const std::vector<std::uint8_t> bye = encode(Bye{ByeCode::kServerStops, reason});
  for (const auto& [client, member] : members_) outgoing_.push_back({client, true, true, bye});
  members_.clear();
  recorder_.finish(game_);
}

const Member* Match::member(ClientId client) const {
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
