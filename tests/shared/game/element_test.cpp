#include "platon/game/element.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <utility>

#include "platon/game/game.h"
#include "tests/support/files.h"
#include "tests/support/sample_word.h"

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

// A program without the word cannot play a level with it, so the two must not meet.
TEST(ElementTest, ANewWordRaisesTheRules) {
  const std::map<std::uint32_t, std::string> wordsOfRules{{7, "oneway up hazard checkpoint key door plate "},
                                                          {8, "oneway up hazard checkpoint key door plate timed "}};
  std::string words;
  for (const ElementKind kind : kElementKinds) words += std::string(wordOf(kind)) + " ";
  ASSERT_TRUE(wordsOfRules.contains(kRulesVersion)) << "add the words of rules " << kRulesVersion << ": " << words;
  EXPECT_EQ(words, wordsOfRules.at(kRulesVersion)) << "raise kRulesVersion, as docs/architecture.md says";
}

TEST(ElementTest, TheDocsDescribeEveryWord) {
  const std::string format = readText("docs/level_format.md");
  const std::string playing = readText("docs/playing.md");
  std::size_t last = 0;
  for (const ElementKind kind : kElementKinds) {
    constexpr std::array<const char*, 3> kNumbers{"", " K", " A B"};
    const std::string row = "\n| `" + std::string(wordOf(kind)) + kNumbers.at(numbersOf(kind)) + "` | ";
    const std::size_t drawn = format.find(row);
    ASSERT_NE(drawn, std::string::npos) << wordOf(kind) << " in the pictures of level_format.md";
    const std::size_t described = format.find(row, drawn + 1);
    ASSERT_NE(described, std::string::npos) << wordOf(kind) << " in the elements of level_format.md";
    EXPECT_LT(std::exchange(last, described), described) << "the editor goes through the words in this order";
    EXPECT_NE(playing.find(row), std::string::npos) << wordOf(kind) << " in the elements of playing.md";
  }
}

TEST(ElementTest, TheDocsTellTheRangeOfEveryNumber) {
  const std::string format = readText("docs/level_format.md");
  for (const ElementKind kind : kElementKinds) {
    if (numbersOf(kind) == 0) continue;
    std::size_t row = format.find("\n| number after `");
    const auto names = [&] {
      return format.substr(row, format.find("` | ", row) - row + 1).find("`" + std::string(wordOf(kind)) + "`");
    };
    while (row != std::string::npos && names() == std::string::npos) row = format.find("\n| number after `", row + 1);
    ASSERT_NE(row, std::string::npos) << "add a row for the number after '" << wordOf(kind)
                                      << "' to docs/level_format.md";
    const NumberRange range = rangeOf(kind, 3);
    const bool isFixed = range.last == rangeOf(kind, 5).last;
    const std::string last = isFixed ? std::to_string(range.last) : "number of edges of a face − 1";
    EXPECT_EQ(format.find("` | " + std::to_string(range.first) + " … " + last + " |", row), format.find("` | ", row))
        << wordOf(kind);
  }
}

TEST(ElementTest, ANeedIsAKeyAPlateOrACheckpoint) {
  EXPECT_EQ(needOf("key 0"), (ElementWord{ElementKind::kKey, 0}));
  EXPECT_EQ(needOf("plate 31"), (ElementWord{ElementKind::kPlate, 31}));
  EXPECT_EQ(needOf("checkpoint"), (ElementWord{ElementKind::kCheckpoint, 0}));
  for (const char* text : {"key 1", "key  1", "key\t1", "key \t 01"})
    EXPECT_EQ(needOf(text), (ElementWord{ElementKind::kKey, 1})) << text;
  for (const char* text : {"", "key", "key ", "key 32", "key -0", "key 1.0", "key 1 ", "Key 1", "keys 1",
                           "checkpoint 1", "checkpoint ", "door 1", "up 1", "hazard", "key 1, key 2", "timed 1 1"})
    EXPECT_EQ(needOf(text), std::nullopt) << text;
  for (const char* text : {"key 7", "plate 31", "checkpoint"}) EXPECT_EQ(needOf(text)->text(), text);
}

