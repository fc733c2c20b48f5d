// How long the connections of the players are.
#include <algorithm>

#include "protocol/round_trip_code.h"
#include "server/match/match.h"

namespace platon {

// The newest message makes up for a lost one.
void Match::sendRoundTrips() {
  if (!roundTrip_ || players_.size() < 2 || now_ % kRoundTripsTicks != 0) return;
  RoundTrips message;
  for (const auto& [client, player] : players_) {
    message.codes.resize(std::max<std::size_t>(message.codes.size(), player.slot() + 1), kNoRoundTrip);
    message.codes[player.slot()] = codeOfRoundTrip(roundTrip_(client));
  }
  const SharedBytes bytes = encode(message);
  for (const auto& [client, player] : players_) outgoing_.push_back({client, false, false, bytes});
}

}  // namespace platon
