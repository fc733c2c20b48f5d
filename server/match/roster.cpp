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
  const MatchClient* const known = hello.token ? clientWith(*hello.token) : nullptr;
  if (known == nullptr && closed) return *closed;
  const std::size_t arriving = known ? known->players().size() : 1;
  if (isFull(origin, arriving, known)) return refuseOrigin(arriving);
  if (known != nullptr) return Seat{known->first().slot(), true};
  evictDisconnected(origin, 1, output);
  if (const std::optional<std::uint32_t> slot = freeSlot(held)) return Seat{*slot, false};
  return refuseFull();
}

// Also finds a client that still counts as connected: it may reconnect before the server detects the loss.
const MatchClient* MatchRoster::clientWith(const SessionToken& token) const {
  for (const Disconnected& entry : disconnected_) {
    if (entry.client.hasToken(token)) return &entry.client;
  }
  for (const auto& [id, client] : connected_) {
    if (client.hasToken(token)) return &client;
  }
  return nullptr;
}

// Whether an origin has no room for so many more players, or for those of a client that may be there already. This
// machine has room for any number.
bool MatchRoster::isFull(std::uint64_t origin, std::size_t arriving, const MatchClient* known) const {
  return origin != 0 && connectedOf(origin, known) + arriving > playersPerOrigin_;
}

// Number of connected players there.
std::size_t MatchRoster::connectedOf(std::uint64_t origin, const MatchClient* except) const {
  std::size_t players = 0;
  for (const auto& [id, client] : connected_) {
    if (client.origin() == origin && &client != except) players += client.players().size();
  }
  return players;
}

