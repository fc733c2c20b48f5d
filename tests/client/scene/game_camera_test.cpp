#include "client/scene/game_camera.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include "client/netcode/player_snapshot.h"
#include "client/netcode/player_watch.h"
#include "client/scene/camera_target.h"
#include "client/scene/scene.h"
#include "platon/game/game.h"
#include "platon/game/level.h"
#include "tests/client/scene/surface_walk.h"

namespace platon::game_camera_test {
namespace {

ViewPoint onFace(const SolidMesh& mesh, int face, glm::dvec2 place, double angle) {
  const Pose player = mesh.pose(face, place, angle);
  const CameraTarget target = cameraTarget(player, mesh, 1);
  return {target.orientation, player.position + target.distance * target.back()};
}

class CameraFlightTest : public testing::Test {
 protected:
  CameraFlightTest() { flight_.start(from_); }

  SolidMesh mesh_{SolidKind::kIcosahedron, 480};
  ViewPoint from_ = onFace(mesh_, 13, {10, 20}, 2);
  ViewPoint to_ = onFace(mesh_, 0, {-20, 10}, 0);
  CameraFlight flight_;
};

TEST_F(CameraFlightTest, LeadsFromOneViewToTheOther) {
  EXPECT_TRUE(flight_.flying());
  EXPECT_LT(glm::distance(flight_.towards(to_, mesh_).eye, from_.eye), 1e-6);
  flight_.advance(CameraFlight::kSeconds - 0.001);
  EXPECT_TRUE(flight_.flying());
  EXPECT_LT(glm::distance(flight_.towards(to_, mesh_).eye, to_.eye), 0.1);
  flight_.advance(0.002);
  EXPECT_FALSE(flight_.flying());
  EXPECT_EQ(flight_.towards(to_, mesh_).eye, to_.eye);
}

TEST_F(CameraFlightTest, NeverJumps) {
  constexpr double kFrame = 1.0 / 60;
  ViewPoint last = from_;
  while (flight_.flying()) {
    flight_.advance(kFrame);
    const ViewPoint view = flight_.towards(to_, mesh_);
    EXPECT_LT(glm::distance(view.eye, last.eye), 100);
    EXPECT_GT(glm::dot(view.back(), last.back()), 0.995);
    last = view;
  }
}

TEST_F(CameraFlightTest, ASkippedFlightEndsSoon) {
  flight_.advance(0.5);
  const ViewPoint before = flight_.towards(to_, mesh_);
  flight_.skip();
  EXPECT_EQ(flight_.towards(to_, mesh_).eye, before.eye) << "the picture does not jump";
  flight_.advance(CameraFlight::kSkipSeconds / 2);
  flight_.skip();
  flight_.advance(CameraFlight::kSkipSeconds / 2 + 1e-9);
  EXPECT_FALSE(flight_.flying());
}

TEST_F(CameraFlightTest, SkippingTheEndDoesNotMakeItSlower) {
  flight_.advance(CameraFlight::kSeconds - 0.01);
  flight_.skip();
  flight_.advance(0.011);
  EXPECT_FALSE(flight_.flying());
}

TEST_F(CameraFlightTest, AStoppedFlightIsOver) {
  flight_.stop();
  EXPECT_FALSE(flight_.flying());
  EXPECT_EQ(flight_.towards(to_, mesh_).eye, to_.eye);
}

const ViewPoint kView{{1, 0, 0, 0}, {30, -20, 1000}};

const SolidMesh& cube() {
  static const SolidMesh mesh(SolidKind::kHexahedron, 480);
  return mesh;
}

LookInput towards(double right, double up) { return {true, {right, up}}; }

TEST(LookRound, TurnsWhileItIsHeld) {
  LookRound look;
  look.update(towards(1, 0), 0.25);
  EXPECT_NEAR(look.angles().x, LookRound::kSpeed / 4, 1e-12);
  look.update(towards(0, 0), 1);
  EXPECT_NEAR(look.angles().x, LookRound::kSpeed / 4, 1e-12) << "held without a direction, it stays";
  look.update(towards(0, -1), 0.1);
  EXPECT_NEAR(look.angles().y, -LookRound::kSpeed / 10, 1e-12);
}

TEST(LookRound, RightAndUpAreThoseOfTheScreen) {
  LookRound look;
  look.update(towards(1, 0), 0.3);
  EXPECT_GT(look.turned(kView, cube()).back().x, 0.3);
  look.reset();
  look.update(towards(0, 1), 0.3);
  EXPECT_GT(look.turned(kView, cube()).back().y, 0.3);
}

TEST(LookRound, GoesBackToTheSameView) {
  LookRound look;
  look.update(towards(1, 1), 0.5);
  double last = glm::length(look.angles());
  for (int step = 0; step < 300; ++step) {
    look.update({}, 1.0 / 60);
    const double now = glm::length(look.angles());
    EXPECT_LE(now, last);
    EXPECT_LE(last - now, LookRound::kMaxReturn / 60 + 1e-9);
    last = now;
  }
  EXPECT_LT(glm::distance(look.turned(kView, cube()).eye, kView.eye), 1e-6);
}

TEST(LookRound, TwoReturnsEqualOneOfTheSum) {
  LookRound once;
  once.update(towards(1, 0.5), 1);
  LookRound twice = once;
  once.update({}, 0.3);
  twice.update({}, 0.1);
  twice.update({}, 0.2);
  EXPECT_LT(glm::distance(once.angles(), twice.angles()), 1e-9);
}

TEST(LookRound, SeesEverySideAndReturnsTheShortWay) {
  LookRound look;
  look.update(towards(1, 0), 1.2 * std::numbers::pi / LookRound::kSpeed);
  EXPECT_NEAR(look.angles().x, -0.8 * std::numbers::pi, 1e-9);
  look.update(towards(0, 1), 100);
  EXPECT_EQ(look.angles().y, LookRound::kMaxUp);
}

TEST(LookRound, WithoutAnglesItChangesNothing) {
  const ViewPoint view = LookRound().turned(kView, cube());
  EXPECT_EQ(view.eye, kView.eye);
  EXPECT_EQ(view.orientation, kView.orientation);
}

TEST(LookRound, ATurnIsMadeAtOnceWithinTheLimits) {
  LookRound look;
  look.update({true, {}, {0.3, -0.2}}, 0);
  EXPECT_EQ(look.angles(), glm::dvec2(0.3, -0.2));
  look.update({true, {}, {0, 9}}, 0);
  EXPECT_EQ(look.angles().y, LookRound::kMaxUp);
  look.update({}, 5);
  EXPECT_LT(glm::length(look.angles()), 1e-3) << "it goes back";
}

constexpr double kFrame = 1.0 / 60;

std::shared_ptr<const StageModel> stage() {
  return makeStageModel(*loadLevel("HEXAHEDRON\n0 0 0 0\n5 60 80\n480\n%\n%\n%\n%\n%\n%\n").level);
}

class GameCameraTest : public testing::Test {
 protected:
  GameCameraTest() { camera_.resize(1280, 720); }
  void move(const LookInput& look = {}, double seconds = kFrame) { camera_.move(player_, stage_, {}, look, seconds); }

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
    camera.move(player_, stage_, {}, {}, kFrame);
    EXPECT_FALSE(camera.flying());
    EXPECT_EQ(camera.folded(), 1);
  }
}

std::shared_ptr<const StageModel> stageOf(SolidKind kind, int size) {
  std::string text = std::string(nameOf(kind)) + "\n0 0 0 0\n1 0 0\n" + std::to_string(size) + "\n";
  for (int face = 0; face < PlatonicSolid::of(kind).faces(); ++face) text += "%\n";
  return makeStageModel(*loadLevel(text).level);
}

bool seesWholeFace(const Camera& camera, const SolidMesh& mesh, int face) {
  return std::all_of(mesh.polygon().begin(), mesh.polygon().end(), [&](glm::dvec2 corner) {
    const glm::dvec4 clip = camera.viewProjection() * glm::dvec4(mesh.toWorld(face, corner), 1);
    return std::max(std::abs(clip.x), std::abs(clip.y)) <= clip.w;
  });
}

// The goal was cut off on triangles, or off the screen.
TEST(GameCamera, TheWholeFaceIsSeenUntilTheFirstInput) {
  for (int kind = 0; kind < kSolidKinds; ++kind) {
    for (const int size : {200, 480, 500}) {
      const auto stage = stageOf(static_cast<SolidKind>(kind), size);
      for (const auto& [width, height] : {std::pair(1280U, 720U), std::pair(720U, 1280U)}) {
        for (double angle = 0; angle < 6.2; angle += 0.7) {
          const glm::dvec2 place = 0.9 * stage->mesh.apothem() * glm::dvec2(std::cos(3 * angle), std::sin(3 * angle));
          const Pose player = stage->mesh.pose(0, place, angle);
          GameCamera camera;
          camera.resize(width, height);
          camera.setBegun(false);
          camera.move(player, stage, {}, {}, kFrame);
          camera.move(player, stage, {}, {}, 3);
          EXPECT_TRUE(seesWholeFace(camera.camera(), stage->mesh, 0)) << kind << " " << size << " " << angle;
          camera.setBegun(true);
          for (int frame = 0; frame < 60; ++frame) camera.move(player, stage, {}, {}, kFrame);
          Camera usual;
          usual.set(player, stage->mesh, width, height);
          EXPECT_LT(glm::distance(camera.camera().eye(), usual.eye()), 1e-6);
          camera.setBegun(false);
          camera.move(player, stage, {}, {}, kFrame);
          EXPECT_LT(glm::distance(camera.camera().eye(), usual.eye()), 1e-6) << "not again after a restart";
        }
      }
    }
  }
}

TEST_F(GameCameraTest, TheWayFromTheWholeFaceHasNoJump) {
  camera_.setBegun(false);
  move();
  camera_.setBegun(true);
  glm::dvec3 last = camera_.camera().eye();
  const double way = glm::distance(last, usual().eye);
  EXPECT_GT(way, 50);
  for (int frame = 0; frame < 60; ++frame) {
    move();
    EXPECT_LT(glm::distance(camera_.camera().eye(), last), 0.08 * way) << frame;
    last = camera_.camera().eye();
  }
  EXPECT_LT(glm::distance(last, usual().eye), 1e-6);
}

// It looked over edges that walls close.
TEST(GameCamera, DoesNotLookOverAnEdgeThatIsClosed) {
  const auto seenFrom = [](const std::string& lines, const std::vector<std::uint8_t>& active, double height) {
    const auto stage =
        makeStageModel(*loadLevel("HEXAHEDRON\n0 0 0 0\n5 60 80\n480\n%\n" + lines + "%\n%\n%\n%\n%\n").level);
    GameCamera camera;
    camera.resize(1280, 720);
    ElementStates states;
    states.active = active;
    const Pose player = stage->mesh.pose(0, {0, height}, 0);
    for (int frame = 0; frame < 120; ++frame) camera.move(player, stage, states, {}, kFrame);
    return std::acos(glm::dot(camera.camera().back(), stage->mesh.normal(0)));
  };
  const double middle = seenFrom("", {}, 0);
  const double nearby = seenFrom("", {}, 200);
  const double closed = seenFrom("-240 230 240 230\n", {}, 200);
  EXPECT_GT(nearby, middle + 0.35);
  EXPECT_LT(closed, middle + 0.25) << "only the ray from the centre leans the view";
  EXPECT_EQ(seenFrom("-240 230 240 230 door 1\n", {1}, 200), closed);
  EXPECT_EQ(seenFrom("-240 230 240 230 door 1\n", {0}, 200), nearby);
  EXPECT_EQ(seenFrom("100 230 240 230\n", {}, 200), nearby) << "beside the way";
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
    camera.move(player_, stage_, {}, {}, kFrame);
    const glm::dvec3 eye = camera.camera().eye();
    camera.setArrived(true);
    for (int frame = 0; frame < 120; ++frame) camera.move(player_, stage_, {}, {}, kFrame);
    EXPECT_LT(glm::distance(camera.camera().eye(), eye), 1e-9);
  }
}

