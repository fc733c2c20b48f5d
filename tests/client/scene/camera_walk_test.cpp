// Laws of the camera on walks over every edge and round every corner of the solids.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <numbers>
#include <numeric>
#include <random>
#include <span>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "client/scene/camera.h"
#include "tests/client/scene/surface_walk.h"
#include "tests/support/run/repetitions.h"

namespace platon::camera_walk_test {
namespace {

constexpr unsigned kSeed = 20261124;
constexpr double kTicksPerSecond = 60;
constexpr double kRun = 3.2;   // level units a tick
constexpr double kFall = 7.5;  // the fastest
constexpr double kPicture = 0.9;
constexpr double kMaxTilt = 3 * std::numbers::pi / 180;

double angleBetween(glm::dvec3 a, glm::dvec3 b) { return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)); }

glm::dvec2 onScreen(const Camera& camera, glm::dvec3 point) {
  const glm::dvec4 clip = camera.viewProjection() * glm::dvec4(point, 1);
  return glm::dvec2(clip.x * camera.width() / camera.height(), clip.y) / clip.w;
}

// Angle on the screen between the player's right and the horizontal.
double floorTilt(const Camera& camera, const Pose& player) {
  const glm::dvec3 right = 10.0 * glm::cross(player.up, player.normal);
  const glm::dvec2 way = onScreen(camera, player.position + right) - onScreen(camera, player.position - right);
  return std::abs(std::atan2(way.y, way.x));
}

void expectVisible(const Camera& camera, const Pose& player, const std::string& where) {
  const glm::dvec4 clip = camera.viewProjection() * glm::dvec4(player.position, 1);
  ASSERT_GT(clip.w, 0) << where;
  ASSERT_LT(std::max(std::abs(clip.x), std::abs(clip.y)) / clip.w, kPicture) << where;
  ASSERT_LT(std::abs(clip.z) / clip.w, 1) << where;
  // The solid is convex, so nothing else can hide the player.
  ASSERT_GT(glm::dot(player.normal, camera.eye() - player.position), 0) << where;
}

// The angle by which the picture has turned about the line of sight, radians counter-clockwise.
double rollBetween(const Camera& before, const Camera& after) {
  const glm::dvec3 up = rotatedBetween(before.up(), before.back(), after.back());
  return std::atan2(glm::dot(after.back(), glm::cross(up, after.up())), glm::dot(up, after.up()));
}

struct Picture {
  std::uint32_t width = 1280;
  std::uint32_t height = 720;
  double zoom = 1;
};

constexpr std::array kPictures{Picture{},
                               Picture{960, 720, 0.5},
                               Picture{960, 720, 2},
                               Picture{2560, 1080, 0.5},
                               Picture{2560, 1080, 2},
                               Picture{400, 720, 0.5},
                               Picture{400, 720, 2}};

struct Walker {
  SurfaceWalk walk;
  Picture picture;
  Camera camera;
  CameraComfort comfort;
  double framesPerSecond = 60;
  double secondsInMiddle = 0;
  double greatestSwing = 0;  // radians a second
  double rolled = 0;         // in the last frame, radians a second counter-clockwise

  void start() {
    camera.setComfort(comfort);
    camera.setZoom(picture.zoom);
    camera.set(walk.pose(), *walk.mesh, picture.width, picture.height);
  }

  // Moves by `way` each tick for a frame, and checks the laws: of a camera that stands still, that the player is seen.
  void frame(glm::dvec2 way, const std::string& where) {
    const double seconds = 1 / framesPerSecond;
    walk.step(way * (kTicksPerSecond * seconds));
    const Camera before = camera;
    camera.lerp(walk.pose(), *walk.mesh, seconds);
    expectVisible(camera, walk.pose(), where);
    if (comfort.view != CameraView::kFollow) return;
    rolled = rollBetween(before, camera) / seconds;
    ASSERT_LE(std::abs(rolled), comfort.maxRoll() + 1e-4) << where;
    greatestSwing = std::max(greatestSwing, angleBetween(before.back(), camera.back()) / seconds);
    const double zone = std::min(CameraTarget::kEdgeZone, walk.mesh->apothem() / 2);
    secondsInMiddle = walk.depth() > zone ? secondsInMiddle + seconds : 0;
    if (secondsInMiddle > (comfort.reducedMotion ? 5 : 0.8)) {
      ASSERT_LT(floorTilt(camera, walk.pose()), kMaxTilt) << where;
    }
  }
};

