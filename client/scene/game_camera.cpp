#include "client/scene/game_camera.h"

#include <algorithm>

#include <glm/common.hpp>

#include "client/scene/camera_ease.h"

namespace platon {
namespace {

// Parts of the time of a flight.
constexpr double kFlat = 0.1;    // until which the unfolding lies flat
constexpr double kFolded = 0.7;  // from which the solid is complete

}  // namespace

void GameCamera::setComfort(const CameraComfort& comfort, double zoom) {
  comfort_ = comfort;
  camera_.setComfort(comfort);
  camera_.setZoom(zoom);
  zooming_ = zooming_ || zoom != zoom_;
  zoom_ = zoom;
}

void GameCamera::move(const Pose& player, const std::shared_ptr<const StageModel>& stage, const LookInput& look,
                      double seconds) {
  if (stage_.lock() == stage) {
    const glm::dvec3 before = camera_.viewPoint().eye;
    const glm::dquat turned = camera_.viewPoint().orientation;
    camera_.lerp(player, stage->mesh, seconds);
    const bool cut = camera_.viewPoint().eye != before || camera_.viewPoint().orientation != turned;
    fadingCut_ = cut && comfort_.view == CameraView::kFaceFade && !zooming_ && !flying();
    flight_.advance(seconds);
    approach(seconds);
  } else {
    begin(player, *stage);
  }
  stage_ = stage;
  zooming_ = false;
  if (comfort_.reducedMotion) flight_.stop();
  look_.update(look, seconds);
  if (comfort_.instantCut && !look.held) look_.reset();
  camera_.setReach(flying() ? unfolding_.reach : 0);
  ViewPoint view = flightView(stage->mesh);
  view.eye += kNearer * smootherstep(approach_) * (player.position - view.eye);
  camera_.show(look_.turned(view, stage->mesh));
}

void GameCamera::approach(double seconds) {
  if (comfort_.reducedMotion || comfort_.instantCut || comfort_.view != CameraView::kFollow) {
    approach_ = 0;
    return;
  }
  approach_ += arrived_ ? seconds / kApproachSeconds : -seconds / kWithdrawalSeconds;
  approach_ = std::clamp(approach_, 0.0, 1.0);
}

double GameCamera::folded() const {
  if (!flying()) return 1;
  return smootherstep(std::clamp((flight_.progress() - kFlat) / (kFolded - kFlat), 0.0, 1.0));
}

// The flight begins where the whole unfolding is seen.
ViewPoint GameCamera::flightView(const SolidMesh& mesh) const {
  ViewPoint view = flight_.towards(camera_.viewPoint(), mesh);
  if (!flying()) return view;
  const double part = glm::smoothstep(kFlat / 2, kFolded, flight_.progress());
  view.eye = view.orientation * glm::mix(unfolding_.view.fromCentre(), view.fromCentre(), part);
  return view;
}

void GameCamera::begin(const Pose& player, const StageModel& stage) {
  look_.reset();
  fadingCut_ = false;
  flight_.stop();
  approach_ = 0;
  const Pose goal = stage.mesh.pose(stage.goal.face, stage.goal.place, stage.goal.angle);
  camera_.set(goal, stage.mesh, camera_.width(), camera_.height());
  if (flights_ && !comfort_.instantCut) {
    flight_.start(camera_.viewPoint());
    unfolding_ = viewOfUnfolding(stage.mesh, goal, double{1} * camera_.width() / camera_.height());
  }
  camera_.set(player, stage.mesh, camera_.width(), camera_.height());
}

}  // namespace platon
