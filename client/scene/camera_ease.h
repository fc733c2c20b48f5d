#pragma once

#include <algorithm>
#include <cmath>

namespace platon {

/// What is left of `distance` ≥ 0 after `seconds` ≥ 0 of an approach at `rate` × the rest a second, but at `maxSpeed` a
/// second at most. Rate and speed are more than 0. Two calls in turn equal one call with the sum of their times.
inline double leftAfter(double distance, double rate, double maxSpeed, double seconds) {
  const double beyond = std::max(0.0, distance - maxSpeed / rate);
  const double straight = std::min(seconds, beyond / maxSpeed);
  return (distance - maxSpeed * straight) * std::exp(-rate * (seconds - straight));
}

/// A way from 0 to 1 that begins and ends without a jerk, at `part` (0 … 1) of its time.
inline double smootherstep(double part) { return part * part * part * (part * (6 * part - 15) + 10); }

}  // namespace platon
