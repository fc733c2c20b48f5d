#pragma once

#include <enet/enet.h>
#include <enet/time.h>

#include <algorithm>

namespace platon {

/// Sees to it that reliable commands that are not acknowledged are sent again after `mostMs` at the latest; ENet would
/// wait twice as long each time. To be called before every service of the host.
inline void limitPauses(ENetPeer& peer, enet_uint32 mostMs) {
  for (ENetListIterator each = enet_list_begin(&peer.sentReliableCommands);
       each != enet_list_end(&peer.sentReliableCommands); each = enet_list_next(each)) {
    auto* const command = reinterpret_cast<ENetOutgoingCommand*>(each);
    command->roundTripTimeout = std::min(command->roundTripTimeout, mostMs);
    const enet_uint32 due = command->sentTime + command->roundTripTimeout;
    if (ENET_TIME_LESS(due, peer.nextTimeout)) peer.nextTimeout = due;
  }
}

}  // namespace platon
