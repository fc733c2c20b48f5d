#pragma once

#include <array>
#include <chrono>
#include <cstddef>

#include "client/time/moment.h"
#include "platon/exact/point.h"

namespace platon {

/// Hides corrections of the own player: what the picture still lags behind the prediction. Each correction on its own
/// fades evenly to nothing within 100 ms of when it came. In the player's own frame, so that crossing an edge does not
/// disturb it.
///
/// Corrections come at most once for each message of the server, of which it sends 60 a second: 6 in 100 ms, and after
/// a stall more. Should kMax be fading when another one comes, the oldest fades with the one after it.
class ErrorSmoothing {
 public:
  static constexpr Moment kDuration = std::chrono::milliseconds(100);
  static constexpr std::size_t kMax = 32;

  /// The prediction jumped at `now`, which never decreases; `back` leads from where it is to where it was, subunits,
  /// own frame.
  void add(Point back, Moment now);
  /// What to add to the predicted position at `now`; by less than a subunit for each correction nearer to nothing.
  Point at(Moment now) const;
  void clear() { count_ = 0; }

 private:
  struct Fading {
    Point whole;
    Moment start{};

    Moment left(Moment now) const;
    Point at(Moment now) const;
  };

  void dropFirst();
  void joinFirstTwo(Moment now);

  std::array<Fading, kMax> fading_;  // the first count_, by start
  std::size_t count_ = 0;
};

}  // namespace platon
