#pragma once

#include "client/scene/solid_mesh.h"
#include "client/scene/view_point.h"

namespace platon {

/// A flight round the solid from one view to another, which may move meanwhile.
class CameraFlight {
 public:
  static constexpr double kSeconds = 2.5;
  static constexpr double kSkipSeconds = 0.25;  ///< what is left of a flight that is skipped, at most

  void start(const ViewPoint& from);
  /// Ends the flight soon.
  void skip();
  /// Ends the flight at once.
  void stop() { progress_ = 1; }
  /// Flies on for `seconds` ≥ 0.
  void advance(double seconds);
  bool flying() const { return progress_ < 1; }
  /// The part of the time that has passed, 0 … 1.
  double progress() const { return progress_; }

  /// The view on the way to `to`, which is `to` at the end.
  ViewPoint towards(const ViewPoint& to, const SolidMesh& mesh) const;

 private:
  ViewPoint from_;
  double progress_ = 1;  // of the time, 0 … 1
  double speed_ = 0;     // of progress_, per second
};

}  // namespace platon
