#include "server/match/roster.h"

#include <algorithm>

#include "platon/game/utf8.h"
#include "protocol/label.h"

namespace platon {
namespace {

std::string slotName(std::uint32_t slot) { return "Player " + std::to_string(slot + 1); }

// Shortens the name, by whole characters, until the suffix fits.
std::string withSuffix(std::string_view name, const std::string& suffix) {
  std::size_t length = 0;
  while (length < name.size()) {
    const auto character = decodeUtf8(name.substr(length));
    const std::size_t next = length + (character ? character->length : 1);
    if (next + suffix.size() > kMaxNameBytes) break;
    length = next;
  }
  return visibleLabel(name.substr(0, length)) + suffix;
}

// As few messages as possible.
std::vector<SharedBytes> rostersOf(const std::vector<RosterEntry>& entries) {
  std::vector<SharedBytes> messages;
  Roster roster;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    roster.entries.push_back(entries[i]);
    if (i + 1 < entries.size() && roster.entries.size() < kMaxRosterEntries) continue;
    messages.emplace_back(encode(roster));
    roster.entries.clear();
  }
  return messages;
}

}  // namespace

const std::string& PlayerNames::claim(std::uint32_t slot, std::string_view wanted) {
  const std::string visible = visibleLabel(wanted);
  names_[slot] = reserve(visible.empty() ? slotName(slot) : visible);
  noteChange(slot);
  return names_[slot];
}

const std::string& PlayerNames::rename(std::uint32_t slot, std::string_view wanted) {
  const bool muted = isMuted(slot);
  release(slot);
  claim(slot, wanted);
  mute(slot, muted);
  return names_[slot];
}

void PlayerNames::release(std::uint32_t slot) {
  mute(slot, false);
  taken_.erase(lookAlikeKey(names_[slot]));
  names_[slot].clear();
  noteChange(slot);
}

// The name stays reserved meanwhile, so that nobody else can take it. A name that is the number of the slot is shown as
// it is.
void PlayerNames::mute(std::uint32_t slot, bool muted) {
  if (muted == isMuted(slot)) return;
  if (!muted) {
    muted_.erase(slot);
    if (!numbers_[slot].empty()) taken_.erase(lookAlikeKey(std::exchange(numbers_[slot], {})));
  } else {
    muted_.insert(slot);
    if (lookAlikeKey(names_[slot]) != lookAlikeKey(slotName(slot))) numbers_[slot] = reserve(slotName(slot));
  }
  noteChange(slot);
}

// The name, or with a number if another one looks like it.
std::string PlayerNames::reserve(std::string_view base) {
  std::string name(base);
  for (int number = 2; !taken_.insert(lookAlikeKey(name)).second; ++number) {
    name = withSuffix(base, " " + std::to_string(number));
  }
  return name;
}

void PlayerNames::noteChange(std::uint32_t slot) {
  changed_.insert(slot);
  all_.reset();
}

const std::vector<SharedBytes>& PlayerNames::all() {
  if (all_) return *all_;
  std::vector<RosterEntry> entries;
  for (std::uint32_t slot = 0; slot < names_.size(); ++slot) {
    if (!isFree(slot)) entries.push_back({slot, shown(slot)});
  }
  return all_.emplace(rostersOf(entries));
}

std::vector<SharedBytes> PlayerNames::takeChanges() {
  std::vector<RosterEntry> entries;
  for (const std::uint32_t slot : std::exchange(changed_, {})) entries.push_back({slot, shown(slot)});
  return rostersOf(entries);
}

std::variant<MatchRoster::Seat, Refused> MatchRoster::admit(const Hello& hello, std::uint64_t origin,
                                                            const std::optional<Refused>& closed,
                                                            const std::vector<Input>& held, MatchOutput& output) {
  const MatchPlayer* const known = hello.token ? playerWith(*hello.token) : nullptr;
  if (known == nullptr && closed) return *closed;
  if (isFull(origin, known)) return refuseOrigin();
  if (known != nullptr) return Seat{known->slot(), true};
  evictDisconnected(origin, 1, output);
  if (const std::optional<std::uint32_t> slot = freeSlot(held)) return Seat{*slot, false};
  return refuseFull();
}

// Also finds a player that still counts as connected: its client may reconnect before the server detects the loss.
const MatchPlayer* MatchRoster::playerWith(const SessionToken& token) const {
  for (const Disconnected& entry : disconnected_) {
    if (entry.player.hasToken(token)) return &entry.player;
  }
  for (const auto& [client, player] : connected_) {
    if (player.hasToken(token)) return &player;
  }
  return nullptr;
}

