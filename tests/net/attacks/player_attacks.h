#pragma once

#include <memory>

#include "tests/net/attacks/attack.h"

namespace platon {

/// Attacks of players from four addresses. Each is a row of the table in attacks.cpp.
std::unique_ptr<Attacker> acknowledgeNothing(AttackNetwork& network);
std::unique_ptr<Attacker> acknowledgeFalsely(AttackNetwork& network);
std::unique_ptr<Attacker> roamHalf(AttackNetwork& network);
std::unique_ptr<Attacker> acknowledgeInFuture(AttackNetwork& network);
std::unique_ptr<Attacker> roamForPlaces(AttackNetwork& network);
std::unique_ptr<Attacker> sendFarInputs(AttackNetwork& network);
std::unique_ptr<Attacker> sendWrongHashes(AttackNetwork& network);
std::unique_ptr<Attacker> requestLevels(AttackNetwork& network);
std::unique_ptr<Attacker> castVotes(AttackNetwork& network);
std::unique_ptr<Attacker> talkWithoutEnd(AttackNetwork& network);
std::unique_ptr<Attacker> changeCompanions(AttackNetwork& network);
std::unique_ptr<Attacker> sendMalformed(AttackNetwork& network);
std::unique_ptr<Attacker> guessTokens(AttackNetwork& network);
std::unique_ptr<Attacker> joinAndLeave(AttackNetwork& network);
std::unique_ptr<Attacker> joinAndVanish(AttackNetwork& network);

}  // namespace platon
