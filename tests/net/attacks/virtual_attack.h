#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "tests/net/attacks/attack.h"
#include "tests/net/attacks/attacked_server.h"

namespace platon {

/// What an attack did to a server in virtual time.
struct Damage {
  std::uint64_t ticks = 0;                        ///< that four honest players played during the attack, all together
  std::uint64_t missedInputs = 0;                 ///< of these ticks, those for which their input came too late
  int disconnected = 0;                           ///< honest players whose connection or session ended
  std::uint64_t desyncs = 0;                      ///< of honest players
  std::optional<Time> joinTime;                   ///< of a newcomer during the attack; nothing: it has not joined
  std::int64_t heapGrowth = 0;                    ///< of the server, bytes, while the attack ran
  std::size_t maxPlayers = 0;                     ///< largest number of connected players
  std::uint32_t rounds = 0;                       ///< that the server has started
  std::uint64_t amplified = 0;                    ///< strangers who were sent more bytes than were sent in their names
  std::uint64_t bytesToVictims = 0;               ///< from the server to the four
  std::uint64_t bytesAsVictims = 0;               ///< from the attacker in their names
  std::uint64_t heldPlaces = 0;                   ///< sessions that ended without having served a connection
  std::uint64_t sent = 0;                         ///< datagrams of the attacker
  Exchange late;                                  ///< of an attack that amplifies, from kAmplifyingBegins on
  std::map<std::string, std::uint64_t> rejected;  ///< by reason
};

/// Runs an attack on a server with four honest players, at 20 000 datagrams a second. Null: nobody attacks.
Damage attackVirtually(const Attack* attack, const std::string& password = "");

}  // namespace platon