TEST(ElementTest, AWordIsOfElementsOfItsKindAndNumber) {
  Element element;
  element.kind = ElementKind::kKey;
  element.number = 3;
  EXPECT_TRUE((ElementWord{ElementKind::kKey, 3}.isOf(element)));
  EXPECT_FALSE((ElementWord{ElementKind::kKey, 2}.isOf(element)));
  EXPECT_FALSE((ElementWord{ElementKind::kPlate, 3}.isOf(element)));
  const Element timed{.kind = ElementKind::kTimed, .number = 3, .openTicks = 2};
  EXPECT_TRUE((ElementWord{ElementKind::kTimed, 3, 2}.isOf(timed)));
  EXPECT_FALSE((ElementWord{ElementKind::kTimed, 3, 4}.isOf(timed)));
}

TEST(ElementTest, ATimedSegmentIsSolidFirstAndThenOpen) {
  const Element timed{.kind = ElementKind::kTimed, .number = 3, .openTicks = 2};
  const auto expect = [&](std::uint32_t tick, bool isOpen, std::uint32_t left, std::uint32_t ticks) {
    const TimedPhase phase = phaseOf(timed, tick);
    EXPECT_EQ(phase.isOpen, isOpen) << tick;
    EXPECT_EQ(phase.ticksLeft, left) << tick;
    EXPECT_EQ(phase.ticks, ticks) << tick;
    EXPECT_EQ((OpenElements{0, tick}.has(timed)), isOpen) << tick;
  };
  // The last one ends where the clock does.
  for (const std::uint32_t turn : {0U, 5U, 858'993'458U * 5}) {
    expect(turn, false, 3, 3);
    expect(turn + 1, false, 2, 3);
    expect(turn + 2, false, 1, 3);
    expect(turn + 3, true, 2, 2);
    expect(turn + 4, true, 1, 2);
  }
}

TEST(ElementTest, OnlyDoorsAndTimedSegmentsOpen) {
  for (const ElementKind kind : kElementKinds) {
    bool opens = false;
    for (std::uint32_t tick = 0; tick < 40; ++tick) {
      const ElementWord word = sampleWord(kind);
      opens = opens || OpenElements{~0U, tick}.has({.kind = kind, .number = word.number, .openTicks = word.openTicks});
    }
    EXPECT_EQ(opens, kind == ElementKind::kDoor || kind == ElementKind::kTimed) << wordOf(kind);
  }
}

TEST(ElementTest, OnlyCheckpointsAndKeysNeverBlock) {
  for (const ElementKind kind : kElementKinds)
    EXPECT_EQ(canBlock(kind), kind != ElementKind::kCheckpoint && kind != ElementKind::kKey) << wordOf(kind);
}

TEST(ElementTest, OnlyHazardsAndPlatesBlockAlways) {
  for (const ElementKind kind : kElementKinds)
    EXPECT_EQ(blocksAlways(kind), kind == ElementKind::kHazard || kind == ElementKind::kPlate) << wordOf(kind);
}

TEST(ElementTest, KeysAndPlatesOpenDoorsAndKeysForTheRestOfTheRound) {
  for (const ElementKind kind : kElementKinds) {
    EXPECT_EQ(opensDoors(kind), kind == ElementKind::kKey || kind == ElementKind::kPlate) << wordOf(kind);
    EXPECT_EQ(unlocksDoors(kind), kind == ElementKind::kKey) << wordOf(kind);
    EXPECT_EQ(isDoor(kind), kind == ElementKind::kDoor) << wordOf(kind);
    EXPECT_EQ(isCheckpoint(kind), kind == ElementKind::kCheckpoint) << wordOf(kind);
  }
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