struct Pushes {
  int count = 0;
  double most = 0;     // parts of the distance
  double longest = 0;  // seconds
};

// How the camera differs from one that is not pushed, while the player crosses an edge to and fro, and turns round
// after so many frames.
Pushes pushesOf(const std::shared_ptr<const StageModel>& stage, const CameraComfort& comfort, int frames,
                double seconds) {
  SurfaceWalk walk{&stage->mesh, 0, {0, 222}, 0};
  GameCamera pushed;
  Camera usual;
  pushed.resize(1280, 720);
  pushed.setComfort(comfort, 1);
  pushed.move(walk.pose(), stage, {}, {}, kFrame);
  usual.setComfort(comfort);
  usual.set(walk.pose(), stage->mesh, 1280, 720);
  Pushes pushes;
  double lasts = 0;
  for (int frame = 0; frame * kFrame < seconds; ++frame) {
    walk.step({0, (frame / frames % 2 == 0 ? 40.0 : -40.0) / frames});
    pushed.move(walk.pose(), stage, {}, {}, kFrame);
    usual.lerp(walk.pose(), stage->mesh, kFrame);
    const glm::dvec3 way = usual.eye() - walk.pose().position;
    const double nearer = 1 - glm::dot(pushed.camera().eye() - walk.pose().position, way) / glm::dot(way, way);
    pushes.most = std::max(pushes.most, nearer);
    pushes.count += nearer > 1e-6 && lasts == 0 ? 1 : 0;
    lasts = nearer > 1e-6 ? lasts + kFrame : 0;
    pushes.longest = std::max(pushes.longest, lasts);
  }
  return pushes;
}

