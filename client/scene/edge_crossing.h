#pragma once

#include <optional>
#include <vector>

#include <glm/vec2.hpp>

#include "client/scene/element_states.h"
#include "client/scene/solid_mesh.h"
#include "client/scene/stage_model.h"

namespace platon {

/// Whether no segment that blocks the local player lies across the straight way from `from` to `to` on a face: a wall,
/// a closed door, a plate or an `up` that blocks. Level units in the frame of the face. It decides nothing but what the
/// picture points out.
bool wayIsFree(const StageModel& stage, const ElementStates& states, int face, glm::dvec2 from, glm::dvec2 to);

/// By face: 1 if nothing lies between the player and the common edge with its face, else 0. Of a face over two edges,
/// as at a corner: the least of those between.
std::vector<double> freeFaces(const StageModel& stage, const ElementStates& states, const Pose& player);

/// What shows that edges are doors and that down is carried over them: an edge that the local player can cross lights
/// up while the ball is near; at a crossing a wave of light spreads from it, and after it an arrow beside the ball
/// points down for a moment and the walls that are floors now are tinted. A ball that falls over edge after edge shows
/// the arrow once. Computed from its poses alone. It decides nothing.
class EdgeCrossing {
 public:
  static constexpr double kReach = 40;  ///< largest distance from the ball to an edge that is lit, level units
  static constexpr double kStill =
      0.35;  ///< light of an edge beside a ball that does not approach it, of the full light
  static constexpr double kRiseSeconds = 0.12;
  static constexpr double kFadeSeconds = 0.3;
  static constexpr double kArrowSeconds = 0.8;
  static constexpr double kTintSeconds = 2.4;
  static constexpr double kArrowPause = 2;   ///< without a crossing, before the next one shows an arrow
  static constexpr double kArrowBelow = 36;  ///< from the ball to the middle of the arrow, level units
  static constexpr double kWaveSeconds = 0.45;
  static constexpr double kWavePause =
      0.5;                                ///< from the begin of a wave to the next, at least: two a second do not flash
  static constexpr double kMaxStep = 60;  ///< a longer way between two pictures is a jump, such as a restart

  /// An edge that is lit.
  struct Glow {
    Marker foot;       ///< the point of the edge nearest to the ball; its up points over the edge
    double light = 0;  ///< 0 … 1
  };
  /// The arrow points against the up of its place.
  struct Arrow {
    Marker place;
    double light = 0;  ///< 0 … 1
  };

  /// A wave that spreads from the point of an edge where the ball has crossed it.
  struct Wave {
    Marker foot;
    double part = 0;  ///< of its time, 0 … 1
  };

  /// Walls whose outward normal points this way on the face carry the ball.
  struct Tint {
    int face = 0;
    glm::vec2 up{0};   ///< unit
    double light = 0;  ///< 0 … 1
  };

  /// The local player is at `pose` at `seconds`. A time before the last one, or a jump, begins anew.
  void advance(const StageModel& stage, const ElementStates& states, const Pose& pose, double seconds);
  /// Nothing is lit, and there is no arrow.
  void reset() { *this = EdgeCrossing(); }
  /// No edge is lit, and there is no wave.
  void darken() {
    glows_.clear();
    waveAge_ = kWavePause;
  }

  /// Each edge at most once.
  const std::vector<Glow>& glows() const { return glows_; }
  std::optional<Wave> wave() const;
  std::optional<Arrow> arrow() const;
  std::optional<Tint> tint() const { return tint_.light > 0 ? std::optional(tint_) : std::nullopt; }

 private:
  void begin(const Pose& pose, int face, double seconds);
  void fade(double passed);
  void light(const StageModel& stage, const ElementStates& states, const Pose& pose, glm::dvec3 way, double passed);
  void follow(const StageModel& stage, const Pose& pose, bool crossed, double passed);
  void spread(const SolidMesh& mesh, const Pose& pose, bool crossed, double passed);
  Glow& glowOf(const SolidMesh& mesh, int edge);

  std::vector<Glow> glows_;
  bool begun_ = false;
  Pose pose_;
  int face_ = 0;
  double seconds_ = 0;
  Marker arrow_;
  double arrowAge_ = kArrowSeconds;
  Tint tint_;
  double tintAge_ = kTintSeconds;
  Marker wave_;
  double waveAge_ = kWavePause;         // seconds, at most kWavePause
  double sinceCrossing_ = kArrowPause;  // seconds, at most kArrowPause
};

}  // namespace platon
