#pragma once

#include <array>
#include <optional>

#include "platon/game/solid.h"

namespace platon {

/// Gains of the pads over time: the pad of the present solid fades in while the others fade out, and all are softer
/// for a while after the goal.
class MusicFade {
 public:
  static constexpr double kFadeSeconds = 4;       ///< of a change of solid
  static constexpr double kDuckSeconds = 3;       ///< softest for so long after the goal
  static constexpr double kDuckGain = 0.3;        ///< meanwhile
  static constexpr double kAttackSeconds = 0.3;   ///< to become that soft
  static constexpr double kReleaseSeconds = 2.5;  ///< to become loud again

  /// Advances the time by `seconds`, at least 0. `solid`: whose pad is to be heard; nothing: none.
  void advance(std::optional<SolidKind> solid, double seconds);
  /// The local player has reached the goal.
  void duck() { duckLeft_ = kDuckSeconds; }

  /// 0 … 1. The squares of the gains of two pads add up to 1 while one replaces the other, without a duck.
  double gain(SolidKind solid) const;

 private:
  std::array<double, kSolidKinds> parts_{};  // 0: silent … 1: full; linear in time
  double duckLeft_ = 0;
  double duckGain_ = 1;
};

}  // namespace platon
