#pragma once

#include <chrono>

#include "client/moment.h"
#include "shared/exact/point.h"

namespace platon {

/// Hides corrections of the own player: what the picture still lags behind the prediction, fading to nothing within
/// 100 ms of the last correction. In the player's own frame, so that crossing an edge does not disturb it.
class CorrectionFade {
 public:
  static constexpr Moment kDuration = std::chrono::milliseconds(100);

  /// The prediction jumped at `now`; `back` leads from where it is to where it was, subunits, own frame.
  void add(Point back, Moment now);
  /// What to add to the predicted position at `now`.
  Point at(Moment now) const;
  void clear() { offset_ = Point(); }

 private:
  Point offset_;      // at start_
  Moment start_{};
};

}  // namespace platon
