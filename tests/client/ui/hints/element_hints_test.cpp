#include "client/ui/hints/element_hints.h"

#include <vector>

#include <gtest/gtest.h>

#include "platon/game/game.h"

namespace platon {
namespace {

constexpr std::uint32_t kReadTicks = 480;  // 8 s

std::vector<Element> elementsOf(std::initializer_list<ElementKind> kinds) {
  std::vector<Element> elements;
  for (const ElementKind kind : kinds) elements.emplace_back().kind = kind;
  return elements;
}

PlayerState playing() {
  PlayerState player;
  player.startedAt = 1;
  return player;
}

void play(ElementHints& hints, const std::vector<Element>& elements, UntoldElements& untold, std::uint32_t ticks) {
  for (std::uint32_t tick = 0; tick < ticks; ++tick) hints.observe(playing(), elements, untold);
}

TEST(ElementHints, EachKindIsToldOnceOneAfterAnother) {
  const std::vector<Element> elements = elementsOf({ElementKind::kKey, ElementKind::kOneway, ElementKind::kKey});
  ElementHints hints;
  UntoldElements untold;
  EXPECT_EQ(hints.hint(), "");
  play(hints, elements, untold, kReadTicks);
  EXPECT_EQ(hints.hint(), "A ledge with arrows lets you pass the way they point");
  play(hints, elements, untold, kReadTicks);
  EXPECT_EQ(hints.hint(), "A key opens all doors with its number");
  play(hints, elements, untold, 1);
  EXPECT_EQ(hints.hint(), "");
  EXPECT_EQ(textOf(untold), "up,hazard,checkpoint,door,plate");
}

TEST(ElementHints, WaitsUntilTheBallIsPlayed) {
  const std::vector<Element> elements = elementsOf({ElementKind::kPlate});
  ElementHints hints;
  UntoldElements untold;
  for (std::uint32_t tick = 0; tick < 2 * kReadTicks; ++tick) hints.observe(PlayerState(), elements, untold);
  EXPECT_EQ(hints.hint(), "The doors with the number of a plate are open while somebody stands on it");
  EXPECT_EQ(untold, UntoldElements());
}

TEST(ElementHints, ALevelWithoutElementsTellsNothing) {
  ElementHints hints;
  UntoldElements untold;
  play(hints, {}, untold, kReadTicks);
  EXPECT_EQ(hints.hint(), "");
  EXPECT_EQ(untold, UntoldElements());
}

TEST(ElementHints, EveryKindButDoorsHasAHint) {
  for (const ElementKind kind : kElementKinds) {
    ElementHints hints;
    UntoldElements untold;
    play(hints, elementsOf({kind}), untold, 1);
    EXPECT_EQ(hints.hint().empty(), kind == ElementKind::kDoor) << wordOf(kind);
  }
}

TEST(UntoldElements, ParsingTheTextGivesTheSame) {
  for (std::uint8_t mask = 0; mask <= UntoldElements().mask; ++mask) {
    UntoldElements parsed;
    ASSERT_TRUE(parse(textOf({mask}), parsed)) << textOf({mask});
    EXPECT_EQ(parsed, UntoldElements{mask});
  }
  EXPECT_EQ(textOf({0}), "none");
}

TEST(UntoldElements, AnotherTextChangesNothing) {
  for (const char* text : {"", ",", "key,", ",key", "key,,up", "keys", "none,key", "key up"}) {
    UntoldElements untold{5};
    EXPECT_FALSE(parse(text, untold)) << text;
    EXPECT_EQ(untold, UntoldElements{5}) << text;
  }
}

}  // namespace
}  // namespace platon
