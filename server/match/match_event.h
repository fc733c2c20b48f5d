#pragma once

#include <cstdint>
#include <string>

namespace platon {

/// Something that happened in a match and that an operator may want to know.
struct MatchEvent {
  enum class Kind {
    kJoined,      ///< text: the player's name
    kRefused,     ///< text: why
    kLost,        ///< the connection is gone, the player stays for a while; text: its name
    kReturned,    ///< text: the player's name
    kLeft,        ///< text: the player's name
    kDesync,      ///< the client's game differed; text: round, tick of the client's hash, tick of the state it was sent
    kBehind,      ///< the client was sent a state because it had not the last ticks; text: as of kDesync
    kRoundStart,  ///< text: the level's title
    kRoundEnd,    ///< text: ticks it took
  };

  Kind kind = Kind::kJoined;
  std::uint32_t client = 0;  ///< of those before kRoundStart; 0 when it has none any more
  std::uint32_t slot = 0;    ///< of those before kRoundStart but kRefused
  std::string text;
};

}  // namespace platon
