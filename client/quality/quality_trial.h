#pragma once

#include <functional>

#include "client/quality/quality_choice.h"
#include "client/quality/quality_meter.h"
#include "protocol/moment.h"

namespace platon {

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
  void draw(QualityChoice& choice, const std::function<Moment()>& now, const std::function<void()>& finish,
            const std::function<void()>& draw);

 private:
  void add(double seconds, QualityChoice& choice);

  QualityMeter meter_;
  int skipped_ = 0;
};

}  // namespace platon