// Whether an origin has no room for another player, or for this one, which may be there already.
bool MatchRoster::isFull(std::uint64_t origin, const MatchPlayer* arriving) const {
  return connectedOf(origin, arriving) >= playersPerOrigin_;
}

std::int64_t MatchRoster::connectedOf(std::uint64_t origin, const MatchPlayer* except) const {
  if (origin == 0) return 0;
  return std::count_if(connected_.begin(), connected_.end(), [origin, except](const auto& entry) {
    return entry.second.origin() == origin && &entry.second != except;
  });
}

Refused MatchRoster::refuseOrigin() const {
  return {RefusalCode::kFull, "your address already has " + std::to_string(playersPerOrigin_) +
                                  " players, which is all that this server allows"};
}

Refused MatchRoster::refuseFull() const {
  const std::string players = std::to_string(names_.slots());
  return {RefusalCode::kFull, "the server is full (" + players + " players): try again later"};
}

// A slot is free only after a tick was decided without a player in it, so that its player disappears from the game.
std::optional<std::uint32_t> MatchRoster::freeSlot(const std::vector<Input>& held) const {
  for (std::uint32_t slot = 0; slot < names_.slots(); ++slot) {
    const bool present = !idle() && slot < held.size() && held[slot].has(Input::kPresent);
    if (names_.isFree(slot) && !present) return slot;
  }
  return std::nullopt;
}

MatchPlayer& MatchRoster::seat(ClientId client, const Seat& seat, const Hello& hello, const IpAddress& address,
                               std::uint64_t now, MatchOutput& output) {
  if (seat.isResumed) {
    resume(client, seat.slot, hello.name, output);
  } else {
    connected_.emplace(client, MatchPlayer(seat.slot, names_.claim(seat.slot, hello.name), hello.token, now));
  }
  MatchPlayer& player = *find(client);
  player.setAddress(address);
  newcomers_.push_back(client);
  output.add(seat.isResumed ? MatchEvent::Kind::kResumed : MatchEvent::Kind::kJoined, client, seat.slot, player.name());
  evictDisconnected(player.origin(), 0, output);
  return player;
}

void MatchRoster::resume(ClientId client, std::uint32_t slot, const std::string& name, MatchOutput& output) {
  MatchPlayer& player = connected_.emplace(client, extract(slot, output)).first->second;
  player.resume(names_.rename(slot, name));
}

// Takes a player from its client, or from the disconnected ones.
MatchPlayer MatchRoster::extract(std::uint32_t slot, MatchOutput& output) {
  const auto entry = disconnectedIn(slot);
  if (entry != disconnected_.end()) {
    MatchPlayer player = std::move(entry->player);
    disconnected_.erase(entry);
    return player;
  }
  const auto connected = connectedIn(slot);
  const Bye bye{ByeCode::kRemoved, "your player was resumed over another connection"};
  output.sendLast(connected->first, encode(bye));
  return std::move(connected_.extract(connected).mapped());
}

// Removes disconnected players of an origin until it has room for `wanted` more. Without this limit a client that drops
// one connection after another could occupy all slots.
void MatchRoster::evictDisconnected(std::uint64_t origin, std::uint32_t wanted, MatchOutput& output) {
  if (origin == 0) return;
  const auto isOfOrigin = [origin](const Disconnected& entry) { return entry.player.origin() == origin; };
  auto count = wanted + std::count_if(disconnected_.begin(), disconnected_.end(), isOfOrigin);
  count += connectedOf(origin);
  for (; count > playersPerOrigin_; --count) {
    const auto longest = std::find_if(disconnected_.begin(), disconnected_.end(), isOfOrigin);
    if (longest == disconnected_.end()) return;
    removeDisconnected(longest, output);
  }
}

bool MatchRoster::move(ClientId client, const IpAddress& address, MatchOutput& output) {
  MatchPlayer* const player = find(client);
  if (player == nullptr) return true;
  const std::uint64_t origin = address.household();
  if (isFull(origin, player)) return false;
  player->setAddress(address);
  evictDisconnected(origin, 0, output);
  return true;
}

