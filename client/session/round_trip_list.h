#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "protocol/moment.h"
#include "protocol/round_trip_code.h"
#include "protocol/to_client.h"

namespace platon {

/// The round trips between the server and the players, as the server has told them last.
class RoundTripList {
 public:
  /// A round trip that is older is not known any more: the server tells them every two seconds, but messages may be
  /// lost, and a player who is alone is told none.
  static constexpr Moment kTimeout = std::chrono::seconds(7);

  void receive(RoundTrips message, Moment now) {
    codes_ = std::move(message.codes);
    receivedAt_ = now;
  }

  /// Milliseconds, at most kMaxRoundTripMs; nothing if the player of the slot has none. `now` never decreases.
  std::optional<std::uint32_t> of(std::uint32_t slot, Moment now) const {
    const bool known = slot < codes_.size() && now - receivedAt_ <= kTimeout;
    return known ? roundTripOf(codes_[slot]) : std::nullopt;
  }

 private:
  std::vector<std::uint8_t> codes_;  // by slot
  Moment receivedAt_{};
};

}  // namespace platon
