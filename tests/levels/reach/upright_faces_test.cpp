#include "levels/reach/upright_faces.h"

#include <gtest/gtest.h>

#include "tests/shared/game/played_game.h"

namespace platon::upright_faces_test {
namespace {

std::shared_ptr<const Level> emptyLevel(SolidKind kind, int degrees) {
  const int faces = PlatonicSolid::of(kind).faces();
  std::string text = std::string(nameOf(kind)) + "\n0 0 0 " + std::to_string(degrees) + "\n1 0 0\n300\n";
  for (int face = 0; face < faces; ++face) text += "%\n";
  return levelOf(text);
}

TEST(UprightFacesTest, HasEveryFaceWithEveryUp) {
  // Walks round the corners of the solid turn up by 180, 90, 120, 36 and 60 degrees; an odd number of edges also turns
  // the face.
  const std::size_t expected[] = {4 * 6, 6 * 4, 8 * 3, 12 * 10, 20 * 6};
  for (int kind = 0; kind < kSolidKinds; ++kind) {
    const UprightFaces faces(*emptyLevel(static_cast<SolidKind>(kind), 17));
    EXPECT_EQ(faces.all().size() % static_cast<std::size_t>(PlatonicSolid::of(static_cast<SolidKind>(kind)).faces()),
              0u);
    EXPECT_LE(faces.all().size(), expected[kind]) << kind;
    EXPECT_EQ(faces.find(0, Angle::degrees(17)), 0u);
    EXPECT_EQ(faces.find(0, Angle::degrees(18)), faces.all().size());
  }
}

// An edge has the same ends in both frames, and the way back leads back.
TEST(UprightFacesTest, NeighboursDifferByAShift) {
  for (int kind = 0; kind < kSolidKinds; ++kind) {
    const UprightFaces faces(*emptyLevel(static_cast<SolidKind>(kind), 40));
    for (std::uint32_t node = 0; node < faces.all().size(); ++node) {
      const UprightFace& face = faces.all()[node];
      for (std::size_t edge = 0; edge < face.polygon.size(); ++edge) {
        const auto& next = face.neighbours[edge];
        const UprightFace& behind = faces.all()[next.node];
        int shared = 0;
        for (const Vec corner : {face.polygon[edge], face.polygon[(edge + 1) % face.polygon.size()]}) {
          for (const Vec other : behind.polygon) shared += length(corner + next.shift - other) < 0.01 ? 1 : 0;
        }
        EXPECT_EQ(shared, 2);
        bool leadsBack = false;
        for (const auto& back : behind.neighbours)
          leadsBack = leadsBack || (back.node == node && length(back.shift + next.shift) < 0.01);
        EXPECT_TRUE(leadsBack);
      }
    }
  }
}

}  // namespace
}  // namespace platon::upright_faces_test