std::string nameOf(const SolidMesh& mesh, const Walker& walker, const std::string& what) {
  return std::string(platon::nameOf(mesh.solid().kind())) + " " + std::to_string(mesh.faceSize()) + ", " + what + ", " +
         std::to_string(walker.framesPerSecond) + " pictures a second of " + std::to_string(walker.picture.width) +
         " × " + std::to_string(walker.picture.height) + " at " + std::to_string(walker.picture.zoom) + ", view " +
         std::to_string(static_cast<int>(walker.comfort.view)) + ", seed " + std::to_string(kSeed);
}

constexpr std::array kFaceSizes{480.0, 200.0, 65536.0};

void forEverySolid(const std::function<void(const SolidMesh&)>& check) {
  for (int kind = 0; kind < kSolidKinds; ++kind) {
    for (const double size : std::span(kFaceSizes).first(hasSanitizers() ? 1 : kFaceSizes.size()))
      check(SolidMesh(static_cast<SolidKind>(kind), size));
  }
}

// Crosses every edge of face 0, at `part` of half the edge from its middle, in a straight way, and goes on.
void crossEdges(const Walker& kind, const SolidMesh& mesh, double part, double speed) {
  for (int edge = 0; edge < mesh.solid().edgesPerFace(); ++edge) {
    const glm::dvec2 out = mesh.edgeNormals()[static_cast<std::size_t>(edge)];
    for (double angle = 0.1; angle < 6; angle += 1.5) {
      Walker walker = kind;
      const glm::dvec2 along(-out.y, out.x);
      walker.walk = {&mesh, 0, out * (mesh.apothem() - 100) + along * (part * mesh.faceSize() / 2), angle};
      if (walker.walk.depth() < 0) walker.walk.place = out * (mesh.apothem() * 0.2);
      walker.start();
      const glm::dvec2 way(std::cos(angle) * out.x + std::sin(angle) * out.y,
                           -std::sin(angle) * out.x + std::cos(angle) * out.y);
      const std::string where = nameOf(mesh, walker, "edge " + std::to_string(edge));
      for (double tick = 0; tick < 300 / speed; tick += kTicksPerSecond / walker.framesPerSecond) {
        walker.frame(way * speed, where);
        if (testing::Test::HasFatalFailure()) return;
      }
    }
  }
}

TEST(CameraWalk, OverEveryEdge) {
  forEverySolid([](const SolidMesh& mesh) {
    for (const double framesPerSecond : {20.0, 60.0, 240.0}) {
      Walker walker;
      walker.framesPerSecond = framesPerSecond;
      for (const double part : {-0.95, -0.4, 0.0, 0.7}) {
        for (const double speed : {kRun, kFall}) crossEdges(walker, mesh, part, speed);
      }
    }
  });
}

// In each picture, and with a camera that stands still.
void forEveryView(const std::function<void(const Walker&)>& check) {
  for (const Picture& picture : kPictures) {
    for (const CameraView view : {CameraView::kFollow, CameraView::kFace, CameraView::kFaceFade}) {
      Walker walker;
      walker.picture = picture;
      walker.comfort.view = view;
      check(walker);
    }
  }
}

TEST(CameraWalk, OverEveryEdgeInEachPicture) {
  forEveryView([](const Walker& kind) {
    forEverySolid([&](const SolidMesh& mesh) {
      for (const double part : {-0.95, 0.4}) crossEdges(kind, mesh, part, kFall);
    });
  });
}

void roundCorners(const Walker& kind, const SolidMesh& mesh, int face, double radius) {
  for (const glm::dvec2 vertex : mesh.polygon()) {
    Walker walker = kind;
    walker.walk = {&mesh, face, vertex - glm::normalize(vertex) * radius, 0};
    walker.start();
    const std::string where = nameOf(mesh, walker, "face " + std::to_string(face));
    double direction = std::atan2(vertex.x, -vertex.y) + std::numbers::pi;  // across the way to the corner
    for (int tick = 0; tick < 240; ++tick) {
      direction += kRun / radius;
      walker.frame(kRun * glm::dvec2(std::cos(direction), std::sin(direction)), where);
      if (testing::Test::HasFatalFailure()) return;
    }
  }
}