void MatchRoster::disconnect(ClientId client, std::uint64_t now, MatchOutput& output) {
  const auto found = connected_.find(client);
  if (found == connected_.end()) return;
  if (!found->second.canResume()) return remove(client, output);
  output.add(MatchEvent::Kind::kConnectionLost, client, found->second.slot(), found->second.name());
  disconnected_.push_back({std::move(found->second), now});
  connected_.erase(found);
}

void MatchRoster::remove(ClientId client, MatchOutput& output) {
  const auto found = connected_.find(client);
  if (found == connected_.end()) return;
  const MatchPlayer player = std::move(found->second);
  connected_.erase(found);
  left(player, client, output);
}

void MatchRoster::removeDisconnected(std::vector<Disconnected>::iterator disconnected, MatchOutput& output) {
  const MatchPlayer player = std::move(disconnected->player);
  disconnected_.erase(disconnected);
  left(player, 0, output);
}

void MatchRoster::left(const MatchPlayer& player, ClientId client, MatchOutput& output) {
  output.add(MatchEvent::Kind::kLeft, client, player.slot(), player.name());
  names_.release(player.slot());
}

bool MatchRoster::kick(std::uint32_t slot, const Bye& bye, MatchOutput& output) {
  if (const auto connected = connectedIn(slot); connected != connected_.end()) {
    const ClientId client = connected->first;
    output.sendLast(client, encode(bye));
    remove(client, output);
    return true;
  }
  const auto found = disconnectedIn(slot);
  if (found == disconnected_.end()) return false;
  removeDisconnected(found, output);
  return true;
}

void MatchRoster::expire(std::uint64_t now, MatchOutput& output) {
  while (!disconnected_.empty() && now - disconnected_.front().since >= kResumeTicks) {
    removeDisconnected(disconnected_.begin(), output);
  }
}

void MatchRoster::clear(const Bye& bye, MatchOutput& output) {
  const SharedBytes last = encode(bye);
  for (const auto& [client, player] : connected_) output.sendLast(client, last);
  connected_.clear();
  disconnected_.clear();
  names_ = PlayerNames(names_.slots());
}

std::map<ClientId, MatchPlayer>::iterator MatchRoster::connectedIn(std::uint32_t slot) {
  return std::find_if(connected_.begin(), connected_.end(),
                      [slot](const auto& entry) { return entry.second.slot() == slot; });
}

std::vector<MatchRoster::Disconnected>::iterator MatchRoster::disconnectedIn(std::uint32_t slot) {
  return std::find_if(disconnected_.begin(), disconnected_.end(),
                      [slot](const Disconnected& entry) { return entry.player.slot() == slot; });
}

MatchPlayer* MatchRoster::find(ClientId client) {
  const auto found = connected_.find(client);
  return found == connected_.end() ? nullptr : &found->second;
}

const MatchPlayer* MatchRoster::find(ClientId client) const {
  const auto found = connected_.find(client);
  return found == connected_.end() ? nullptr : &found->second;
}

std::vector<PlayerStatus> MatchRoster::status() const {
  std::vector<PlayerStatus> all;
  const auto add = [this, &all](const MatchPlayer& player, std::optional<ClientId> client) {
    all.push_back({player.slot(), player.name(), names_.shown(player.slot()), names_.isMuted(player.slot()), client,
                   player.address(), player.inputs().missed()});
  };
  for (const auto& [client, player] : connected_) add(player, client);
  for (const Disconnected& entry : disconnected_) add(entry.player, std::nullopt);
  std::sort(all.begin(), all.end(), [](const PlayerStatus& a, const PlayerStatus& b) { return a.slot < b.slot; });
  return all;
}

void MatchRoster::startRound() {
  for (auto& [client, player] : connected_) player.startRound();
  for (Disconnected& entry : disconnected_) entry.player.startRound();
}

std::vector<Input> MatchRoster::decideInputs() {
  std::vector<Input> inputs;
  const auto decide = [&inputs](MatchPlayer& player) {
    const Input input = player.inputs().decide();
    if (!input.has(Input::kPresent)) return;
    if (inputs.size() <= player.slot()) inputs.resize(player.slot() + 1);
    inputs[player.slot()] = input;
  };
  for (auto& [client, player] : connected_) decide(player);
  for (Disconnected& entry : disconnected_) decide(entry.player);
  return inputs;
}

void MatchRoster::sendAll(const SharedBytes& bytes, MatchOutput& output) const {
  for (const auto& [client, player] : connected_) output.send(client, bytes);
}

}  // namespace platon
