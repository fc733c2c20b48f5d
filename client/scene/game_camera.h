#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include <glm/vec2.hpp>

#include "client/scene/camera.h"
#include "client/scene/camera_controls.h"
#include "client/scene/camera_target.h"
#include "client/scene/element_states.h"
#include "client/scene/solid_folding.h"
#include "client/scene/solid_mesh.h"
#include "client/scene/stage_model.h"
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

/// Turns a view round the solid while the player asks for it, and back afterwards.
class LookRound {
 public:
  static constexpr double kSpeed = 2;      ///< radians a second
  static constexpr double kReturn = 7;     ///< rate of the way back, per second
  static constexpr double kMaxReturn = 5;  ///< radians a second
  static constexpr double kMaxUp = 1.5;    ///< largest angle upwards and downwards, radians

  /// Turns for `seconds` ≥ 0, and by LookInput::turn.
  void update(const LookInput& input, double seconds);
  void reset() { angles_ = glm::dvec2(0); }

  /// To the right and upwards, radians.
  glm::dvec2 angles() const { return angles_; }
  /// The turned view: the same without angles, and with larger ones of the whole solid.
  ViewPoint turned(const ViewPoint& view, const SolidMesh& mesh) const;

 private:
  glm::dvec2 angles_{0};
};

/// The view of a long fall, in which a camera that follows the player would tumble: it goes away until it sees the
/// whole solid, ceases to turn and stands still. Afterwards it turns back the shortest way, and comes nearer meanwhile.
class FarView {
 public:
  static constexpr double kAwaySeconds = 0.8;   ///< of the way there
  static constexpr double kBackSeconds = 0.55;  ///< of the way back, for each radian, but at least kAwaySeconds

  /// The player falls on, or no longer, for `seconds` ≥ 0; `near` is the view that follows the player. With `cuts`
  /// there is no way.
  void move(const ViewPoint& near, bool falls, bool cuts, double seconds);
  /// The view now, which is `near` without a fall.
  ViewPoint view(const ViewPoint& near, const SolidMesh& mesh) const;
  void reset() { *this = FarView(); }

 private:
  glm::dquat orientation(const glm::dquat& near) const;

  double away_ = 0;                // part of the time of the way there, 0 … 1
  double held_ = 0;                // part of the time of the turn back that is left, 1 in a fall
  glm::dquat near_{1, 0, 0, 0};    // of the last move
  glm::dquat beyond_{1, 0, 0, 0};  // the turn from there to the view of the fall
};

/// A short push of the camera towards the player who crosses an edge.
class CrossingPush {
 public:
  static constexpr double kNearer = 0.03;  ///< part of the distance by which it comes nearer, at most
  static constexpr double kSeconds = 0.3;  ///< there and back
  static constexpr double kPause = 0.6;    ///< from the begin of a push to the next, at least

  /// The player is here, `seconds` ≥ 0 after the last move.
  void move(const Pose& player, double seconds);
  /// Part of the distance by which the camera is nearer now.
  double nearer() const;

 private:
  std::optional<Pose> player_;  // of the last move
  double age_ = kPause;         // of the last push, seconds, at most kPause
};

/// The camera of the game: it flies from the goal to the player at the start of a level, while the unfolded solid is
/// folded, shows the whole face until the player's first input, follows the player, is pushed a little where it crosses
/// an edge, comes slowly nearer at a finish, turns round the solid while the player looks round, and stands still far
/// away while the player falls on and on.
class GameCamera {
 public:
  static constexpr double kNearer = 0.1;             ///< part of the distance by which it comes nearer at a finish
  static constexpr double kApproachSeconds = 1.5;    ///< of the way there
  static constexpr double kWithdrawalSeconds = 0.3;  ///< of the way back
  static constexpr double kPeekRate = 6;             ///< of the way to a view over an edge that opens, per second
  static constexpr double kOverviewSeconds = 0.8;    ///< from the whole face to the player after the first input

  void resize(std::uint32_t w, std::uint32_t h) { camera_.resize(w, h); }
  /// Takes effect at the next `move`. For the zoom see Camera::setZoom.
  void setComfort(const CameraComfort& comfort, double zoom);
  /// Whether a new stage begins with a flight, unless the comfort forbids it; not at first.
  void setFlights(bool flights) { flights_ = flights; }
  /// Whether the picture is still on its way from the goal to the player.
  bool flying() const { return flight_.flying(); }
  void skipFlight() { flight_.skip(); }
  /// Whether the player is at the goal, from the next `move` on: the camera then comes nearer. With reduced motion and
  /// instant cuts, and where it stands still, it does not.
  void setArrived(bool arrived) { arrived_ = arrived; }
  /// Whether the player has begun to play, from the next `move` on. Until then the picture shows its whole face, as far
  /// as FaceHold does; on each stage once, not again after a restart.
  void setBegun(bool begun) { begunNow_ = begun; }
  /// Whether the player falls over edge after edge, from the next `move` on. The camera then goes to where it sees the
  /// whole solid, and stands still there until the player lands. With instant cuts and where it stands still on each
  /// face, it goes there and back at once.
  void setLongFall(bool falls) { longFall_ = falls; }
  /// How far the solid is folded; unfolded, it lies in the plane of the goal: 0 at the start of a flight, 1
  /// without one.
  double folded() const;

  /// Follows `player` for `seconds` ≥ 0. On another stage than before, the camera jumps there. Near an edge it does not
  /// turn to a face to which walls or elements in these states close the way.
  void move(const Pose& player, const std::shared_ptr<const StageModel>& stage, const ElementStates& states,
            const LookInput& look, double seconds);

  /// Whether the last `move` has cut to another view of a camera that stands still and fades, since the last call.
  bool takeFadingCut() { return std::exchange(fadingCut_, false); }

  /// Shows another view until the next `move`, turned as the player looks round.
  void show(const ViewPoint& view, const SolidMesh& mesh) { camera_.show(look_.turned(view, mesh)); }
  /// The next `move` on the same stage begins at this view.
  void goOnFrom(const ViewPoint& view) { camera_.goOnFrom(view); }

  /// The camera that sees the picture.
  const Camera& camera() const { return camera_; }

 private:
  void begin(const Pose& player, const StageModel& stage);
  void peek(const Pose& player, const StageModel& stage, const ElementStates& states, double seconds);
  bool standsCalm() const;
  void approach(double seconds);
  void leaveOverview(double seconds);
  ViewPoint overview(const Pose& player, const SolidMesh& mesh);
  ViewPoint flightView(const ViewPoint& to, const SolidMesh& mesh) const;

  Camera camera_;
  CameraFlight flight_;
  UnfoldingView unfolding_;  // at the start of the flight
  LookRound look_;
  CameraComfort comfort_;
  double zoom_ = 1;
  bool zooming_ = false;  // the zoom has changed since the last move
  bool fadingCut_ = false;
  bool flights_ = false;
  bool arrived_ = false;
  CrossingPush push_;
  double approach_ = 0;       // part of the time of the way nearer, 0 … 1
  std::vector<double> peek_;  // PeekWeights of the camera
  FaceHold wholeFace_;        // until the first input
  double overview_ = 0;       // part of the time that is left of the way from there, 0 … 1
  bool longFall_ = false;
  FarView farView_;    // in a long fall
  bool begun_ = true;  // on this stage
  bool begunNow_ = true;
  std::weak_ptr<const StageModel> stage_;  // of the last move
};

}  // namespace platon