TEST(CameraWalk, RoundEveryCorner) {
  forEverySolid([](const SolidMesh& mesh) {
    for (int face = 0; face < mesh.faces(); ++face) {
      for (const double radius : {10.0, 40.0}) roundCorners({}, mesh, face, radius);
    }
  });
}

TEST(CameraWalk, RoundACornerInEachPicture) {
  forEveryView(
      [](const Walker& kind) { forEverySolid([&](const SolidMesh& mesh) { roundCorners(kind, mesh, 0, 40); }); });
}

constexpr double kDegree = std::numbers::pi / 180;
constexpr double kSlowTurn = 20 * kDegree;  // a second; smaller humps are not noticed
constexpr double kTurnBack = 12 * kDegree;  // a second, at most: where a player starts from level floors

// What is left of a roll between two humps, in parts of the smaller one: 1 if there is one hump. `rolls` are the rolls
// of the frames in the direction of the whole roll.
double betweenHumps(const std::vector<double>& rolls) {
  std::vector<double> later(rolls.size());
  double highest = 0;
  for (std::size_t i = rolls.size(); i > 0; --i) later[i - 1] = highest = std::max(highest, rolls[i - 1]);
  double least = 1;
  highest = 0;
  for (std::size_t i = 0; i < rolls.size(); ++i) {
    highest = std::max(highest, rolls[i]);
    const double hump = std::min(highest, later[i]);
    if (hump > kSlowTurn) least = std::min(least, rolls[i] / hump);
  }
  return least;
}

void expectOneRoll(std::vector<double> rolls, const std::string& where) {
  const double whole = std::accumulate(rolls.begin(), rolls.end(), 0.0);
  for (double& roll : rolls) roll = std::copysign(roll, roll * whole);
  EXPECT_GT(betweenHumps(rolls), 0.6) << where;
  EXPECT_GT(*std::min_element(rolls.begin(), rolls.end()), -kTurnBack) << where;
}

// A corner of a face.
struct Corner {
  int face = 0;
  glm::dvec2 vertex{0};
};

// Passes a corner straight, at `radius` from it, by `way` a tick from the left or the right, and stops.
void passCorner(const SolidMesh& mesh, const Corner& corner, double radius, glm::dvec2 way, bool fromTheLeft) {
  constexpr double kBefore = 240;  // level units
  constexpr double kFrom = 150;
  const double speed = glm::length(way);
  const glm::dvec2 inwards = -glm::normalize(corner.vertex);
  const glm::dvec2 along = (fromTheLeft ? 1.0 : -1.0) * glm::dvec2(inwards.y, -inwards.x);
  Walker walker;
  walker.walk = {&mesh, corner.face, corner.vertex + inwards * radius,
                 std::atan2(along.y, along.x) - std::atan2(way.y, way.x)};
  const int ticks = static_cast<int>(kBefore / speed);
  for (int tick = 0; tick < ticks; ++tick) walker.walk.step(-way);
  walker.start();
  const std::string where =
      nameOf(mesh, walker,
             "corner at " + std::to_string(radius) + ", way " + std::to_string(way.x) + ", " + std::to_string(way.y));
  std::vector<double> rolls;
  for (int tick = 0; tick < 2 * ticks; ++tick) {
    ASSERT_NO_FATAL_FAILURE(walker.frame(way, where));
    if (std::abs(tick * speed - kBefore) < kFrom) rolls.push_back(walker.rolled);
  }
  expectOneRoll(rolls, where);
  for (int frame = 0; frame < 120; ++frame) ASSERT_NO_FATAL_FAILURE(walker.frame({0, 0}, where));
  EXPECT_LT(floorTilt(walker.camera, walker.walk.pose()), kDegree) << where;
}

