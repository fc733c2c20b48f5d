#pragma once

#include <memory>

#include "tests/net/attacks/attack.h"

namespace platon {

/// Attacks of somebody who reads what passes between the server and its players, and sends in their names. Each is a
/// row of the table in attacks.cpp.
std::unique_ptr<Attacker> floodForged(AttackNetwork& network);
std::unique_ptr<Attacker> floodUnsealed(AttackNetwork& network);
std::unique_ptr<Attacker> floodReplayed(AttackNetwork& network);
std::unique_ptr<Attacker> floodReplayedOpens(AttackNetwork& network);
std::unique_ptr<Attacker> floodMoved(AttackNetwork& network);
std::unique_ptr<Attacker> race(AttackNetwork& network);
std::unique_ptr<Attacker> floodFlipped(AttackNetwork& network);
std::unique_ptr<Attacker> floodTruncated(AttackNetwork& network);
std::unique_ptr<Attacker> floodReflected(AttackNetwork& network);

}  // namespace platon
