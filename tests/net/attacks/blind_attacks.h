#pragma once

#include <memory>

#include "tests/net/attacks/attack.h"

namespace platon {

/// Attacks of somebody who sees nothing and answers nothing. Each is a row of the table in attacks.cpp.
std::unique_ptr<Attacker> floodEmpty(AttackNetwork& network);
std::unique_ptr<Attacker> floodOversized(AttackNetwork& network);
std::unique_ptr<Attacker> floodRandom(AttackNetwork& network);
std::unique_ptr<Attacker> floodKnocks(AttackNetwork& network);
std::unique_ptr<Attacker> floodVictimKnocks(AttackNetwork& network);
std::unique_ptr<Attacker> floodVersions(AttackNetwork& network);
std::unique_ptr<Attacker> floodBadCookies(AttackNetwork& network);
std::unique_ptr<Attacker> floodQueries(AttackNetwork& network);

}  // namespace platon