// All faces and all corners of a face have their turn.
void forEveryCorner(const std::function<void(const SolidMesh&, const Corner&)>& check) {
  for (int kind = 0; kind < kSolidKinds; ++kind) {
    for (const double size : {356.0, 640.0}) {
      const SolidMesh mesh(static_cast<SolidKind>(kind), size);
      for (int face = 0; face < mesh.faces(); ++face) {
        const auto corner = static_cast<std::size_t>(face) % mesh.polygon().size();
        ASSERT_NO_FATAL_FAILURE(check(mesh, {face, mesh.polygon()[corner]}));
      }
    }
  }
}

// It rolled twice, and back between: there was a hump for each edge.
TEST(CameraWalk, OnAWayPastACornerThePictureRollsOnce) {
  forEveryCorner([](const SolidMesh& mesh, const Corner& corner) {
    for (const double radius : {10.0, 20.0, 30.0, 45.0, 60.0, 80.0}) {
      constexpr std::array kWays{glm::dvec2(kRun, 0),     glm::dvec2(0, -5.5),   glm::dvec2(-kRun, 0),
                                 glm::dvec2(kRun / 2, 0), glm::dvec2(0, -kFall), glm::dvec2(0, 3.9)};
      for (const glm::dvec2 way : std::span(kWays).first(corner.face == 0 ? kWays.size() : 2)) {
        for (const bool fromTheLeft : {false, true})
          ASSERT_NO_FATAL_FAILURE(passCorner(mesh, corner, radius, way, fromTheLeft));
      }
    }
  });
}

constexpr std::array<int, kSolidKinds> kEdgesAtCorner{3, 3, 4, 3, 5};

// Goes once round a corner over all its edges, counter-clockwise or clockwise.
void circleCorner(const SolidMesh& mesh, const Corner& corner, double radius, double angle, double direction) {
  const double corners = static_cast<double>(mesh.polygon().size());
  const double around =
      (1 - 2 / corners) * std::numbers::pi * kEdgesAtCorner[static_cast<std::size_t>(mesh.solid().kind())];
  const glm::dvec2 inwards = -glm::normalize(corner.vertex);
  Walker walker;
  walker.walk = {&mesh, corner.face, corner.vertex + inwards * radius, angle};
  walker.start();
  const double turn = direction * kRun / radius;
  const std::string where = nameOf(mesh, walker, "round a corner at " + std::to_string(radius));
  double heading = std::atan2(inwards.y, inwards.x) + direction * std::numbers::pi / 2 - angle + turn / 2;
  std::vector<double> rolls;
  for (double gone = 0; gone < around; gone += std::abs(turn), heading += turn) {
    ASSERT_NO_FATAL_FAILURE(walker.frame(kRun * glm::dvec2(std::cos(heading), std::sin(heading)), where));
    rolls.push_back(walker.rolled);
  }
  expectOneRoll(rolls, where);
}

TEST(CameraWalk, RoundACornerThePictureRollsEvenly) {
  forEveryCorner([](const SolidMesh& mesh, const Corner& corner) {
    for (const double radius : {12.0, 20.0, 30.0}) {
      for (const double angle : {0.0, 0.8, 1.6, 3.2, 4.8}) {
        for (const double direction : {-1.0, 1.0})
          ASSERT_NO_FATAL_FAILURE(circleCorner(mesh, corner, radius, angle, direction));
      }
    }
  });
}

// Runs and falls with turns at random, from a place near a corner.
void walkAtRandom(Walker walker, std::mt19937& random, double seconds) {
  std::uniform_real_distribution<double> part(0, 1);
  const SolidMesh& mesh = *walker.walk.mesh;
  const glm::dvec2 vertex = mesh.polygon()[random() % mesh.polygon().size()];
  walker.walk.face = static_cast<int>(random() % static_cast<unsigned>(mesh.faces()));
  walker.walk.place = vertex - glm::normalize(vertex) * std::min(150.0, mesh.apothem());
  walker.walk.angle = 7 * part(random);
  walker.start();
  glm::dvec2 way(0);
  const std::string where = nameOf(mesh, walker, "at random");
  for (double time = 0; time < seconds; time += 1 / walker.framesPerSecond) {
    if (part(random) * walker.framesPerSecond < 4) {
      const double direction = 7 * part(random);
      way = (part(random) < 0.3 ? kFall : kRun) * glm::dvec2(std::cos(direction), std::sin(direction));
    }
    walker.frame(way, where);
    if (testing::Test::HasFatalFailure()) return;
  }
}

