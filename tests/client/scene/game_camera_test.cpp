#include "client/scene/game_camera.h"

#include <algorithm>
#include <memory>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "platon/game/level.h"

namespace platon::game_camera_test {
namespace {

constexpr double kFrame = 1.0 / 60;

std::shared_ptr<const StageModel> stage() {
  return makeStageModel(*loadLevel("HEXAHEDRON\n0 0 0 0\n5 60 80\n480\n%\n%\n%\n%\n%\n%\n").level);
}

class GameCameraTest : public testing::Test {
 protected:
  GameCameraTest() { camera_.resize(1280, 720); }
  void move(const LookInput& look = {}, double seconds = kFrame) { camera_.move(player_, stage_, look, seconds); }

  // The view without a flight.
  ViewPoint usual() const {
    Camera camera;
    camera.set(player_, stage_->mesh, 1280, 720);
    return camera.viewPoint();
  }

  std::shared_ptr<const StageModel> stage_ = stage();
  Pose player_ = stage_->mesh.pose(0, {20, -30}, 0);
  GameCamera camera_;
};

TEST_F(GameCameraTest, WithoutFlightsANewStageBeginsAtThePlayer) {
  move();
  EXPECT_FALSE(camera_.flying());
  EXPECT_EQ(camera_.camera().eye(), usual().eye);
}

TEST_F(GameCameraTest, ANewStageBeginsWithAFlightFromItsGoal) {
  camera_.setFlights(true);
  move();
  ASSERT_TRUE(camera_.flying());
  const Marker& goal = stage_->goal;
  EXPECT_NEAR(glm::dot(camera_.camera().back(), stage_->mesh.normal(goal.face)), 1, 0.01);
  for (int frame = 0; frame < 151; ++frame) move();
  EXPECT_FALSE(camera_.flying());
  EXPECT_LT(glm::distance(camera_.camera().eye(), usual().eye), 1e-6);
  stage_ = stage();
  move();
  EXPECT_TRUE(camera_.flying()) << "on the next stage";
}

TEST_F(GameCameraTest, OnAFlightTheSolidIsFoldedFromItsNet) {
  EXPECT_EQ(camera_.folded(), 1);
  camera_.setFlights(true);
  move();
  EXPECT_EQ(camera_.folded(), 0);
  double last = 0;
  for (int frame = 0; frame < 105; ++frame) {
    move();
    EXPECT_GE(camera_.folded(), last);
    last = camera_.folded();
  }
  EXPECT_TRUE(camera_.flying());
  EXPECT_EQ(last, 1) << "before the picture has reached the player";
}

TEST_F(GameCameraTest, AReturnToTheStartFoldsNothing) {
  camera_.setFlights(true);
  move();
  for (int frame = 0; frame < 160; ++frame) move();
  player_ = stage_->mesh.pose(2, {0, 0}, 0);
  move();
  EXPECT_EQ(camera_.folded(), 1);
}

TEST_F(GameCameraTest, TheFlightHasNoJump) {
  camera_.setFlights(true);
  move();
  glm::dvec3 last = camera_.camera().eye();
  double fastest = 0;
  for (int frame = 0; frame < 160; ++frame) {
    move();
    fastest = std::max(fastest, glm::distance(camera_.camera().eye(), last));
    last = camera_.camera().eye();
  }
  EXPECT_LT(fastest, 200) << "level units in a picture";
}

TEST_F(GameCameraTest, AFlightCanBeSkipped) {
  camera_.setFlights(true);
  move();
  camera_.skipFlight();
  for (int frame = 0; frame < 16; ++frame) move();
  EXPECT_FALSE(camera_.flying());
  EXPECT_EQ(camera_.folded(), 1);
}

TEST_F(GameCameraTest, ReducedMotionAndInstantCutHaveNoFlight) {
  for (const bool reduced : {false, true}) {
    GameCamera camera;
    camera.setComfort({.instantCut = !reduced, .reducedMotion = reduced}, 1);
    camera.setFlights(true);
    camera.move(player_, stage_, {}, kFrame);
    EXPECT_FALSE(camera.flying());
    EXPECT_EQ(camera.folded(), 1);
  }
}

TEST_F(GameCameraTest, AtAFinishItComesSlowlyNearerByATenth) {
  move();
  const glm::dvec3 far = usual().eye - player_.position;
  const auto nearness = [&] {
    return 1 - glm::dot(camera_.camera().eye() - player_.position, far) / glm::dot(far, far);
  };
  camera_.setArrived(true);
  for (int frame = 0; frame < 9; ++frame) move();
  EXPECT_LT(nearness(), 0.001) << "the way begins slowly";
  for (int frame = 9; frame < 45; ++frame) move();
  EXPECT_NEAR(nearness(), 0.05, 1e-9);
  for (int frame = 45; frame < 180; ++frame) move();
  EXPECT_NEAR(nearness(), 0.1, 1e-9) << "there it stays";
  EXPECT_NEAR(glm::dot(camera_.camera().back(), usual().back()), 1, 1e-9);
  camera_.setArrived(false);
  for (int frame = 0; frame < 18; ++frame) move();
  EXPECT_NEAR(nearness(), 0, 1e-9) << "in the next attempt";
}

TEST_F(GameCameraTest, ReducedMotionInstantCutAndTheCameraOfAFaceComeNoNearer) {
  for (const CameraComfort& comfort :
       {CameraComfort{.reducedMotion = true}, CameraComfort{.instantCut = true},
        CameraComfort{.view = CameraView::kFace}, CameraComfort{.view = CameraView::kFaceFade}}) {
    GameCamera camera;
    camera.resize(1280, 720);
    camera.setComfort(comfort, 1);
    camera.move(player_, stage_, {}, kFrame);
    const glm::dvec3 eye = camera.camera().eye();
    camera.setArrived(true);
    for (int frame = 0; frame < 120; ++frame) camera.move(player_, stage_, {}, kFrame);
    EXPECT_LT(glm::distance(camera.camera().eye(), eye), 1e-9);
  }
}

TEST_F(GameCameraTest, LooksRoundAndGoesBack) {
  move();
  for (int frame = 0; frame < 60; ++frame) move({true, {1, 0}});
  EXPECT_LT(glm::dot(camera_.camera().back(), usual().back()), 0);
  EXPECT_NEAR(camera_.camera().rollOf(player_), 0, 1e-6) << "looking round does not turn the controls";
  for (int frame = 0; frame < 300; ++frame) move();
  EXPECT_LT(glm::distance(camera_.camera().eye(), usual().eye), 1e-3);
}

TEST_F(GameCameraTest, WithInstantCutTheViewIsBackAtOnce) {
  camera_.setComfort({.instantCut = true}, 1);
  move();
  for (int frame = 0; frame < 60; ++frame) move({true, {0, 1}});
  move();
  EXPECT_EQ(camera_.camera().eye(), usual().eye);
}

TEST_F(GameCameraTest, TheCameraOfAFaceStandsStill) {
  camera_.setComfort({.view = CameraView::kFace}, 1);
  move();
  const glm::dvec3 eye = camera_.camera().eye();
  player_ = stage_->mesh.pose(0, {-200, 100}, 0);
  move();
  EXPECT_EQ(camera_.camera().eye(), eye);
  player_ = stage_->mesh.pose(1, {-200, 100}, 0);
  move();
  EXPECT_NEAR(glm::dot(camera_.camera().back(), player_.normal), 1, 1e-9);
}

TEST_F(GameCameraTest, OnlyTheCameraThatFadesHasFadingCutsAndOnlyAtAnotherView) {
  for (const CameraView view : {CameraView::kFollow, CameraView::kFace, CameraView::kFaceFade}) {
    GameCamera camera;
    camera.resize(1280, 720);
    camera.setComfort({.reducedMotion = true, .view = view}, 1);
    const auto cutsAt = [&](const Pose& pose) {
      camera.move(pose, stage_, {}, kFrame);
      return camera.takeFadingCut();
    };
    EXPECT_FALSE(cutsAt(stage_->mesh.pose(0, {0, 0}, 0))) << "the first view";
    EXPECT_FALSE(cutsAt(stage_->mesh.pose(0, {100, 0}, 0)));
    EXPECT_EQ(cutsAt(stage_->mesh.pose(1, {100, 0}, 0)), view == CameraView::kFaceFade);
    EXPECT_FALSE(camera.takeFadingCut()) << "it was taken";
    camera.setComfort({.reducedMotion = true, .view = view}, 1.5);
    EXPECT_FALSE(cutsAt(stage_->mesh.pose(1, {100, 0}, 0))) << "the zoom changes without a fade";
  }
}

}  // namespace
}  // namespace platon::game_camera_test
