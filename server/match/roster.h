#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "platon/game/input.h"
#include "protocol/to_client.h"
#include "protocol/to_server.h"
#include "protocol/transport/socket_address.h"
#include "server/match/match_client.h"
#include "server/match/match_output.h"

namespace platon {

/// The names of the players of a match by slot. No two of them look alike.
class PlayerNames {
 public:
  /// Names for the slots 0 … `slots` - 1, all of which are free.
  explicit PlayerNames(std::uint32_t slots) : names_(slots), numbers_(slots) {}

  std::uint32_t slots() const { return static_cast<std::uint32_t>(names_.size()); }

  /// Names the player of a free slot: by what can be seen of `wanted`, or by the number of the slot if that is nothing;
  /// with a number if the name of another player looks like it: "Ann", "Ann 2". `wanted` is a label of at most
  /// kMaxNameBytes, and so is the name.
  const std::string& claim(std::uint32_t slot, std::string_view wanted);
  /// Gives the player of a slot another name, as `claim` does. A muted player stays muted.
  const std::string& rename(std::uint32_t slot, std::string_view wanted);
  /// Frees a slot.
  void release(std::uint32_t slot);
  bool isFree(std::uint32_t slot) const { return names_[slot].empty(); }

  /// Shows the player of a slot that is not free by the number of the slot instead of by its name, or by its name
  /// again.
  void mute(std::uint32_t slot, bool muted);
  bool isMuted(std::uint32_t slot) const { return muted_.contains(slot); }
  /// The name by which clients know the player of a slot; empty for a slot that is free.
  const std::string& shown(std::uint32_t slot) const { return numbers_[slot].empty() ? names_[slot] : numbers_[slot]; }

  /// `Roster` messages with all shown names. Encoded once, until a name changes.
  const std::vector<SharedBytes>& all();
  /// `Roster` messages with the shown names that have changed since the last call; an empty name for a slot that is
  /// free.
  std::vector<SharedBytes> takeChanges();

 private:
  std::string reserve(std::string_view base);
  void noteChange(std::uint32_t slot);

  std::vector<std::string> names_;    // by slot; empty: free
  std::vector<std::string> numbers_;  // names of muted players by slot; empty: shown by its name
  std::set<std::uint32_t> muted_;     // slots
  std::set<std::string> taken_;       // look-alike keys of names_ and numbers_
  std::set<std::uint32_t> changed_;   // slots, since the last takeChanges
  std::optional<std::vector<SharedBytes>> all_;
};

/// What the operator of a server may know of a player.
struct PlayerStatus {
  std::uint32_t slot = 0;
  std::string name;
  std::string shownName;  ///< by which the other players know it
  bool muted = false;
  std::optional<ClientId> client;              ///< nothing while the player is disconnected
  IpAddress address;                           ///< where the last message of its client came from
  std::uint64_t missedInputs = 0;              ///< of this round
  std::optional<std::uint32_t> companionOf{};  ///< slot of the first player of its connection; nothing for that one

  friend bool operator==(const PlayerStatus&, const PlayerStatus&) = default;
};

/// The clients of a match with their players, each in a slot of its own: connected ones, and disconnected ones, which
/// another client can resume. Decides who gets which slot. A household has a limit of players; beyond it, its
/// disconnected ones make room.
class MatchRoster {
 public:
  /// Ticks for which disconnected players can be resumed: 60 s.
  static constexpr std::uint64_t kResumeTicks = 60 * kTicksPerSecond;

  struct Disconnected {
    MatchClient client;
    std::uint64_t since = 0;  ///< tick of the match
  };

  /// The slot of the first player whom a client resumes, or a free one.
  struct Seat {
    std::uint32_t slot = 0;
    bool isResumed = false;
  };

  /// `playersPerOrigin`: limit of a household, disconnected players included.
  MatchRoster(std::uint32_t slots, std::uint32_t playersPerOrigin)
      : names_(slots), playersPerOrigin_(playersPerOrigin) {}

