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
#include "server/match/match_output.h"
#include "server/match/match_player.h"

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
  std::optional<ClientId> client;  ///< nothing while the player is disconnected
  IpAddress address;               ///< where the last message of its client came from
  std::uint64_t missedInputs = 0;  ///< of this round

  friend bool operator==(const PlayerStatus&, const PlayerStatus&) = default;
};

/// The players of a match, each in a slot of its own: connected ones, and disconnected ones, which a client can resume.
/// Decides who gets which slot. A household has a limit of players; beyond it, its disconnected ones make room.
class MatchRoster {
 public:
  /// Ticks for which a disconnected player can be resumed: 60 s.
  static constexpr std::uint64_t kResumeTicks = 60 * kTicksPerSecond;

  struct Disconnected {
    MatchPlayer player;
    std::uint64_t since = 0;  ///< tick of the match
  };

  /// The slot of the player that a client resumes, or a free one.
  struct Seat {
    std::uint32_t slot = 0;
    bool isResumed = false;
  };

  /// `playersPerOrigin`: limit of a household, disconnected players included.
  MatchRoster(std::uint32_t slots, std::uint32_t playersPerOrigin)
      : names_(slots), playersPerOrigin_(playersPerOrigin) {}

  /// Where a client plays, or why it may not. Without a player to resume it joins, unless the match is `closed`, and a
  /// disconnected player of its origin may be removed for it. `held`: inputs of the last decided tick.
  std::variant<Seat, Refused> admit(const Hello& hello, std::uint64_t origin, const std::optional<Refused>& closed,
                                    const std::vector<Input>& held, MatchOutput& output);
  /// Gives the client the seat from `admit` at tick `now` of the match.
  MatchPlayer& seat(ClientId client, const Seat& seat, const Hello& hello, const IpAddress& address, std::uint64_t now,
                    MatchOutput& output);
  /// Moves the player of a client, if it has one, to another address. Returns false, and moves nothing, if all players
  /// that the origin there may have are connected.
  bool move(ClientId client, const IpAddress& address, MatchOutput& output);

  /// The connection of a client was lost at tick `now`. A player without a token is removed.
  void disconnect(ClientId client, std::uint64_t now, MatchOutput& output);
  /// Removes the player of a client.
  void remove(ClientId client, MatchOutput& output);
  /// Removes the player of a slot and tells its client why. Returns false if the slot has no player.
  bool kick(std::uint32_t slot, const Bye& bye, MatchOutput& output);
  /// Removes the players that have been disconnected for kResumeTicks.
  void expire(std::uint64_t now, MatchOutput& output);
  /// Removes all players and tells their clients why.
  void clear(const Bye& bye, MatchOutput& output);

  /// Whether there are no players, neither connected nor disconnected ones.
  bool idle() const { return connected_.empty() && disconnected_.empty(); }
  /// Number of players, disconnected ones included.
  std::size_t size() const { return connected_.size() + disconnected_.size(); }
  std::map<ClientId, MatchPlayer>& connected() { return connected_; }
  const std::map<ClientId, MatchPlayer>& connected() const { return connected_; }
  /// In the order in which their connections were lost.
  const std::vector<Disconnected>& disconnected() const { return disconnected_; }
  /// The player of a client; null if it has none.
  MatchPlayer* find(ClientId client);
  const MatchPlayer* find(ClientId client) const;
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
  /// Sends a message to all connected players.
  void sendAll(const SharedBytes& bytes, MatchOutput& output) const;

 private:
  const MatchPlayer* playerWith(const SessionToken& token) const;
  bool isFull(std::uint64_t origin, const MatchPlayer* arriving) const;
  std::int64_t connectedOf(std::uint64_t origin, const MatchPlayer* except = nullptr) const;
  Refused refuseOrigin() const;
  Refused refuseFull() const;
  std::optional<std::uint32_t> freeSlot(const std::vector<Input>& held) const;
  void resume(ClientId client, std::uint32_t slot, const std::string& name, MatchOutput& output);
  MatchPlayer extract(std::uint32_t slot, MatchOutput& output);
  void evictDisconnected(std::uint64_t origin, std::uint32_t wanted, MatchOutput& output);
  void removeDisconnected(std::vector<Disconnected>::iterator disconnected, MatchOutput& output);
  void left(const MatchPlayer& player, ClientId client, MatchOutput& output);
  std::map<ClientId, MatchPlayer>::iterator connectedIn(std::uint32_t slot);
  std::vector<Disconnected>::iterator disconnectedIn(std::uint32_t slot);

  PlayerNames names_;
  std::uint32_t playersPerOrigin_;
  std::map<ClientId, MatchPlayer> connected_;
  std::vector<Disconnected> disconnected_;
  std::vector<ClientId> newcomers_;
  std::uint64_t missedInputs_ = 0;
};

}  // namespace platon
