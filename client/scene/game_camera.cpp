#include "client/scene/game_camera.h"

#include "client/scene/camera_target.h"
#include "client/scene/view_point.h"

namespace platon {

void GameCamera::setComfort(const CameraComfort& comfort, double zoom) {
  comfort_ = comfort;
  camera_.setComfort(comfort);
  camera_.setZoom(zoom);
}

void GameCamera::move(const Pose& player, const std::shared_ptr<const StageModel>& stage, const LookInput& look,
                      double seconds) {
  if (stage_.lock() == stage) {
    camera_.lerp(player, stage->mesh, seconds);
    flight_.advance(seconds);
  } else {
    begin(player, *stage);
  }
  stage_ = stage;
  if (comfort_.reducedMotion) flight_.stop();
  look_.update(look, seconds);
  if (comfort_.instantCut && !look.held) look_.reset();
  camera_.show(look_.turned(flight_.towards(camera_.viewPoint(), stage->mesh), stage->mesh));
}

void GameCamera::begin(const Pose& player, const StageModel& stage) {
  look_.reset();
  flight_.stop();
  camera_.set(stage.mesh.pose(stage.goal.face, stage.goal.place, stage.goal.angle), stage.mesh, camera_.width(),
              camera_.height());
  if (flights_ && !comfort_.instantCut) flight_.start(camera_.viewPoint());
  camera_.set(player, stage.mesh, camera_.width(), camera_.height());
}

}  // namespace platon