TEST(CameraWalk, AtRandom) {
  std::mt19937 random(kSeed);
  forEverySolid([&](const SolidMesh& mesh) {
    for (const double framesPerSecond : {20.0, 37.0, 60.0, 240.0}) {
      for (const bool reduced : {false, true}) {
        Walker walker;
        walker.walk.mesh = &mesh;
        walker.framesPerSecond = framesPerSecond;
        walker.comfort.reducedMotion = reduced;
        walkAtRandom(walker, random, 40);
      }
    }
  });
}

TEST(CameraWalk, AtRandomInEachPicture) {
  std::mt19937 random(kSeed);
  forEveryView([&](Walker kind) {
    forEverySolid([&](const SolidMesh& mesh) {
      for (const double framesPerSecond : {20.0, 60.0}) {
        kind.walk.mesh = &mesh;
        kind.framesPerSecond = framesPerSecond;
        walkAtRandom(kind, random, 20);
      }
    });
  });
}

// It stayed about 10 degrees aslant near the edges of triangles and pentagons.
TEST(CameraWalk, WhereverTheBallRestsFloorsAreLevel) {
  constexpr double kMaxTiltAtRest = std::numbers::pi / 180;
  std::mt19937 random(kSeed);
  std::uniform_real_distribution<double> part(0, 1);
  forEverySolid([&](const SolidMesh& mesh) {
    for (int round = 0; round < repetitions(300); ++round) {
      Walker walker;
      walker.walk = {&mesh, round % mesh.faces(), {0, 0}, 6.28 * part(random)};
      walker.start();
      // Along an edge or a corner, or anywhere.
      const double direction = 6.28 * part(random);
      const glm::dvec2 way = kRun * glm::dvec2(std::cos(direction), std::sin(direction));
      const double distance = (round % 3 == 0 ? 1.2 : 0.9 + 0.2 * part(random)) * mesh.apothem() * (1 + part(random));
      const std::string where = nameOf(mesh, walker, "at rest") + ", round " + std::to_string(round);
      for (double gone = std::max(0.0, distance - 400); gone < distance; gone += kRun)
        ASSERT_NO_FATAL_FAILURE(walker.frame(way, where));
      for (int frame = 0; frame < 120; ++frame) ASSERT_NO_FATAL_FAILURE(walker.frame({0, 0}, where));
      EXPECT_LT(floorTilt(walker.camera, walker.walk.pose()), kMaxTiltAtRest)
          << where << ", " << walker.walk.depth() << " from an edge";
    }
  });
}

// A jump on a floor 60 units below the edge pitched the picture up and down by 20 degrees and more.
TEST(CameraWalk, AJumpBelowAnEdgeHardlyPitchesThePicture) {
  forEverySolid([](const SolidMesh& mesh) {
    if (mesh.faceSize() > 1000) return;
    Walker walker;
    walker.walk = {&mesh, 0, {0, 0}, 0};
    const glm::dvec2 out = mesh.edgeNormals()[0];
    walker.walk.place = (mesh.apothem() - 70) * out;
    walker.walk.angle = std::atan2(-out.x, out.y);
    walker.start();
    const glm::dvec3 before = walker.camera.back();
    const double whole = angleBetween(cameraTarget(walker.walk.pose(), mesh, 1).back(),
                                      cameraTarget(mesh.pose(0, (mesh.apothem() - 10) * out, 0), mesh, 1).back());
    double most = 0;
    double height = 0;
    double speed = 3.9;  // units a tick, and its loss: a jump of 60 units
    while (height >= 0) {
      const std::string where = nameOf(mesh, walker, "a jump");
      ASSERT_NO_FATAL_FAILURE(walker.frame({0, speed}, where));
      height += speed;
      speed -= 0.127;
      most = std::max(most, angleBetween(before, walker.camera.back()));
    }
    EXPECT_LT(most, 0.65 * whole) << nameOf(mesh, walker, "a jump");
  });
}

}  // namespace
}  // namespace platon::camera_walk_test