TEST_F(GameCameraTest, ACrossingPushesItALittleAndBriefly) {
  const Pushes once = pushesOf(stage_, {}, 60, 1.5);
  EXPECT_EQ(once.count, 1);
  EXPECT_NEAR(once.most, CrossingPush::kNearer, 0.2 * CrossingPush::kNearer);
  EXPECT_LE(once.longest, CrossingPush::kSeconds + 1e-9);
  const Pushes many = pushesOf(stage_, {}, 4, 6);
  EXPECT_GT(many.count, 3);
  EXPECT_LE(many.count, 10);
  for (const CameraComfort& comfort :
       {CameraComfort{.reducedMotion = true}, CameraComfort{.instantCut = true},
        CameraComfort{.view = CameraView::kFace}, CameraComfort{.view = CameraView::kFaceFade}})
    EXPECT_EQ(pushesOf(stage_, comfort, 60, 1.5).most, 0);
}

TEST_F(GameCameraTest, LooksRoundAndGoesBack) {
  move();
  for (int frame = 0; frame < 60; ++frame) move({true, {1, 0}});
  EXPECT_LT(glm::dot(camera_.camera().back(), usual().back()), 0);
  EXPECT_NEAR(camera_.camera().rollOf(player_), 0, 1e-3) << "looking round does not turn the controls";
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
      camera.move(pose, stage_, {}, {}, kFrame);
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

std::string emptyLevel(SolidKind kind) {
  std::string text = std::string(nameOf(kind)) + "\n0 60 20 0\n1 0 0\n480\n";
  for (int face = 0; face < PlatonicSolid::of(kind).faces(); ++face) text += "%\n";
  return text;
}

// A ball that falls on an empty solid, as a match shows it.
struct Fall {
  explicit Fall(SolidKind kind)
      : game(loadLevel(emptyLevel(kind)).level), stage(makeStageModel(game.level())), start(focus()) {
    camera.resize(1280, 720);
    tick();
  }

  Pose focus() {
    game.advance(std::array{Input{Input::kPresent}});
    return poseOf(stage->mesh, snapshotOf(game, 0));
  }
  void tick() {
    const Pose player = focus();
    fall.observe(game.tick(), game, 0);
    show(player, fall.isLong());
  }
  void show(const Pose& player, bool isLong) {
    camera.setLongFall(isLong);
    before = shown;
    camera.move(player, stage, {}, {}, kFrame);
    shown = {camera.camera().right(), camera.camera().up(), camera.camera().back()};
  }

  // In the last frame, radians a second.
  double turned() const {
    const glm::dmat3 turn = shown * glm::transpose(before);
    return std::acos(std::clamp((turn[0][0] + turn[1][1] + turn[2][2] - 1) / 2, -1.0, 1.0)) / kFrame;
  }
  double rolled() const {
    return std::asin(glm::dot(rotatedBetween(before[0], before[2], shown[2]), shown[1])) / kFrame;
  }

  Game game;
  std::shared_ptr<const StageModel> stage;
  Pose start;
  EndlessFall fall;
  GameCamera camera;
  glm::dmat3 before{1};
  glm::dmat3 shown{1};
};

void expectWholeSolid(const Fall& fall) {
  const SolidMesh& mesh = fall.stage->mesh;
  for (int face = 0; face < mesh.faces(); ++face) {
    for (const glm::dvec2 corner : mesh.polygon()) {
      const glm::dvec4 clip = fall.camera.camera().viewProjection() * glm::dvec4(mesh.toWorld(face, corner), 1);
      EXPECT_LT(std::max(std::abs(clip.x), std::abs(clip.y)) / clip.w, 1) << mesh.faces();
    }
  }
}

// It tumbled for ever.
TEST(LongFall, TheCameraGoesAwayAndStandsStillAndSeesTheWholeSolid) {
  for (int kind = 0; kind < kSolidKinds; ++kind) {
    Fall fall(static_cast<SolidKind>(kind));
    double rolled = 0;
    int frames = 0;
    for (int left = 60; left > 0; ++frames, left -= fall.fall.isLong() ? 1 : 0) {
      fall.tick();
      rolled += std::abs(fall.rolled()) * kFrame;
      EXPECT_LT(fall.turned(), 9) << kind;
    }
    EXPECT_LT(frames * kFrame, 3) << kind;
    EXPECT_LT(rolled, 2) << "radians, less than a third of a turn";
    for (int frame = 0; frame < 300; ++frame) {
      fall.tick();
      ASSERT_LT(fall.turned(), 1e-5) << kind;
    }
    expectWholeSolid(fall);
  }
}

TEST(LongFall, WhereThePlayerLandsTheCameraComesBackCalmly) {
  for (int kind = 0; kind < kSolidKinds; ++kind) {
    for (const int frames : {180, 200, 240, 300}) {
      Fall fall(static_cast<SolidKind>(kind));
      for (int frame = 0; frame < frames; ++frame) fall.tick();
      for (int frame = 0; frame < 240; ++frame) {
        fall.show(fall.start, false);
        EXPECT_LT(fall.turned(), 4) << kind;
      }
      Camera usual;
      usual.set(fall.start, fall.stage->mesh, 1280, 720);
      EXPECT_LT(glm::distance(fall.camera.camera().eye(), usual.eye()), 1) << kind;
    }
  }
}

TEST(LongFall, InstantCutAndTheCameraOfAFaceGoThereAndBackAtOnce) {
  const auto stage = makeStageModel(*loadLevel(emptyLevel(SolidKind::kHexahedron)).level);
  for (const CameraComfort& comfort : {CameraComfort{.instantCut = true}, CameraComfort{.view = CameraView::kFace}}) {
    GameCamera camera;
    camera.resize(1280, 720);
    camera.setComfort(comfort, 1);
    const auto eyeAt = [&](bool falls) {
      camera.setLongFall(falls);
      camera.move(stage->mesh.pose(0, {60, 20}, 0), stage, {}, {}, kFrame);
      return camera.camera().eye();
    };
    const glm::dvec3 near = eyeAt(false);
    EXPECT_GT(glm::length(eyeAt(true)), 1.05 * glm::length(near));
    EXPECT_EQ(eyeAt(false), near);
  }
}

}  // namespace

}  // namespace platon::game_camera_test
