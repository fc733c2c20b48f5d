#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "platon/game/game.h"
#include "server/match/level_rotation.h"
#include "server/match/match_output.h"

namespace platon {

class MatchClient;
class MatchRoster;
class PlayedRound;
class TickHistory;

/// A level text or a full state that is sent to one client in chunks. Copies go on independently, but share the
/// messages: each is encoded once, when the first of them needs it.
class Transfer {
 public:
  explicit Transfer(const LevelPointer& level);
  /// `bytes` is the encoded FullState after `tick` ticks of `round`; `sync` is its number in the round.
  Transfer(std::uint32_t round, std::uint32_t tick, std::uint8_t sync, SharedBytes bytes);

  bool isState() const;
  /// Whether both are transfers of the same level.
  bool isSameLevel(const Transfer& other) const;
  bool done() const;
  /// The next message. Must not be called when done.
  SharedBytes nextChunk();

 private:
  struct Messages;

  std::shared_ptr<Messages> messages_;
  std::size_t next_ = 0;
};

/// Makes transfers of levels and states. Those of the same level, and those of the same tick and number, share their
/// messages: many clients that join at once then cost little more than one.
class TransferCache {
 public:
  /// Levels whose messages are kept: the current one and the next.
  static constexpr std::size_t kLevels = 2;

  Transfer level(const LevelPointer& level);
  /// The state of `game` after the ticks of `history`, in round `round`, with the number `sync`.
  Transfer state(std::uint32_t round, const TickHistory& history, const Game& game, std::uint8_t sync);

 private:
  std::vector<Transfer> levels_;                                    // at most kLevels, newest last; none has begun
  std::optional<std::pair<std::uint32_t, std::uint32_t>> stateAt_;  // round and tick of state_
  SharedBytes state_;
  std::vector<std::pair<std::uint8_t, Transfer>> states_;  // of state_, by number; none has begun
};

/// The transfers to one client: those in progress, in order, and how many more it may have.
class ClientTransfers {
 public:
  /// Level texts that a client may request in one round.
  static constexpr std::uint32_t kMaxLevelsPerRound = 8;
  /// Minimum number of ticks between two full states: a client in permanent desync gets one a second.
  static constexpr std::uint64_t kTicksBetweenStates = 60;

  /// Starts a new round: cancels the transfer of a state of the old one.
  void startRound();
  /// Starts again for another client, which has received nothing yet.
  void resume();

  /// Starts this transfer of a level text, unless one is in progress or the client has requested too many.
  void sendLevel(Transfer level);
  /// Whether a full state may be sent at this tick of the match, counted over all rounds.
  bool maySendState(std::uint64_t now) const { return now >= nextStateAt_; }
  /// Number of the last full state in the round; 0: there was none.
  std::uint8_t sync() const { return sync_; }
  /// Number of the next one.
  std::uint8_t nextSync() const { return sync_ == UINT8_MAX ? 1 : static_cast<std::uint8_t>(sync_ + 1); }
  /// Starts this transfer of a full state, whose number is nextSync().
  void sendState(Transfer state, std::uint64_t now);

  /// The next message of the transfers in progress; nothing if there are none.
  std::optional<SharedBytes> nextChunk();
  bool hasChunks() const { return !transfers_.empty(); }

 private:
  void cancelStates();

  std::deque<Transfer> transfers_;
  std::uint32_t levels_ = 0;  // requested in this round
  std::uint64_t nextStateAt_ = 0;
  std::uint8_t sync_ = 0;
};

/// The transfers of a match. In each tick, the clients are sent chunks of what they are to have: a bounded number each
/// and together, and no more than a client has room for.
class MatchTransfers {
 public:
  /// Chunks sent to one client in one tick.
  static constexpr std::size_t kClientChunksPerTick = 8;
  /// Chunks sent to all clients together in one tick.
  static constexpr std::size_t kMaxChunksPerTick = 256;

  /// Starts the transfer of a level to a client.
  void sendLevel(MatchClient& client, const LevelPointer& level);
  /// Starts the transfer of the present state at tick `now` of the match.
  void sendState(MatchClient& client, const PlayedRound& round, std::uint64_t now);
  /// Sends the chunks of this tick. `room`: how many reliable messages a client can be sent; empty: any number.
  void sendChunks(MatchRoster& roster, const std::function<std::size_t(ClientId)>& room, MatchOutput& output);

 private:
  TransferCache cache_;
  ClientId next_ = 0;  // client whose transfers go on first in the next tick
};

}  // namespace platon
