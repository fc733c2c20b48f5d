#include "server/match/match.h"

#include <algorithm>
#include <cassert>

#include "protocol/label.h"
#include "protocol/version_text.h"

namespace platon {
namespace {

std::optional<Refused> wrongVersion(const Hello& hello) {
  if (hello.rulesVersion == kRulesVersion) return std::nullopt;
  return Refused{RefusalCode::kWrongRules, otherVersionText("rules", kRulesVersion, hello.rulesVersion)};
}

}  // namespace

Match::Match(LevelRotation rotation, MatchSettings settings)
    : rotation_(std::move(rotation)),
      settings_(std::move(settings)),
      game_(rotation_.current()),
      history_(round_, shortHash(game_.hash())),
      names_(settings_.maxPlayers),
      householdChat_(settings_.playersPerOrigin) {
  assert(settings_.maxPlayers >= 1 && settings_.maxPlayers <= kMaxPlayers);
  setServerName(settings_.serverName);
  startRound();
}

void Match::setServerName(std::string_view name) { settings_.serverName = visibleLabel(name); }

void Match::receive(ClientId client, const ToServer& message, const IpAddress& address) {
  if (const Hello* hello = std::get_if<Hello>(&message)) return handleHello(client, *hello, address);
  std::visit([this, client](const auto& body) { handle(client, body); }, message);
}

void Match::handleHello(ClientId client, const Hello& hello, const IpAddress& address) {
  if (isPlaying(client) || isClosing(client)) return;
  const std::uint64_t origin = address.household();
  const std::variant<MatchPlayer*, Refused> admitted = admit(client, hello, origin);
  if (MatchPlayer* const* player = std::get_if<MatchPlayer*>(&admitted)) {
    (*player)->setAddress(address);
    return evictDisconnected(origin, 0);
  }
  const Refused& refused = std::get<Refused>(admitted);
  outgoing_.push_back({client, true, true, encode(refused)});
  addEvent(MatchEvent::Kind::kRefused, client, 0, refused.reason);
}

std::variant<MatchPlayer*, Refused> Match::admit(ClientId client, const Hello& hello, std::uint64_t origin) {
  if (const std::optional<Refused> refused = wrongVersion(hello)) return *refused;
  const MatchPlayer* const known = hello.token ? playerWith(*hello.token) : nullptr;
  if (known == nullptr && draining_) return draining_->refusal;
  if (isFull(origin, known)) return refuseOrigin();
  if (known != nullptr) return &resume(client, hello, *known);
  evictDisconnected(origin, 1);
  if (const std::optional<std::uint32_t> slot = freeSlot()) return &join(client, hello, *slot);
  return refuseFull();
}

// Two connections with the same token would otherwise resume the player from each other many times in one tick.
bool Match::isClosing(ClientId client) const {
  return std::any_of(outgoing_.begin(), outgoing_.end(),
                     [client](const Outgoing& message) { return message.last && message.client == client; });
}

// Whether an origin has no room for another player, or for this one, which may be there already.
bool Match::isFull(std::uint64_t origin, const MatchPlayer* arriving) const {
  return connectedOf(origin, arriving) >= settings_.playersPerOrigin;
}

std::int64_t Match::connectedOf(std::uint64_t origin, const MatchPlayer* except) const {
  if (origin == 0) return 0;
  return std::count_if(players_.begin(), players_.end(), [origin, except](const auto& entry) {
    return entry.second.origin() == origin && &entry.second != except;
  });
}

bool Match::move(ClientId client, const IpAddress& address) {
  const auto found = players_.find(client);
  if (found == players_.end()) return true;
  const std::uint64_t origin = address.household();
  if (isFull(origin, &found->second)) return false;
  found->second.setAddress(address);
  evictDisconnected(origin, 0);
  return true;
}

Refused Match::refuseOrigin() const {
  return {RefusalCode::kFull, "your address already has " + std::to_string(settings_.playersPerOrigin) +
                                  " players, which is all that this server allows"};
}

// Removes disconnected players of an origin until it has room for `wanted` more. Without this limit a client that drops
// one connection after another could occupy all slots.
void Match::evictDisconnected(std::uint64_t origin, std::uint32_t wanted) {
  if (origin == 0) return;
  const auto isOfOrigin = [origin](const Disconnected& entry) { return entry.player.origin() == origin; };
  auto count = wanted + std::count_if(disconnected_.begin(), disconnected_.end(), isOfOrigin);
  count += connectedOf(origin);
  for (; count > settings_.playersPerOrigin; --count) {
    const auto longest = std::find_if(disconnected_.begin(), disconnected_.end(), isOfOrigin);
    if (longest == disconnected_.end()) return;
    removeDisconnected(longest);
  }
}

Refused Match::refuseFull() const {
  const std::string players = std::to_string(settings_.maxPlayers);
  return {RefusalCode::kFull, "the server is full (" + players + " players): try again later"};
}

// A slot is free only after a tick was decided without a player in it, so that its player disappears from the game.
std::optional<std::uint32_t> Match::freeSlot() const {
  const std::vector<Input>& held = history_.held();
  for (std::uint32_t slot = 0; slot < settings_.maxPlayers; ++slot) {
    const bool present = !idle() && slot < held.size() && held[slot].has(Input::kPresent);
    if (names_.isFree(slot) && !present) return slot;
  }
  return std::nullopt;
}

// Whether one more player is what a round waits for, in which a player was alone in a level for several: its clock and
// the time that they share have run for nothing.
bool Match::completesLevel() const {
  return settings_.waitsForOne && !overAt_ && players_.size() >= 1 &&
         players_.size() + 1 == rotation_.current()->players;
}

MatchPlayer& Match::join(ClientId client, const Hello& hello, std::uint32_t slot) {
  if (idle() && history_.end() > 0) {
    if (rotation_.current()->players > 1) rotation_.advance(1);  // the players for whom it was chosen have left
    startRound();
  } else if (completesLevel()) {
    restartRound();
  }
  MatchPlayer joining(slot, names_.claim(slot, hello.name), hello.token, now_);
  MatchPlayer& player = players_.emplace(client, std::move(joining)).first->second;
  player.joinAt(history_.end());
  sendWelcome(client, player, hello);
  addEvent(MatchEvent::Kind::kJoined, client, slot, player.name());
  return player;
}

MatchPlayer& Match::resume(ClientId client, const Hello& hello, const MatchPlayer& known) {
  MatchPlayer& player = players_.emplace(client, extractPlayer(known)).first->second;
  player.resume(names_.rename(player.slot(), hello.name));
  sendWelcome(client, player, hello);
  addEvent(MatchEvent::Kind::kResumed, client, player.slot(), player.name());
  return player;
}

// Also finds a player that still counts as connected: its client may reconnect before the server detects the loss.
const MatchPlayer* Match::playerWith(const SessionToken& token) const {
  for (const Disconnected& entry : disconnected_) {
    if (entry.player.hasToken(token)) return &entry.player;
  }
  for (const auto& [client, player] : players_) {
    if (player.hasToken(token)) return &player;
  }
  return nullptr;
}

// Takes a player from its client, or from the disconnected ones.
MatchPlayer Match::extractPlayer(const MatchPlayer& known) {
  const auto entry = std::find_if(disconnected_.begin(), disconnected_.end(),
                                  [&known](const Disconnected& each) { return &each.player == &known; });
  if (entry != disconnected_.end()) {
    MatchPlayer player = std::move(entry->player);
    disconnected_.erase(entry);
    return player;
  }
  const auto connected =
      std::find_if(players_.begin(), players_.end(), [&known](const auto& each) { return &each.second == &known; });
  const Bye bye{ByeCode::kRemoved, "your player was resumed over another connection"};
  outgoing_.push_back({connected->first, true, true, encode(bye)});
  return std::move(players_.extract(connected).mapped());
}

// Sends all that a client needs to play: Welcome, level text, state; with the next tick, the names.
void Match::sendWelcome(ClientId client, MatchPlayer& player, const Hello& hello) {
  const LevelPointer& level = rotation_.current();
  send(client, encode(Welcome{player.slot(), round_, level->hash, settings_.maxPlayers, kTicksPerSecond,
                              settings_.serverName}));
  newcomers_.push_back(client);
  const bool knowsLevel = std::find(hello.levels.begin(), hello.levels.end(), level->hash) != hello.levels.end();
  if (!knowsLevel) player.sendLevel(transfers_.level(level));
  if (history_.end() > 0) sendState(player);
  if (overAt_) send(client, encode(roundEnd()));
}

void Match::handle(ClientId client, const LevelRequest& request) {
  const auto found = players_.find(client);
  const LevelPointer level = rotation_.find(request.hash);
  if (found != players_.end() && level) found->second.sendLevel(transfers_.level(level));
}

void Match::handle(ClientId client, const Leave&) { remove(client); }

void Match::disconnect(ClientId client) {
  const auto found = players_.find(client);
  if (found == players_.end()) return;
  if (!found->second.canResume()) return remove(client);
  addEvent(MatchEvent::Kind::kConnectionLost, client, found->second.slot(), found->second.name());
  disconnected_.push_back({std::move(found->second), now_});
  players_.erase(found);
}

void Match::remove(ClientId client) {
  const auto found = players_.find(client);
  if (found == players_.end()) return;
  const MatchPlayer player = std::move(found->second);
  players_.erase(found);
  playerLeft(player, client);
}

void Match::expireDisconnected() {
  while (!disconnected_.empty() && now_ - disconnected_.front().since >= kResumeTicks) {
    removeDisconnected(disconnected_.begin());
  }
}

void Match::removeDisconnected(std::vector<Disconnected>::iterator disconnected) {
  const MatchPlayer player = std::move(disconnected->player);
  disconnected_.erase(disconnected);
  playerLeft(player, 0);
}

void Match::playerLeft(const MatchPlayer& player, ClientId client) {
  addEvent(MatchEvent::Kind::kLeft, client, player.slot(), player.name());
  names_.release(player.slot());
  if (idle()) recorder_.finish(game_);
}

void Match::handle(ClientId client, const PlayerInputs& inputs) {
  const auto found = players_.find(client);
  if (found == players_.end()) return;
  MatchPlayer& player = found->second;
  player.countMessage(inputs.sequence);
  if (inputs.round != round_) return;
  player.addInputs(inputs, history_.end(), now_);
  if (!player.isCurrent(inputs)) return;
  const bool ahead = inputs.confirmed > history_.end();
  if (!ahead && !history_.covers(inputs.confirmed)) {
    return resync(client, player, MatchEvent::Kind::kResync, inputs.confirmed);
  }
  if (ahead || inputs.hash != history_.hashAfter(inputs.confirmed)) {
    return resync(client, player, MatchEvent::Kind::kDesync, inputs.confirmed);
  }
  player.acknowledge(inputs.confirmed);
}

void Match::resync(ClientId client, MatchPlayer& player, MatchEvent::Kind cause, std::uint32_t confirmed) {
  if (!player.maySendState(now_)) return;
  sendState(player);
  addEvent(cause, client, player.slot(),
           "round " + std::to_string(round_) + " tick " + std::to_string(confirmed) + ", state of tick " +
               std::to_string(history_.end()));
}

void Match::sendState(MatchPlayer& player) {
  player.sendState(transfers_.state(round_, history_, game_, player.nextSync()), history_.end(), now_);
}

void Match::tick() {
  expireDisconnected();
  if (idle()) return;
  ++now_;
  sendRosters();
  const std::vector<Input> inputs = decideInputs();
  if (settings_.record) recorder_.begin(round_, game_);
  game_.advance(inputs);
  const std::uint64_t hash = game_.hash();
  if (settings_.record) recorder_.record(inputs, game_, hash);
  history_.append(inputs, shortHash(hash));
  sendTransfers();
  sendTicks();
  sendRoundTrips();
  finishRound();
}

// A newcomer gets all names. The others get the changes, several at a time when many clients join.
void Match::sendRosters() {
  for (const ClientId client : std::exchange(newcomers_, {})) {
    if (!isPlaying(client)) continue;
    for (const SharedBytes& roster : names_.all()) send(client, roster);
    if (const std::optional<VoteCount> told = voteNotices_.told()) send(client, encode(*told));
    if (draining_) send(client, encode(Notice{draining_->notice}));
  }
  if (now_ < nextRosterAt_) return;
  const std::vector<SharedBytes> changes = names_.takeChanges();
  for (const SharedBytes& roster : changes) sendAll(roster);
  if (!changes.empty()) nextRosterAt_ = now_ + kRosterTicks;
}

std::vector<Input> Match::decideInputs() {
  std::vector<Input> inputs;
  const auto decide = [&inputs](MatchPlayer& player) {
    const Input input = player.decideInput();
    if (!input.has(Input::kPresent)) return;
    if (inputs.size() <= player.slot()) inputs.resize(player.slot() + 1);
    inputs[player.slot()] = input;
  };
  for (auto& [client, player] : players_) {
    const std::uint64_t before = player.missedInputs();
    decide(player);
    missedInputs_ += player.missedInputs() - before;
  }
  for (Disconnected& entry : disconnected_) decide(entry.player);
  return inputs;
}

// Clients take turns: if the chunks of one tick do not suffice for all, the next tick continues with the next client.
void Match::sendTransfers() {
  std::size_t left = kMaxChunksPerTick;
  auto next = players_.lower_bound(nextTransfer_);
  for (std::size_t visited = 0; visited < players_.size() && left > 0; ++visited) {
    if (next == players_.end()) next = players_.begin();
    left -= sendChunks(next->first, next->second, left);
    ++next;
  }
  nextTransfer_ = next == players_.end() ? 0 : next->first;
}

std::size_t Match::sendChunks(ClientId client, MatchPlayer& player, std::size_t maxChunks) {
  if (!player.hasChunks()) return 0;
  const std::size_t limit = std::min({kClientChunksPerTick, maxChunks, room_ ? room_(client) : kClientChunksPerTick});
  std::size_t chunks = 0;
  for (; chunks < limit; ++chunks) {
    auto chunk = player.nextChunk();
    if (!chunk) break;
    send(client, std::move(*chunk));
  }
  return chunks;
}

// Ticks between two messages to a player. With more players, each message costs more, and there are more messages.
std::uint32_t Match::sendInterval() const {
  if (players_.size() <= kFewPlayers) return 1;
  return players_.size() <= kManyPlayers ? 2 : 3;
}

// When many players change buttons, a message may hold fewer ticks than are decided before the next one. The rest
// follows in the next ticks.
void Match::sendTicks() {
  const std::uint32_t interval = sendInterval();
  for (auto& [client, player] : players_) {
    const bool due = (now_ + player.slot()) % interval == 0 || player.fallsBehind(interval);
    const bool follows = player.started() && history_.covers(player.acknowledged());
    if (!due || !follows || player.acknowledged() == history_.end()) continue;
    history_.collect(player.nextTickToSend(history_.end(), interval), ticks_);
    player.ticksSent(ticks_.from, ticks_.from + ticks_.count, history_.end());
    ticks_.link = player.takeLinkReport();
    ticks_.sequence = player.nextSequence();
    outgoing_.push_back({client, false, false, encode(ticks_)});
  }
}

const MatchPlayer* Match::player(ClientId client) const {
  const auto found = players_.find(client);
  return found == players_.end() ? nullptr : &found->second;
}

std::span<const Outgoing> Match::takeOutgoing() {
  taken_.clear();
  std::swap(taken_, outgoing_);
  return taken_;
}

void Match::send(ClientId client, SharedBytes bytes) { outgoing_.push_back({client, true, false, std::move(bytes)}); }

void Match::sendAll(const SharedBytes& bytes) {
  for (const auto& [client, player] : players_) send(client, bytes);
}

void Match::addEvent(MatchEvent::Kind kind, ClientId client, std::uint32_t slot, std::string text) {
  events_.push_back({kind, client, slot, std::move(text), 0});
}

}  // namespace platon
