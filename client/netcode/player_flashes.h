#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "platon/game/player.h"

namespace platon {

/// Brightness of the short flashes that mark players who land after a long fall or finish. Each flash belongs to the
/// tick of its event: replaying ticks adds none, and it shows when the viewer's clock reaches that tick.
class PlayerFlashes {
 public:
  static constexpr std::uint32_t kTicks = 12;        ///< duration of a flash
  static constexpr std::uint32_t kMinAirTicks = 20;  ///< minimum time in the air for a landing to flash

  /// `player` is the state of `slot` after `ticks` ticks. Ignored unless `ticks` exceeds that of all earlier calls for
  /// this slot.
  void observe(std::uint32_t slot, std::uint32_t ticks, const PlayerState& player);

  /// Brightness of the slot's flash at `tick`: 1 at the event, fading to 0 over kTicks; 0 before the event.
  double brightness(std::uint32_t slot, double tick) const;

 private:
  struct Observed {
    std::uint32_t newest = 0;    // last tick observed
    std::uint32_t airTicks = 0;  // since the player last stood
    bool finished = false;
    std::array<std::uint32_t, 4> flashes{};  // ticks of the last events; ring buffer
    std::size_t count = 0;                   // events so far
  };

  std::vector<Observed> players_;  // by slot
};

}  // namespace platon
