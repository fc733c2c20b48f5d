#include "client/scene/look/edge_meetings.h"

#include <gtest/gtest.h>

namespace platon::edge_meetings_test {
namespace {

const SolidMesh& cube() {
  static const SolidMesh solid(SolidKind::kHexahedron, 480);
  return solid;
}

// The walls of the cube: `here` on face 0, at its edge 0, and `there` on the neighbour; both in the frame of face 0.
std::vector<std::vector<Wall>> wallsOf(const Wall& here, const Wall& there) {
  const glm::dmat4 toNext = glm::inverse(cube().unfolded(0, 0));
  const auto carried = [&](glm::dvec2 point) { return glm::dvec2(toNext * glm::dvec4(point, 0, 1)); };
  std::vector<std::vector<Wall>> walls(6);
  walls[0] = {here};
  walls[cube().solid().neighbour(0, 0).face] = {{carried(there.a), carried(there.b)}};
  return walls;
}

TEST(EdgeMeetings, AWallGoesOnWhereOneOfTheNeighbourBegins) {
  const Wall wall{{70, -200}, {70, -242}};
  EXPECT_TRUE(EdgeMeetings(cube(), wallsOf(wall, {{70, -238}, {70, -300}})).goesOn(wall, 0, 0));
  EXPECT_FALSE(EdgeMeetings(cube(), wallsOf(wall, {{90, -238}, {90, -300}})).goesOn(wall, 0, 0)) << "elsewhere";
  EXPECT_FALSE(EdgeMeetings(cube(), wallsOf(wall, {{70, -250}, {70, -300}})).goesOn(wall, 0, 0)) << "not at the edge";
}

TEST(EdgeMeetings, AWallThatOnlySticksOutDoesNotGoOn) {
  const Wall wall{{70, -200}, {70, -242}};
  EXPECT_FALSE(EdgeMeetings(cube(), wallsOf(wall, wall)).goesOn(wall, 0, 0));
}

TEST(EdgeMeetings, AWallAlongTheEdgeIsMetByAllThatEndsThere) {
  const Wall wall{{70, -200}, {70, -242}};
  EXPECT_TRUE(EdgeMeetings(cube(), wallsOf(wall, {{-100, -240}, {100, -240}})).goesOn(wall, 0, 0));
  EXPECT_FALSE(EdgeMeetings(cube(), wallsOf(wall, {{-100, -240}, {50, -240}})).goesOn(wall, 0, 0));
}

}  // namespace
}  // namespace platon::edge_meetings_test
