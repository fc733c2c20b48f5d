#pragma once

#include <cstdint>
#include <optional>
#include <variant>
#include <vector>

#include "protocol/to_client.h"

namespace platon {

/// Toggles a button in the first input change of `slot` at or after tick `from`, in messages to a client.
struct InputFlipper {
  std::uint32_t from = 0;
  std::uint8_t slot = 0;
  std::optional<std::uint32_t> tick;  // of the modified change

  void operator()(std::vector<std::uint8_t>& bytes) {
    auto message = decodeToClient(bytes);
    auto* ticks = message ? std::get_if<ConfirmedTicks>(&*message) : nullptr;
    if (ticks == nullptr || tick) return;
    for (InputChange& change : ticks->changes) {
      if (tick || change.slot != slot || change.tick < from || !change.input.has(Input::kPresent)) continue;
      change.input.buttons ^= Input::kRight;
      tick = change.tick;
      bytes = encode(*ticks);
    }
  }
};

}  // namespace platon
