#include "client/editor/snapping.h"

#include <gtest/gtest.h>

#include <vector>

#include <glm/geometric.hpp>

namespace platon::snapping_test {
namespace {

const SolidMesh& cube() {
  static const SolidMesh mesh(SolidKind::kHexahedron, 480);
  return mesh;
}

const std::vector<EditedSegment> kSegments{{0, {3, 4}, {103, 4}, {}}, {1, {-240, 33}, {-100, 33}, {}}};

void expectSnap(glm::dvec2 pointer, glm::dvec2 place, const SnapOptions& options = {}) {
  const glm::dvec2 result = snapped(cube(), kSegments, {0, pointer}, options);
  EXPECT_LT(glm::distance(result, place), 1e-9) << result.x << " " << result.y;
}

TEST(SnappingTest, AnEndComesBeforeItsSegment) { expectSnap({5, 5}, {3, 4}); }

TEST(SnappingTest, ASegmentComesBeforeTheGrid) { expectSnap({52, 7}, {50, 4}); }

TEST(SnappingTest, ElsewhereTheGridCounts) {
  expectSnap({52, 47}, {50, 50});
  expectSnap({52, 47}, {60, 40}, {.grid = 20});
}

TEST(SnappingTest, EdgesAndCornersAttract) {
  expectSnap({52, 237}, {50, 240});
  expectSnap({238, 237}, {240, 240});
}

// The end of the segment on face 1, which touches the common edge.
TEST(SnappingTest, ASegmentOfTheNeighbourIsContinued) { expectSnap({238, 31}, {240, 33}); }

TEST(SnappingTest, FreeIsFree) { expectSnap({5.3, 5.1}, {5.3, 5.1}, {.free = true}); }

TEST(SnappingTest, NothingIsOutsideItsFace) {
  const SolidMesh mesh(SolidKind::kIcosahedron, 480);
  for (double x = -300; x < 300; x += 7) {
    for (double y = -150; y < 300; y += 7) {
      const auto inside = [&](glm::dvec2 place) {
        for (const glm::dvec2 normal : mesh.edgeNormals()) {
          if (glm::dot(normal, place) > mesh.apothem() + 1e-6) return false;
        }
        return true;
      };
      if (!inside({x, y})) continue;
      EXPECT_TRUE(inside(snapped(mesh, {}, {0, {x, y}}, {.grid = 40}))) << x << " " << y;
    }
  }
}

TEST(StraightenedTest, TheNearestDirectionIsTaken) {
  const auto straight = [](glm::dvec2 pointer) { return straightened(cube(), {10, 10}, pointer, {}); };
  EXPECT_LT(glm::distance(straight({63, 18}), {60, 10}), 1e-9);
  EXPECT_LT(glm::distance(straight({18, -63}), {10, -60}), 1e-9);
}

TEST(StraightenedTest, TheDirectionsOfTheEdgesCount) {
  const SolidMesh mesh(SolidKind::kTetrahedron, 640);
  const glm::dvec2 edge = glm::normalize(mesh.polygon()[2] - mesh.polygon()[1]);
  const glm::dvec2 place = straightened(mesh, {0, 0}, edge * 52.0 + glm::dvec2(1, 0), {});
  EXPECT_LT(glm::distance(place, edge * 50.0), 1e-9);
}

}  // namespace
}  // namespace platon::snapping_test
