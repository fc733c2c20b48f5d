#pragma once

#include <cstdint>
#include <string>

#include "platon/game/game.h"

namespace platon {

struct MatchSettings {
  std::uint32_t maxPlayers = 16;  ///< 1 … kMaxPlayers
  std::string serverName;         ///< a label; invisible characters are left out
  bool record = false;            ///< record every round
  bool chat = true;               ///< players can talk to each other
  bool waitsForOne = false;       ///< rounds of a client that is alone have no time limit, and the next one starts when
                                  ///< asked; a level for several begins anew when as many have joined as it needs
  bool keepsTimesOfOne = false;   ///< only times of one player (Match::keepTimesOf) outlast the server, those of
                                  ///< attempts in which no more players were connected than the level needs
  std::uint32_t playersPerOrigin = kMaxPlayers;  ///< players of one origin, disconnected ones included
};

}  // namespace platon
