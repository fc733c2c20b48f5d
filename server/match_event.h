#pragma once

#include <cstdint>
#include <string>

namespace platon {

/// Something that happened in a match and that an operator may want to know.
struct MatchEvent {
  enum class Kind {
    kJoined,      ///< text: the player's name
    kRefused,     ///< text: why
    kLeft,        ///< text: the player's name
    kMismatch,    ///< the client's game differed; text: round, tick of the client's hash, tick of the state it was sent
    kBehind,      ///< the client was sent a state because it had not the last ticks; text: as of kMismatch
    kRoundStart,  ///< text: the level's title
    kRoundEnd,    ///< text: ticks it took
  };

  Kind kind = Kind::kJoined;
  std::uint32_t client = 0;  ///< of the first five
  std::uint32_t slot = 0;    ///< of the first five but kRefused
  std::string text;
};

}  // namespace platon
