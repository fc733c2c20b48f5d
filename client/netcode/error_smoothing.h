#pragma once

#include <array>
#include <chrono>
#include <cstddef>

#include "platon/exact/point.h"
#include "protocol/moment.h"

namespace platon {

/// Hides corrections of the local player's prediction: the offset between drawn and predicted position. Each correction
/// fades linearly to zero within 100 ms. Offsets are in the player's own frame, so that crossing an edge does not
/// disturb them.
///
/// At most one correction comes with each of the server's 60 messages per second: 6 within 100 ms, more after a stall.
/// If more than kMaxCorrections are fading, the oldest is dropped.
class ErrorSmoothing {
 public:
  static constexpr Moment kDuration = std::chrono::milliseconds(100);
  static constexpr std::size_t kMaxCorrections = 32;

  /// Adds a correction made at `now`, which never decreases. `offset`: old minus new position, subunits, in the
  /// player's own frame.
  void add(Point offset, Moment now);
  /// The offset to add to the predicted position at `now`. Each fading correction is rounded towards zero.
  Point at(Moment now) const;
  void clear() { count_ = 0; }

 private:
  struct Correction {
    Point offset;
    Moment start{};

    Moment remaining(Moment now) const;
    Point at(Moment now) const;
  };

  void dropOldest();

  std::array<Correction, kMaxCorrections> corrections_;  // the first count_ are fading, oldest first
  std::size_t count_ = 0;
};

}  // namespace platon
