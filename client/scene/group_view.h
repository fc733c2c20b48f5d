#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec2.hpp>

#include "client/scene/camera_controls.h"
#include "client/scene/solid_mesh.h"
#include "client/scene/view_point.h"

namespace platon {

/// One view of several players of one machine, as long as it can show all of them well: each from outside, none smaller
/// than kSmallest, and down nearly the same for all. It looks at the middle between them, and the right of the first
/// one is level. It moves smoothly, but jumps to players who are suddenly elsewhere, as after a restart of all, and
/// with an instant cut.
class GroupView {
 public:
  static constexpr double kRate = 5;             ///< of the approach to the players, per second
  static constexpr double kSlowRate = 1.5;       ///< the same with reduced motion
  static constexpr double kSmallest = 0.4;       ///< of the size of a player in its own view
  static constexpr double kSlant = 0.35;         ///< sine of the least angle under which the face of a player is seen
  static constexpr double kDowns = 0.7;          ///< cosine of the largest angle between their ups in the picture
  static constexpr double kTogetherSeconds = 2;  ///< for which they are together before the picture is one again

  /// Follows the players, of which there is at least one, for `seconds` ≥ 0. `aspect`: width of the picture divided by
  /// its height. `own`: the view of the first player, where this one begins.
  void move(std::span<const Pose> players, const SolidMesh& mesh, const CameraComfort& comfort, double zoom,
            double aspect, const ViewPoint& own, double seconds);
  /// The next `move` begins anew, from the view of the first player.
  void reset() { isSet_ = false; }

  /// Whether one picture shows all players. At first as they are; from apart to together only after kTogetherSeconds.
  bool together() const { return together_; }
  const ViewPoint& view() const { return view_; }

 private:
  ViewPoint view_;
  bool isSet_ = false;
  bool together_ = true;
  double seconds_ = 0;  // for which they have been together
};

/// A part of a picture, in pixels or other units; the corner is the upper left one.
struct PictureArea {
  glm::ivec2 corner{0};
  glm::ivec2 size{0};
};

/// Divides a picture among 1 … 4 views, with `gap` between them: two beside each other, or one above the other in a
/// picture that is higher than wide; of three, the third one has the lower half. Each is at least 1 × 1.
std::vector<PictureArea> areasOf(std::size_t views, glm::ivec2 size, int gap);

}  // namespace platon
