#include "client/scene/walls.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "platon/game/game.h"
#include "tests/support/sample_word.h"

namespace platon::walls_test {
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

struct ElementWalls {
  std::vector<Wall> active;
  std::vector<Wall> between;
  std::vector<Wall> open;
};

// The walls of one element on face 0, in both states.
ElementWalls wallsOfElement(const std::string& word) {
  const LevelResult result =
      loadLevel("HEXAHEDRON\n1 0 0 0\n1 60 80\n480\n%\n-120 0 120 0 " + word + "\n%\n%\n%\n%\n%\n");
  if (!result.level) throw std::logic_error("test level: " + result.diagnostics.front().message);
  const auto stage = makeStageModel(*result.level);
  const auto at = [&](double share) { return elementWallsOf(*stage, std::span(&share, 1))[0]; };
  return {at(1), at(0.5), at(0)};
}

double highest(const std::vector<Wall>& walls) {
  double height = 0;
  for (const Wall& wall : walls) height = std::max(height, wall.height);
  return height;
}

TEST(StageWalls, EverySegmentIsAWallOfTheHeight) {
  const LevelResult result = loadLevel("HEXAHEDRON\n1 0 0 0\n1 60 80\n480\n%\n-100 20 100 -40\n%\n%\n%\n%\n%\n");
  ASSERT_TRUE(result.level);
  const auto walls = wallsOf(*makeStageModel(*result.level));
  ASSERT_EQ(walls.size(), 6U);
  ASSERT_EQ(walls[0].size(), 1U);
  EXPECT_EQ(walls[0][0].a, glm::dvec2(-100, 20));
  EXPECT_EQ(walls[0][0].b, glm::dvec2(100, -40));
  EXPECT_EQ(walls[0][0].height, Wall::kHeight);
  EXPECT_TRUE(walls[1].empty());
}

TEST(StageWalls, WhatCanBlockIsAWall) {
  for (const ElementKind kind : kElementKinds) {
    bool isWall = false;
    for (std::uint8_t number = 0; number < 4; ++number)
      isWall = isWall || !wallsOfElement(sampleWord(kind, number).text()).active.empty();
    EXPECT_EQ(isWall, canBlock(kind)) << "ElementWalls::add in client/scene/walls.cpp, for '" << wordOf(kind) << "'";
  }
}

TEST(StageWalls, WhatDoesNotBlockIsLow) {
  for (const char* word : {"up 2", "door 5", "timed 9 9"}) {
    const ElementWalls walls = wallsOfElement(word);
    EXPECT_EQ(highest(walls.active), Wall::kHeight) << word;
    EXPECT_LT(highest(walls.open), Wall::kHeight / 3) << word;
  }
  for (const char* word : {"checkpoint", "key 5"}) EXPECT_TRUE(wallsOfElement(word).active.empty()) << word;
}

TEST(StageWalls, AnUpThatLetsPassIsNoWall) { EXPECT_TRUE(wallsOfElement("up 2").open.empty()); }

TEST(StageWalls, WhatOpensIsBetweenItsStatesMeanwhile) {
  for (const char* word : {"up 2", "door 5", "plate 5", "timed 9 9"}) {
    const ElementWalls walls = wallsOfElement(word);
    const auto heightOf = [](const std::vector<Wall>& all) { return all.empty() ? 0 : all.back().height; };
    EXPECT_NEAR(heightOf(walls.between), (heightOf(walls.active) + heightOf(walls.open)) / 2, 1e-9) << word;
  }
}

TEST(StageWalls, TheLeavesOfADoorMeetWhenItIsClosed) {
  const ElementWalls walls = wallsOfElement("door 5");
  ASSERT_EQ(walls.active.size(), 2U) << "a rail on each side";
  ASSERT_EQ(walls.between.size(), 4U);
  EXPECT_GT(walls.between[0].b.x, walls.open[0].b.x);
  EXPECT_LT(walls.between[0].b.x, 0) << "a gap in the middle";
  EXPECT_EQ(walls.between[0].b.x, -walls.between[1].a.x);
  EXPECT_EQ(walls.active[0].a.x, -120);
  EXPECT_EQ(walls.active[0].b.x, 120);
}

TEST(StageWalls, WhatBlocksAlwaysDoesNotSink) {
  for (const char* word : {"hazard", "plate 5"}) {
    const ElementWalls walls = wallsOfElement(word);
    EXPECT_GT(highest(walls.active), Wall::kHeight / 2) << word;
    EXPECT_GT(highest(walls.open), Wall::kHeight / 2) << word;
  }
}

TEST(StageWalls, AWallGoesOnOverAnEdgeWhereADoorBeginsButNotWhereACheckpointDoes) {
  const auto meets = [](const std::string& word) {
    const LevelResult result =
        loadLevel("HEXAHEDRON\n2 0 0 0\n2 60 80\n480\n%\n180 20 242 20\n%\n-242 20 -180 20" + word + "\n%\n%\n%\n%\n");
    if (!result.level) throw std::logic_error("test level: " + result.diagnostics.front().message);
    const auto stage = makeStageModel(*result.level);
    for (int edge = 0; edge < 4; ++edge) {
      if (edgeMeetingsOf(*stage).goesOn({{180, 20}, {242, 20}}, 0, edge)) return true;
    }
    return false;
  };
  EXPECT_TRUE(meets(""));
  EXPECT_TRUE(meets(" door 1"));
  EXPECT_FALSE(meets(" checkpoint"));
}

TEST(StageWalls, WhatLetsPassFromOneSideIsAThinLedge) {
  for (const std::vector<Wall>& walls : {wallsOfElement("oneway").active, wallsOfElement("oneway").open}) {
    ASSERT_EQ(walls.size(), 1U);
    EXPECT_LT(walls[0].height, Wall::kHeight / 2);
    EXPECT_LT(walls[0].halfWidth, StageModel::kRibbonWidth / 2);
    EXPECT_EQ(walls[0].a, glm::dvec2(-120, 0));
    EXPECT_EQ(walls[0].b, glm::dvec2(120, 0));
  }
}

TEST(StageWalls, WallsOfAnElementLieAlongItsSegment) {
  for (const char* word : {"up 2", "door 5", "hazard", "plate 5", "oneway"}) {
    for (const Wall& wall : wallsOfElement(word).active) {
      for (const glm::dvec2 end : {wall.a, wall.b}) {
        EXPECT_LE(std::abs(end.x), 120 + 1e-9) << word;
        EXPECT_LE(std::abs(end.y), 8) << word;
      }
    }
  }
}

using Walls = std::vector<std::vector<Wall>>;

Walls noWalls(const SolidMesh& solid) { return Walls(static_cast<std::size_t>(solid.faces())); }

// Some walls on every face, also over its edges and corners.
Walls someWalls(const SolidMesh& solid, int perFace) {
  std::mt19937 random(7);
  const double reach = solid.apothem() * 1.1;
  std::uniform_real_distribution<double> place(-reach, reach);
  Walls walls = noWalls(solid);
  for (std::vector<Wall>& face : walls) {
    for (int i = 0; i < perFace; ++i) face.push_back({{place(random), place(random)}, {place(random), place(random)}});
    face.push_back({{3, 4}, {3, 4}});
  }
  return walls;
}

constexpr SolidKind kKinds[] = {SolidKind::kTetrahedron, SolidKind::kHexahedron, SolidKind::kOctahedron,
                                SolidKind::kDodecahedron, SolidKind::kIcosahedron};

glm::dvec3 placeOf(const WallMesh& mesh, std::size_t corner) { return mesh.vertices[mesh.triangles[corner]].place; }

TEST(WallMesh, IsClosedButForItsUndersides) {
  const SolidMesh solid(SolidKind::kDodecahedron, 300);
  const WallMesh mesh = makeWallMesh(solid, someWalls(solid, 6));
  using Point = std::array<long, 3>;
  for (const WallMesh::Part& part : mesh.faces) {
    std::map<std::pair<Point, Point>, int> ways;  // how often each edge runs this way, less how often the other way
    const auto pointAt = [&](std::size_t corner) {
      const glm::dvec3 place = placeOf(mesh, corner) * 1000.0;
      return Point{std::lround(place.x), std::lround(place.y), std::lround(place.z)};
    };
    for (std::size_t i = part.first; i < part.first + part.count; ++i) {
      const std::size_t next = i % 3 == 2 ? i - 2 : i + 1;
      ++ways[{pointAt(i), pointAt(next)}];
      --ways[{pointAt(next), pointAt(i)}];
    }
    for (const auto& [edge, sum] : ways) {
      const bool onFace = edge.first[2] == 0 && edge.second[2] == 0;
      EXPECT_TRUE(sum == 0 || onFace);
    }
  }
}

TEST(WallMesh, TrianglesFaceOutwardsAndTopsAreAtTheHeight) {
  const SolidMesh solid(SolidKind::kTetrahedron, 400);
  Walls walls = noWalls(solid);
  walls[0] = {{{-50, 10}, {50, 30}}};
  const WallMesh mesh = makeWallMesh(solid, walls);
  const glm::dvec3 inside(0, 20, Wall::kHeight / 2);
  double highest = 0;
  ASSERT_GT(mesh.triangles.size(), 0U);
  for (std::size_t i = 0; i < mesh.triangles.size(); i += 3) {
    const glm::dvec3 a = placeOf(mesh, i);
    const glm::dvec3 normal = glm::cross(placeOf(mesh, i + 1) - a, placeOf(mesh, i + 2) - a);
    EXPECT_GT(glm::dot(normal, a - inside), 0) << i;
    const WallVertex& vertex = mesh.vertices[mesh.triangles[i]];
    const glm::dvec3 stored(vertex.normal[0], vertex.normal[1], vertex.normal[2]);
    EXPECT_GT(glm::dot(glm::normalize(normal), stored / 127.0), 0.98) << i;
    highest = std::max(highest, a.z);
  }
  EXPECT_EQ(highest, Wall::kHeight);
  for (const WallVertex& vertex : mesh.vertices) EXPECT_TRUE(vertex.place.z == 0 || vertex.place.z == 12);
}

TEST(WallMesh, StaysBetweenThePlanesThatBisectItsFaceAndTheNeighbours) {
  for (const SolidKind kind : kKinds) {
    const SolidMesh solid(kind, 300);
    const WallMesh mesh = makeWallMesh(solid, someWalls(solid, 8));
    const double lean = 1 / std::tan(solid.dihedral() / 2);
    for (const WallVertex& vertex : mesh.vertices) {
      for (const glm::dvec2 edge : solid.edgeNormals()) {
        const double beyond = glm::dot(edge, glm::dvec2(vertex.place)) - solid.apothem();
        EXPECT_LE(beyond, vertex.place.z * lean + 1e-3);
      }
    }
  }
}

TEST(WallMesh, WallsMeetOverEveryEdge) {
  for (const SolidKind kind : kKinds) {
    const SolidMesh solid(kind, 300);
    for (int edge = 0; edge < solid.solid().edgesPerFace(); ++edge) {
      const PlatonicSolid::Neighbour& next = solid.solid().neighbour(0, edge);
      const glm::dvec2 outwards = solid.edgeNormals()[static_cast<std::size_t>(edge)];
      const glm::dvec2 along(-outwards.y, outwards.x);
      const glm::dvec2 crossing = outwards * solid.apothem() + along * 20.0;
      const glm::dvec2 way = glm::normalize(outwards + 0.6 * along);  // at a slant
      const glm::dmat4 toNext = glm::inverse(solid.unfolded(0, edge));
      const auto carried = [&](glm::dvec2 point) { return glm::dvec2(toNext * glm::dvec4(point, 0, 1)); };
      Walls walls = noWalls(solid);
      walls[0] = {{crossing - 50.0 * way, crossing}};
      walls[next.face] = {{carried(crossing), carried(crossing + 50.0 * way)}};
      const WallMesh mesh = makeWallMesh(solid, walls);
      const glm::dvec3 lift = Wall::kHeight * (solid.normal(0) + solid.normal(next.face)) /
                              (1 + glm::dot(solid.normal(0), solid.normal(next.face)));
      const double half = 2 / glm::dot(way, outwards);  // half the width along the edge
      for (const int face : {0, int{next.face}}) {
        for (const double side : {-half, half}) {
          const glm::dvec3 expected = solid.toWorld(0, crossing + side * along) + lift;
          double nearest = 1e9;
          const WallMesh::Part& part = mesh.faces[static_cast<std::size_t>(face)];
          for (std::size_t i = part.first; i < part.first + part.count; ++i) {
            const glm::dvec3 place(solid.faceToWorld(face) * glm::dvec4(placeOf(mesh, i), 1));
            nearest = std::min(nearest, glm::distance(place, expected));
          }
          EXPECT_LT(nearest, 1e-3) << "solid " << static_cast<int>(kind) << " edge " << edge << " face " << face;
        }
      }
    }
  }
}

TEST(WallMesh, AWallThatDoesNotGoOnEndsUprightAtTheEdge) {
  const SolidMesh solid(SolidKind::kTetrahedron, 400);
  const glm::dvec2 outwards = solid.edgeNormals()[0];
  Walls walls = noWalls(solid);
  walls[0] = {{{0, 0}, outwards * (solid.apothem() + 2)}};
  double farthest = 0;
  for (const WallVertex& vertex : makeWallMesh(solid, walls).vertices)
    farthest = std::max(farthest, glm::dot(outwards, glm::dvec2(vertex.place)));
  EXPECT_NEAR(farthest, solid.apothem(), 1e-3);
}

TEST(WallMesh, ManyWallsHaveFewTriangles) {
  const SolidMesh solid(SolidKind::kHexahedron, 60000);
  Walls walls = noWalls(solid);
  for (int i = 0; i < 200000; ++i) {
    const double y = -29000 + 0.29 * i;
    walls[static_cast<std::size_t>(i % 6)].push_back({{-100, y}, {100, y}});
  }
  const WallMesh mesh = makeWallMesh(solid, walls);
  EXPECT_GT(mesh.triangles.size(), 0U);
  EXPECT_LE(mesh.triangles.size() / 3, kMaxTrianglesPerWall * 200000);
}

TEST(WallMesh, AWallThatOnlyTouchesTheFaceIsLeftOutButNotOneAlongAnEdge) {
  const SolidMesh solid(SolidKind::kHexahedron, 480);
  Walls walls = noWalls(solid);
  walls[2] = {{{240, 0}, {300, 50}}};
  EXPECT_TRUE(makeWallMesh(solid, walls).triangles.empty());
  walls[2] = {{{240, 0}, {240, 50}}};
  EXPECT_FALSE(makeWallMesh(solid, walls).triangles.empty());
}

TEST(WallMesh, AWallBeyondItsFaceIsLeftOut) {
  const SolidMesh solid(SolidKind::kHexahedron, 480);
  Walls walls = noWalls(solid);
  walls[2] = {{{300, 0}, {300, 50}}};
  const WallMesh mesh = makeWallMesh(solid, walls);
  EXPECT_TRUE(mesh.triangles.empty());
  EXPECT_EQ(mesh.faces.size(), 6U);
}

}  // namespace

}  // namespace platon::walls_test
