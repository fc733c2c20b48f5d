#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <span>
#include <vector>

#include "platon/game/game.h"
#include "platon/game/input.h"
#include "platon/game/recorder.h"

namespace platon {

/// Recording of the last minutes of a game, in bounded memory.
class RecentRecording {
 public:
  /// Old ticks are dropped in blocks of this size.
  static constexpr std::uint32_t kTicksBetweenCheckpoints = 10 * kTicksPerSecond;
  /// Soft limit; a whole round of 16 players takes about a quarter of it.
  static constexpr std::size_t kMaxBytes = std::size_t{1} << 20;

  /// `start`: the game before the first recorded tick.
  explicit RecentRecording(const Game& start);

  /// Records that `game` has been advanced by `inputs`.
  void record(std::span<const Input> inputs, const Game& game);
  /// Ends the recording with the state `game` and returns it. `record` must not be called afterwards.
  std::vector<std::uint8_t> finish(const Game& game);

 private:
  Recorder recorder_;
  std::vector<std::uint8_t> header_;
  std::deque<std::vector<std::uint8_t>> blocks_;  // one per checkpoint, oldest first
  std::size_t blockBytes_ = 0;                    // total size of blocks_
};

/// A desync: the client's confirmed game differs from the server's. Ticks are those of `Game::tick`.
struct Desync {
  std::uint32_t round = 0;
  std::uint32_t matchedAt = 0;          ///< last tick before the desync at which the hashes matched
  std::uint32_t tick = 0;               ///< first tick at which the hashes differed
  std::uint32_t clientHash = 0;         ///< short hash of the client's game after `tick`
  std::uint32_t serverHash = 0;         ///< short hash of the server's game after `tick`
  Game client;                          ///< the client's game at the server's tick if available, else its last state
  std::optional<Game> server;           ///< the server's full state; empty if it never arrived
  std::vector<std::uint8_t> recording;  ///< of the client's confirmed game
};

/// Detects desyncs in the confirmed game of one round and keeps what a report needs.
class DesyncDetector {
 public:
  /// States kept after a desync until the server's state arrives: more ticks than the longest round trip takes.
  static constexpr std::size_t kMaxStates = 256;

  /// `start` is assumed to match the server's game.
  DesyncDetector(std::uint32_t round, const Game& start);

  /// Call when `game` has been advanced by `inputs`.
  void advanced(std::span<const Input> inputs, const Game& game);
  /// Call when the hash of `game` matches the server's. Discards a pending desync.
  void hashMatched(const Game& game);
  /// Call when the hash of `game` differs from the server's. Ignored while a desync is pending.
  void hashDiffered(const Game& game, std::uint32_t serverHash);

  /// Whether the last hash differed, and no state of the server has come since.
  bool pending() const { return pending_.has_value(); }

  /// Call when the client's game has been replaced by the server's state, whose last tick had the inputs `held`.
  /// Returns the pending desync, if any, and starts over.
  std::optional<Desync> resynced(const Game& server, std::span<const Input> held);
  /// Call when the round ends without a resync. Returns the pending desync, if any.
  std::optional<Desync> ended();

 private:
  struct Pending {
    std::uint32_t tick;
    std::uint32_t clientHash;
    std::uint32_t serverHash;
  };

  Desync makeDesync(Game client);
  const Game* stateAt(std::uint32_t tick) const;

  std::uint32_t round_;
  std::uint32_t matchedAt_;
  RecentRecording recording_;
  std::optional<Pending> pending_;
  std::deque<Game> states_;  // of every tick since the desync, oldest first
};

}  // namespace platon
