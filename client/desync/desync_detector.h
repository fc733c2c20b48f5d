#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <span>
#include <vector>

#include "client/desync/recent_recording.h"
#include "platon/game/game.h"
#include "platon/game/input.h"

namespace platon {

/// How a client's confirmed game came to differ from the server's. Ticks are those of `Game::tick`.
struct Desync {
  std::uint32_t round = 0;
  std::uint32_t agreedAt = 0;  ///< the last tick after which both games are known to have been the same
  std::uint32_t tick = 0;      ///< the first after which the hashes are known to differ
  std::uint32_t ownHash = 0;   ///< short, after `tick`
  std::uint32_t serverHash = 0;
  Game own;                             ///< after the server's tick where that is possible, else the last there is
  std::uint32_t guessedTicks = 0;       ///< ticks before `own` whose inputs never came: all held what they held last
  std::optional<Game> server;           ///< the server's full state; nothing when it never came
  std::vector<std::uint8_t> recording;  ///< of the own game up to the last tick that was confirmed
};

/// Follows the confirmed game of one round and keeps what is needed to tell how it came to differ.
class DesyncDetector {
 public:
  /// Ticks of a wrong game that are kept until the server's state comes: more than there are in the longest round trip.
  static constexpr std::size_t kMaxStates = 256;

  /// `start` is taken to be the server's game.
  DesyncDetector(std::uint32_t round, const Game& start);

  /// `game` has just been advanced by `inputs`.
  void advanced(std::span<const Input> inputs, const Game& game);
  /// `game` has the hash that the server says. One that was wrong and is right again without the server's state is no
  /// longer of interest.
  void agreed(const Game& game);
  /// `game` has not this short hash that the server says. Only the first since the last `replaced` counts.
  void differs(const Game& game, std::uint32_t serverHash);

  /// The game has been replaced by the server's, in whose last tick the slots did `held`. What was wrong with it, if
  /// anything was; starts anew.
  std::optional<Desync> replaced(const Game& server, std::span<const Input> held);
  /// The game goes no further, and the server's state has not come. What was wrong with it, if anything was.
  std::optional<Desync> abandoned();

 private:
  struct Wrong {
    std::uint32_t tick;
    std::uint32_t ownHash;
    std::uint32_t serverHash;
  };

  Desync desync(Game own);
  const Game* stateAfter(std::uint32_t tick) const;

  std::uint32_t round_;
  std::uint32_t agreedAt_;
  RecentRecording recording_;
  std::optional<Wrong> wrong_;
  std::deque<Game> states_;  // since it is wrong, of every tick
};

}  // namespace platon
