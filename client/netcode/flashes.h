#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "platon/game/player.h"

namespace platon {

/// What happens to players and shows for a moment: that they land after a real fall, and that they finish. Keyed by the
/// tick in which it happens, so that a tick that is replayed repeats nothing, and shown by the clock of whoever looks.
class Flashes {
 public:
  static constexpr std::uint32_t kTicks = 12;     ///< for which a flash shows
  static constexpr std::uint32_t kAirTicks = 20;  ///< in the air, after which a landing counts

  /// The player of `slot` is like this after `ticks` ticks. Only ticks later than any looked at for this slot count: as
  /// a tick was seen first it was shown.
  void look(std::uint32_t slot, std::uint32_t ticks, const PlayerState& player);

  /// How much of the last flash is left at `tick`, from 1 to 0; what happens later does not show.
  double at(std::uint32_t slot, double tick) const;

 private:
  struct Watched {
    std::uint32_t newest = 0;    // tick looked at
    std::uint32_t airTicks = 0;  // since it stood
    bool finished = false;
    std::array<std::uint32_t, 4> flashes{};  // ticks; a ring
    std::size_t count = 0;                   // ever
  };

  std::vector<Watched> players_;  // by slot
};

}  // namespace platon
