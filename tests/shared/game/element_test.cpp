#include "platon/game/element.h"

#include <gtest/gtest.h>

#include <set>

namespace platon::element_test {
namespace {

TEST(ElementTest, EveryKindHasAWordOfItsOwn) {
  std::set<std::string_view> words;
  for (const ElementKind kind : kElementKinds) {
    EXPECT_TRUE(words.insert(wordOf(kind)).second);
    EXPECT_EQ(elementKindOf(wordOf(kind)), kind);
  }
  EXPECT_EQ(elementKindOf("wall"), std::nullopt);
  EXPECT_EQ(elementKindOf(""), std::nullopt);
  EXPECT_EQ(elementKindOf("Door"), std::nullopt);
}

TEST(ElementTest, OnlyCheckpointsAndKeysNeverBlock) {
  for (const ElementKind kind : kElementKinds)
    EXPECT_EQ(canBlock(kind), kind != ElementKind::kCheckpoint && kind != ElementKind::kKey) << wordOf(kind);
}

TEST(ElementTest, OnlyHazardsAndPlatesBlockAlways) {
  for (const ElementKind kind : kElementKinds)
    EXPECT_EQ(blocksAlways(kind), kind == ElementKind::kHazard || kind == ElementKind::kPlate) << wordOf(kind);
}

TEST(ElementTest, IsFoundByFaceAndSegment) {
  std::vector<Element> elements(4);
  elements[0].face = 0, elements[0].segment = 7;
  elements[1].face = 2, elements[1].segment = 0;
  elements[2].face = 2, elements[2].segment = 5;
  elements[3].face = 3, elements[3].segment = 1;
  for (const Element& element : elements) EXPECT_EQ(findElement(elements, element.face, element.segment), &element);
  for (std::uint32_t face = 0; face < 5; ++face) EXPECT_EQ(findElement(elements, face, 6), nullptr) << face;
  EXPECT_EQ(findElement(elements, 1, 0), nullptr);
  EXPECT_EQ(findElement({}, 0, 0), nullptr);
}

TEST(ElementTest, PlayersReturnToTheMiddleOfACheckpoint) {
  Element checkpoint;
  checkpoint.ends = {{-100, 30}, {301, 50}};
  EXPECT_EQ(placeOf(checkpoint), Point(101, 40)) << "100.5 is rounded away from zero";
}

}  // namespace
}  // namespace platon::element_test
