#pragma once

#include <cstdint>
#include <memory>
#include <utility>

#include "client/scene/camera.h"
#include "client/scene/camera_comfort.h"
#include "client/scene/camera_flight.h"
#include "client/scene/look_input.h"
#include "client/scene/look_round.h"
#include "client/scene/pose.h"
#include "client/scene/solid_folding.h"
#include "client/scene/stage_model.h"

namespace platon {

/// The camera of the game: it follows the player, flies from the goal to the player at the start of a level, while
/// the unfolded solid is folded, comes slowly nearer at a finish, and turns round the solid while the player looks
/// round.
class GameCamera {
 public:
  static constexpr double kNearer = 0.1;             ///< part of the distance by which it comes nearer at a finish
  static constexpr double kApproachSeconds = 1.5;    ///< of the way there
  static constexpr double kWithdrawalSeconds = 0.3;  ///< of the way back

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
  /// How far the solid is folded; unfolded, it lies in the plane of the goal: 0 at the start of a flight, 1
  /// without one.
  double folded() const;

  /// Follows `player` for `seconds` ≥ 0. On another stage than before, the camera jumps there.
  void move(const Pose& player, const std::shared_ptr<const StageModel>& stage, const LookInput& look, double seconds);

  /// Whether the last `move` has cut to another view of a camera that stands still and fades, since the last call.
  bool takeFadingCut() { return std::exchange(fadingCut_, false); }

  /// The camera that sees the picture.
  const Camera& camera() const { return camera_; }

 private:
  void begin(const Pose& player, const StageModel& stage);
  void approach(double seconds);
  ViewPoint flightView(const SolidMesh& mesh) const;

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
  double approach_ = 0;                    // part of the time of the way nearer, 0 … 1
  std::weak_ptr<const StageModel> stage_;  // of the last move
};

}  // namespace platon
