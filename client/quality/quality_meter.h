#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <optional>
#include <span>

#include "client/quality/quality.h"
#include "client/time/quantile_window.h"
#include "protocol/time.h"

namespace platon {

/// Chooses the quality by the times that pictures take: the best level that holds 60 pictures a second; without one,
/// the fastest. It begins with `high`, and goes up while levels hold, or down until one does.
class QualityMeter {
 public:
  /// Median time of a picture up to which a level holds 60 pictures a second. A quarter of the time of such a picture
  /// is left for the game, and for showing the picture.
  static constexpr double kHoldSeconds = 0.75 / 60;
  /// After these seconds of pictures no other is asked for. If no level has held until then, the choice is the lowest.
  static constexpr double kMaxSeconds = 0.45;
  /// Pictures of each level. The first is not counted: the driver prepares itself for it.
  static constexpr std::size_t kPictures = 4;

  /// The level of the next picture to measure; nothing when the quality is chosen.
  std::optional<QualityLevel> next() const { return next_; }
  /// The picture of level next() took this time.
  void add(double seconds);
  /// The choice by the pictures so far; `high` before the first ones.
  QualityLevel chosen() const { return chosen_; }

 private:
  void endLevel();

  static constexpr QualityLevel kFirst = QualityLevel::kHigh;

  std::optional<QualityLevel> next_ = kFirst;
  QualityLevel chosen_ = kFirst;
  double fastest_ = std::numeric_limits<double>::infinity();  // median time of the fastest level so far
  QuantileWindow<kPictures - 1> times_;                       // of next_
  std::size_t pictures_ = 0;                                  // of next_
  double spent_ = 0;
};

/// The best level that holds 60 pictures a second; without one, the fastest. `seconds` has the median time of a picture
/// of each level, in the order of kQualities.
QualityLevel bestLevel(std::span<const double, kQualities.size()> seconds);

/// Chooses the quality by the first pictures of a match, if the player has not chosen one: less than a second, in which
/// each level is shown for some pictures.
class QualityTrial {
 public:
  /// Pictures of a match that are not measured: in them the level is loaded.
  static constexpr int kSkipped = 10;

  /// The quality of the next picture of a match.
  Quality quality(const QualityChoice& choice) const;
  /// Draws a picture of a match by `draw`. Measures it by the clock `now` while no level is chosen; `finish` waits
  /// until all is drawn. When the level is chosen, it is set.
  void draw(QualityChoice& choice, const std::function<Time()>& now, const std::function<void()>& finish,
            const std::function<void()>& draw);

 private:
  void add(double seconds, QualityChoice& choice);

  QualityMeter meter_;
  int skipped_ = 0;
};

}  // namespace platon
