#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "client/quality/quality.h"
#include "client/time/quantile_window.h"

namespace platon {

/// Chooses the quality by the times that pictures take. It asks for pictures of one level after the other, from the
/// cheapest, and stops at the first that does not hold 60 pictures a second.
class QualityMeter {
 public:
  /// Median time of a picture up to which a level holds 60 pictures a second. A quarter of the time of such a picture
  /// is left for the game, and for showing the picture.
  static constexpr double kHoldSeconds = 0.75 / 60;
  /// After these seconds of pictures no other is asked for.
  static constexpr double kMaxSeconds = 0.4;
  /// Pictures of each level. The first is not counted: the driver prepares itself for it.
  static constexpr std::size_t kPictures = 6;

  /// The level of the next picture to measure; nothing when the quality is chosen.
  std::optional<QualityLevel> next() const { return next_; }
  /// The picture of level next() took this time.
  void add(double seconds);
  /// The best level so far that holds 60 pictures a second; without one, the cheapest.
  QualityLevel chosen() const { return chosen_; }

 private:
  void endLevel();

  std::optional<QualityLevel> next_ = kQualities.front().level;
  QualityLevel chosen_ = kQualities.front().level;
  QuantileWindow<kPictures - 1> times_;  // of next_
  std::size_t pictures_ = 0;             // of next_
  double spent_ = 0;
};

/// The best level that holds 60 pictures a second, as every cheaper one does; without one, the cheapest. `seconds` has
/// the median time of a picture of each level, in the order of kQualities.
QualityLevel bestLevel(std::span<const double> seconds);

}  // namespace platon
