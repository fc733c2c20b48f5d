#pragma once

#include <cstdint>
#include <string>

namespace platon {

/// Something that happened in a match, for the log of the server.
struct MatchEvent {
  enum class Kind {
    kJoined,          ///< text: the player's name
    kRefused,         ///< text: the reason
    kConnectionLost,  ///< the player can be resumed; text: its name
    kResumed,         ///< text: the player's name
    kLeft,            ///< text: the player's name
    kDesync,          ///< the client's game differs; text: round, tick of the client's hash, tick of the state sent
    kResync,          ///< the client lacked ticks that can no longer be repeated; text: as for kDesync
    kChat,            ///< text: what the player says
    kRoundStart,      ///< text: the level's title
    kRoundEnd,        ///< ticks: length of the round; text: why it ended: finished, time, vote or operator
  };

  Kind kind = Kind::kJoined;
  std::uint32_t client = 0;  ///< of the kinds before kRoundStart; 0 when the player has no client
  std::uint32_t slot = 0;    ///< of the kinds before kRoundStart except kRefused
  std::string text;
  std::uint32_t ticks = 0;  ///< of kRoundEnd
};

}  // namespace platon
