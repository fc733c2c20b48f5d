#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "protocol/transport/socket_address.h"
#include "server/match/client_id.h"

namespace platon {

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

}  // namespace platon