Refused MatchRoster::refuseOrigin(std::size_t arriving) const {
  const std::string limit = std::to_string(playersPerOrigin_);
  if (arriving == 1) {
    return {RefusalCode::kFull, "your address already has " + limit + " players, which is all that this server allows"};
  }
  return {RefusalCode::kFull, "your address has no room for your " + std::to_string(arriving) +
                                  " players: this server allows " + limit + " there"};
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

MatchClient& MatchRoster::seat(ClientId id, const Seat& seat, const Hello& hello, const IpAddress& address,
                               std::uint64_t now, MatchOutput& output) {
  if (seat.isResumed) {
    resume(id, seat.slot, hello.name, output);
  } else {
    connected_.emplace(id, MatchClient(hello.token, {seat.slot, names_.claim(seat.slot, hello.name), now}));
  }
  MatchClient& client = *find(id);
  client.setAddress(address);
  newcomers_.push_back(id);
  const auto kind = seat.isResumed ? MatchEvent::Kind::kResumed : MatchEvent::Kind::kJoined;
  for (const auto& [local, player] : client.players()) output.add(kind, id, player.slot(), player.name());
  evictDisconnected(client.origin(), 0, output);
  return client;
}

void MatchRoster::resume(ClientId id, std::uint32_t slot, const std::string& name, MatchOutput& output) {
  MatchClient& client = connected_.emplace(id, extract(slot, output)).first->second;
  client.resume();
  client.first().rename(names_.rename(slot, name));
}

// Takes a client from its connection, or from the disconnected ones.
MatchClient MatchRoster::extract(std::uint32_t slot, MatchOutput& output) {
  const auto entry = disconnectedIn(slot);
  if (entry != disconnected_.end()) {
    MatchClient client = std::move(entry->client);
    disconnected_.erase(entry);
    return client;
  }
  const auto connected = connectedIn(slot);
  const Bye bye{ByeCode::kRemoved, "your players were resumed over another connection"};
  output.sendLast(connected->first, encode(bye));
  return std::move(connected_.extract(connected).mapped());
}

// The rules of newcomers hold for companions. Nobody makes room for one that finds no slot.
std::variant<std::uint32_t, std::string> MatchRoster::admitCompanion(const MatchClient& client,
                                                                     const std::optional<Refused>& closed,
                                                                     const std::vector<Input>& held) const {
  if (!client.mayAddCompanions()) {
    return "a player was removed from your connection, so nobody else can join over it: leave and join again";
  }
  if (closed) return closed->reason;
  if (isFull(client.origin(), 1, nullptr)) return refuseOrigin(1).reason;
  if (const std::optional<std::uint32_t> slot = freeSlot(held)) return *slot;
  return refuseFull().reason;
}

MatchPlayer& MatchRoster::seatCompanion(ClientId id, std::uint32_t slot, const Companion& companion, std::uint64_t now,
                                        MatchOutput& output) {
  MatchClient& client = *find(id);
  const std::string& name = names_.claim(slot, companion.name);
  MatchPlayer& player = client.players().emplace(companion.local, MatchPlayer(slot, name, now)).first->second;
  player.setWanted(companion.name);
  if (client.mutesCompanions()) names_.mute(slot, true);
  output.add(MatchEvent::Kind::kJoined, id, slot, name);
  evictDisconnected(client.origin(), 0, output);
  return player;
}

void MatchRoster::renameCompanion(ClientId id, const Companion& companion, MatchOutput& output) {
  MatchPlayer& player = *find(id)->player(companion.local);
  const std::string before = player.name();
  player.rename(names_.rename(player.slot(), companion.name));
  player.setWanted(companion.name);
  if (player.name() != before) output.add(MatchEvent::Kind::kRenamed, id, player.slot(), player.name());
}

void MatchRoster::removeCompanion(ClientId id, std::uint32_t local, MatchOutput& output) {
  MatchClient& client = *find(id);
  if (client.player(local) != nullptr) removePlayer(id, client, local, output);
}

void MatchRoster::removePlayer(ClientId id, MatchClient& client, std::uint32_t local, MatchOutput& output) {
  if (names_.isMuted(client.player(local)->slot())) client.muteCompanions();
  left(*client.player(local), id, output);
  client.players().erase(local);
}

// Removes disconnected clients of an origin until it has room for `wanted` more players. Without this limit a client
// that drops one connection after another could occupy all slots.
void MatchRoster::evictDisconnected(std::uint64_t origin, std::size_t wanted, MatchOutput& output) {
  if (origin == 0) return;
  const auto isOfOrigin = [origin](const Disconnected& entry) { return entry.client.origin() == origin; };
  std::size_t count = wanted + connectedOf(origin);
  for (const Disconnected& entry : disconnected_) count += isOfOrigin(entry) ? entry.client.players().size() : 0;
  while (count > playersPerOrigin_) {
    const auto longest = std::find_if(disconnected_.begin(), disconnected_.end(), isOfOrigin);
    if (longest == disconnected_.end()) return;
    count -= longest->client.players().size();
    removeDisconnected(longest, output);
  }
}

bool MatchRoster::move(ClientId id, const IpAddress& address, MatchOutput& output) {
  MatchClient* const client = find(id);
  if (client == nullptr) return true;
  const std::uint64_t origin = address.household();
  if (isFull(origin, client->players().size(), client)) return false;
  client->setAddress(address);
  evictDisconnected(origin, 0, output);
  return true;
}

void MatchRoster::disconnect(ClientId id, std::uint64_t now, MatchOutput& output) {
  const auto found = connected_.find(id);
  if (found == connected_.end()) return;
  if (!found->second.canResume()) return remove(id, output);
  for (const auto& [local, player] : found->second.players()) {
    output.add(MatchEvent::Kind::kConnectionLost, id, player.slot(), player.name());
  }
  disconnected_.push_back({std::move(found->second), now});
  connected_.erase(found);
}

void MatchRoster::remove(ClientId id, MatchOutput& output) {
  const auto found = connected_.find(id);
  if (found == connected_.end()) return;
  const MatchClient client = std::move(found->second);
  connected_.erase(found);
  for (const auto& [local, player] : client.players()) left(player, id, output);
}

void MatchRoster::removeDisconnected(std::vector<Disconnected>::iterator disconnected, MatchOutput& output) {
  const MatchClient client = std::move(disconnected->client);
  disconnected_.erase(disconnected);
  for (const auto& [local, player] : client.players()) left(player, 0, output);
}

void MatchRoster::left(const MatchPlayer& player, ClientId id, MatchOutput& output) {
  output.add(MatchEvent::Kind::kLeft, id, player.slot(), player.name());
  names_.release(player.slot());
}

bool MatchRoster::kick(std::uint32_t slot, const Bye& bye, MatchOutput& output) {
  if (const auto connected = connectedIn(slot); connected != connected_.end()) {
    auto& [id, client] = *connected;
    if (const std::uint32_t local = *client.localIn(slot); local > 0) {
      const std::string named = names_.shown(slot) + ": " + bye.reason;
      kickCompanion(id, client, local, output);
      output.send(id, encode(LocalSlots{client.slots(), named.size() <= kMaxReasonBytes ? named : bye.reason}));
    } else {
      output.sendLast(id, encode(bye));
      remove(id, output);
    }
    return true;
  }
  const auto found = disconnectedIn(slot);
  if (found == disconnected_.end()) return false;
  if (const std::uint32_t local = *found->client.localIn(slot); local > 0)
    kickCompanion(0, found->client, local, output);
  else
    removeDisconnected(found, output);
  return true;
}

void MatchRoster::kickCompanion(ClientId id, MatchClient& client, std::uint32_t local, MatchOutput& output) {
  client.forbidCompanions();
  removePlayer(id, client, local, output);
}

void MatchRoster::expire(std::uint64_t now, MatchOutput& output) {
  while (!disconnected_.empty() && now - disconnected_.front().since >= kResumeTicks) {
    removeDisconnected(disconnected_.begin(), output);
  }
}

void MatchRoster::clear(const Bye& bye, MatchOutput& output) {
  const SharedBytes last = encode(bye);
  for (const auto& [id, client] : connected_) output.sendLast(id, last);
  connected_.clear();
  disconnected_.clear();
  names_ = PlayerNames(names_.slots());
}

std::size_t MatchRoster::size() const {
  std::size_t players = this->players();
  for (const Disconnected& entry : disconnected_) players += entry.client.players().size();
  return players;
}

std::size_t MatchRoster::players() const {
  std::size_t players = 0;
  for (const auto& [id, client] : connected_) players += client.players().size();
  return players;
}

std::map<ClientId, MatchClient>::iterator MatchRoster::connectedIn(std::uint32_t slot) {
  return std::find_if(connected_.begin(), connected_.end(),
                      [slot](const auto& entry) { return entry.second.localIn(slot).has_value(); });
}

std::vector<MatchRoster::Disconnected>::iterator MatchRoster::disconnectedIn(std::uint32_t slot) {
  return std::find_if(disconnected_.begin(), disconnected_.end(),
                      [slot](const Disconnected& entry) { return entry.client.localIn(slot).has_value(); });
}

MatchClient* MatchRoster::find(ClientId id) {
  const auto found = connected_.find(id);
  return found == connected_.end() ? nullptr : &found->second;
}

const MatchClient* MatchRoster::find(ClientId id) const {
  const auto found = connected_.find(id);
  return found == connected_.end() ? nullptr : &found->second;
}

std::vector<PlayerStatus> MatchRoster::status() const {
  std::vector<PlayerStatus> all;
  const auto add = [this, &all](const MatchClient& client, std::optional<ClientId> id) {
    const std::uint32_t first = client.first().slot();
    for (const auto& [local, player] : client.players()) {
      all.push_back({player.slot(), player.name(), names_.shown(player.slot()), names_.isMuted(player.slot()), id,
                     client.address(), player.missedInputs(), local > 0 ? std::optional(first) : std::nullopt});
    }
  };
  for (const auto& [id, client] : connected_) add(client, id);
  for (const Disconnected& entry : disconnected_) add(entry.client, std::nullopt);
  std::sort(all.begin(), all.end(), [](const PlayerStatus& a, const PlayerStatus& b) { return a.slot < b.slot; });
  return all;
}

void MatchRoster::startRound() {
  for (auto& [id, client] : connected_) client.startRound();
  for (Disconnected& entry : disconnected_) entry.client.startRound();
}

std::vector<Input> MatchRoster::decideInputs() {
  std::vector<Input> inputs;
  const auto decide = [&inputs](MatchClient& client) {
    for (auto& [local, player] : client.players()) {
      const Input input = player.decideInput();
      if (!input.has(Input::kPresent)) continue;
      if (inputs.size() <= player.slot()) inputs.resize(player.slot() + 1);
      inputs[player.slot()] = input;
    }
  };
  for (auto& [id, client] : connected_) decide(client);
  for (Disconnected& entry : disconnected_) decide(entry.client);
  return inputs;
}

void MatchRoster::sendAll(const SharedBytes& bytes, MatchOutput& output) const {
  for (const auto& [id, client] : connected_) output.send(id, bytes);
}

}  // namespace platon
