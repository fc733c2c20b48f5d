#pragma once

#include <memory>

#include "tests/net/attacks/attack.h"

namespace platon {

/// Attacks of somebody who shakes hands at four addresses. Each is a row of the table in attacks.cpp.
std::unique_ptr<Attacker> guessPasswords(AttackNetwork& network);
std::unique_ptr<Attacker> openSessions(AttackNetwork& network);
std::unique_ptr<Attacker> sendHostileContents(AttackNetwork& network);
std::unique_ptr<Attacker> sendExcess(AttackNetwork& network);
std::unique_ptr<Attacker> roam(AttackNetwork& network);

}  // namespace platon