  /// Where a client plays, or why it may not. Without players to resume it joins, unless the match is `closed`, and
  /// disconnected players of its origin may be removed for it. `held`: inputs of the last decided tick.
  std::variant<Seat, Refused> admit(const Hello& hello, std::uint64_t origin, const std::optional<Refused>& closed,
                                    const std::vector<Input>& held, MatchOutput& output);
  /// Gives the client the seat from `admit` at tick `now` of the match.
  MatchClient& seat(ClientId id, const Seat& seat, const Hello& hello, const IpAddress& address, std::uint64_t now,
                    MatchOutput& output);
  /// The slot of another player of a connected client, or why it may not have one. `closed`, `held`: as for `admit`.
  std::variant<std::uint32_t, std::string> admitCompanion(const MatchClient& client,
                                                          const std::optional<Refused>& closed,
                                                          const std::vector<Input>& held) const;
  /// Gives a companion, whose local number is free, the slot from `admitCompanion`. Disconnected players of its origin
  /// may be removed for it.
  MatchPlayer& seatCompanion(ClientId id, std::uint32_t slot, const Companion& companion, std::uint64_t now,
                             MatchOutput& output);
  /// Gives a companion that has a slot another name.
  void renameCompanion(ClientId id, const Companion& companion, MatchOutput& output);
  /// Removes the companion with this local number, if there is one.
  void removeCompanion(ClientId id, std::uint32_t local, MatchOutput& output);
  /// Moves a client, if it plays, to another address. Returns false, and moves nothing, if the origin there has no room
  /// for its players besides those that are connected.
  bool move(ClientId id, const IpAddress& address, MatchOutput& output);

  /// The connection of a client was lost at tick `now`. Without a token it is removed with its players.
  void disconnect(ClientId id, std::uint64_t now, MatchOutput& output);
  /// Removes a client with its players.
  void remove(ClientId id, MatchOutput& output);
  /// Removes the player of a slot and tells its client why; the first player of a client with all others, and a
  /// companion so that the client gets no further one. Returns false if the slot has no player.
  bool kick(std::uint32_t slot, const Bye& bye, MatchOutput& output);
  /// Removes those that have been disconnected for kResumeTicks.
  void expire(std::uint64_t now, MatchOutput& output);
  /// Removes all players and tells their clients why.
  void clear(const Bye& bye, MatchOutput& output);

  /// Whether there are no players, neither connected nor disconnected ones.
  bool idle() const { return connected_.empty() && disconnected_.empty(); }
  /// Number of players, disconnected ones included.
  std::size_t size() const;
  /// Number of connected players.
  std::size_t players() const;
  /// The connected clients.
  std::map<ClientId, MatchClient>& connected() { return connected_; }
  const std::map<ClientId, MatchClient>& connected() const { return connected_; }
  /// In the order in which their connections were lost.
  const std::vector<Disconnected>& disconnected() const { return disconnected_; }
  /// The client with this number; null if it does not play.
  MatchClient* find(ClientId id);
  const MatchClient* find(ClientId id) const;
  PlayerNames& names() { return names_; }
  const PlayerNames& names() const { return names_; }
  /// All players, by slot.
  std::vector<PlayerStatus> status() const;

  void startRound();
  /// Decides the inputs of the next tick, by slot.
  std::vector<Input> decideInputs();
  /// Inputs of all rounds that came too late, and differed from what was decided.
  void countMissed(std::uint64_t inputs) { missedInputs_ += inputs; }
  std::uint64_t missedInputs() const { return missedInputs_; }
  /// Clients that were seated since the last call.
  std::vector<ClientId> takeNewcomers() { return std::exchange(newcomers_, {}); }
  /// Sends a message to all connected clients.
  void sendAll(const SharedBytes& bytes, MatchOutput& output) const;

 private:
  const MatchClient* clientWith(const SessionToken& token) const;
  bool isFull(std::uint64_t origin, std::size_t arriving, const MatchClient* known) const;
  std::size_t connectedOf(std::uint64_t origin, const MatchClient* except = nullptr) const;
  Refused refuseOrigin(std::size_t arriving) const;
  Refused refuseFull() const;
  std::optional<std::uint32_t> freeSlot(const std::vector<Input>& held) const;
  void resume(ClientId id, std::uint32_t slot, const std::string& name, MatchOutput& output);
  MatchClient extract(std::uint32_t slot, MatchOutput& output);
  void evictDisconnected(std::uint64_t origin, std::size_t wanted, MatchOutput& output);
  void removeDisconnected(std::vector<Disconnected>::iterator disconnected, MatchOutput& output);
  void removePlayer(ClientId id, MatchClient& client, std::uint32_t local, MatchOutput& output);
  void kickCompanion(ClientId id, MatchClient& client, std::uint32_t local, MatchOutput& output);
  void left(const MatchPlayer& player, ClientId id, MatchOutput& output);
  std::map<ClientId, MatchClient>::iterator connectedIn(std::uint32_t slot);
  std::vector<Disconnected>::iterator disconnectedIn(std::uint32_t slot);

  PlayerNames names_;
  std::uint32_t playersPerOrigin_;
  std::map<ClientId, MatchClient> connected_;
  std::vector<Disconnected> disconnected_;
  std::vector<ClientId> newcomers_;
  std::uint64_t missedInputs_ = 0;
};

}  // namespace platon
