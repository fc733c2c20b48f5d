#pragma once

#include "client/net/connection.h"

namespace platon {

/// Why a gate that has ended the handshake did so, as a sentence for the player.
Connection::Refused refusalOf(const ClientGate& gate);

}  // namespace platon
