#pragma once

#include <string>

#include "tests/fuzz/fuzz_targets.h"

namespace platon::fuzz {

/// Hands a datagram to the decoders of the handshake. At most the one of its kind may take it, and what it has taken
/// must give the same bytes again, padding aside.
std::string handshakeFormFault(Bytes datagram);

}  // namespace platon::fuzz
