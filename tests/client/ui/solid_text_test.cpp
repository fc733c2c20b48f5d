#include "client/ui/solid_text.h"

#include <gtest/gtest.h>

namespace platon::solid_text_test {
namespace {

TEST(SolidText, NamesTheSolidAndItsElement) {
  EXPECT_EQ(textOf(SolidKind::kTetrahedron), "Tetrahedron · fire");
  EXPECT_EQ(textOf(SolidKind::kHexahedron), "Cube · earth");
  EXPECT_EQ(textOf(SolidKind::kOctahedron), "Octahedron · air");
  EXPECT_EQ(textOf(SolidKind::kDodecahedron), "Dodecahedron · ether");
  EXPECT_EQ(textOf(SolidKind::kIcosahedron), "Icosahedron · water");
}

}  // namespace
}  // namespace platon::solid_text_test
