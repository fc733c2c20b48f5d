#include "client/scene/camera_flight.h"

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "client/scene/camera_target.h"

namespace platon::camera_flight_test {
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

}  // namespace
}  // namespace platon::camera_flight_test
