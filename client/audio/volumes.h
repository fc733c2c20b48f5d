#pragma once

namespace platon {

/// Volumes that the player has chosen, 0 … 100. 0 is silence.
struct Volumes {
  double all = 100;
  double effects = 100;
  double music = 100;
};

/// Gain of a volume: half the volume sounds about half as loud.
inline double gainOf(double volume) { return volume * volume / 10000; }

}  // namespace platon
