#include "client/ui/hints/element_hints.h"

#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "platon/game/game.h"

namespace platon::element_hints_test {
namespace {

constexpr std::uint32_t kReadTicks = 240;  // 4 s
constexpr std::uint32_t kTurnTicks = 480;  // 8 s
constexpr const char* kOneway = "A ledge with arrows lets you pass the way they point";
constexpr const char* kKey = "A key opens all doors with its number";

// Each on the face of its index in the list.
std::vector<Element> elementsOf(std::initializer_list<ElementKind> kinds) {
  std::vector<Element> elements;
  for (const ElementKind kind : kinds) {
    Element& element = elements.emplace_back();
    element.kind = kind;
    element.face = static_cast<std::uint32_t>(elements.size() - 1);
    element.ends = {{-kPlayerRadius, 0}, {kPlayerRadius, 0}};
  }
  return elements;
}

PlayerState playing() {
  PlayerState player;
  player.startedAt = 1;
  return player;
}

EntityState ballOn(std::uint32_t face, std::int32_t height = 0) {
  EntityState ball;
  ball.part = face;
  ball.position = {0, height};
  return ball;
}

void play(ElementHints& hints, const std::vector<Element>& elements, UntoldElements& untold, std::uint32_t ticks,
          const EntityState& ball = ballOn(0), bool shown = true) {
  for (std::uint32_t tick = 0; tick < ticks; ++tick) hints.observe(playing(), ball, elements, shown, untold);
}

TEST(ElementHints, EachKindIsToldOneAfterAnother) {
  const std::vector<Element> elements = elementsOf({ElementKind::kKey, ElementKind::kOneway, ElementKind::kKey});
  ElementHints hints;
  UntoldElements untold;
  EXPECT_EQ(hints.hint(), "");
  play(hints, elements, untold, kReadTicks, ballOn(1));
  EXPECT_EQ(hints.hint(), kOneway);
  play(hints, elements, untold, kReadTicks, ballOn(2));
  EXPECT_EQ(hints.hint(), kKey);
  play(hints, elements, untold, 1);
  EXPECT_EQ(hints.hint(), "");
  EXPECT_EQ(textOf(untold), "up,hazard,checkpoint,door,plate,timed");
}

TEST(ElementHints, AKindIsOpenUntilTheBallHasMetOne) {
  const std::vector<Element> elements = elementsOf({ElementKind::kKey});
  ElementHints hints;
  UntoldElements untold;
  play(hints, elements, untold, kTurnTicks, ballOn(1));
  EXPECT_EQ(hints.hint(), kKey);
  play(hints, elements, untold, kTurnTicks, ballOn(0, 2 * kPlayerRadius));
  EXPECT_EQ(hints.hint(), "") << "told once, and passed at a distance";
  hints.observe(PlayerState(), ballOn(1), elements, true, untold);  // a restart
  EXPECT_EQ(hints.hint(), "");
  EXPECT_EQ(untold, UntoldElements());
  play(hints, elements, untold, 1, ballOn(0, 2 * kPlayerRadius - 1));
  EXPECT_EQ(hints.hint(), kKey) << "again, at the deed";
  EXPECT_TRUE(hints.isDue());
  play(hints, elements, untold, kReadTicks, ballOn(1));
  EXPECT_EQ(hints.hint(), "");
  EXPECT_EQ(textOf(untold), "oneway,up,hazard,checkpoint,door,plate,timed");
}

TEST(ElementHints, KindsThatTheBallHasNotMetAreToldOnceEach) {
  const std::vector<Element> elements = elementsOf({ElementKind::kKey, ElementKind::kOneway});
  ElementHints hints;
  UntoldElements untold;
  for (const char* text : {kOneway, kKey, "", ""}) {
    play(hints, elements, untold, kTurnTicks, ballOn(3));
    EXPECT_EQ(hints.hint(), text);
  }
  EXPECT_EQ(untold, UntoldElements());
}

TEST(ElementHints, TheKindThatTheBallMeetsIsToldAtOnce) {
  const std::vector<Element> elements = elementsOf({ElementKind::kKey, ElementKind::kOneway, ElementKind::kPlate});
  ElementHints hints;
  UntoldElements untold;
  play(hints, elements, untold, 60, ballOn(3));
  EXPECT_EQ(hints.hint(), kOneway);
  EXPECT_FALSE(hints.isDue());
  play(hints, elements, untold, 2, ballOn(0));
  EXPECT_EQ(hints.hint(), kKey);
  EXPECT_TRUE(hints.isDue());
  play(hints, elements, untold, 60, ballOn(1));
  EXPECT_EQ(hints.hint(), kKey) << "to be read to its end";
  play(hints, elements, untold, kReadTicks, ballOn(3));
  EXPECT_EQ(hints.hint(), kOneway) << "met meanwhile";
  EXPECT_TRUE(hints.isDue());
}

TEST(ElementHints, AHintThatIsNotShownIsNotRead) {
  const std::vector<Element> elements = elementsOf({ElementKind::kKey});
  ElementHints hints;
  UntoldElements untold;
  play(hints, elements, untold, 10 * kReadTicks, ballOn(0), false);
  EXPECT_EQ(untold, UntoldElements());
  play(hints, elements, untold, kReadTicks);
  EXPECT_NE(untold, UntoldElements());
}

TEST(ElementHints, WaitsUntilTheBallIsPlayed) {
  const std::vector<Element> elements = elementsOf({ElementKind::kPlate});
  ElementHints hints;
  UntoldElements untold;
  for (std::uint32_t tick = 0; tick < 2 * kTurnTicks; ++tick)
    hints.observe(PlayerState(), ballOn(0), elements, true, untold);
  EXPECT_EQ(hints.hint(), "While somebody stands on a plate, the doors with its number are open");
  EXPECT_EQ(untold, UntoldElements());
}

TEST(ElementHints, ALevelWithoutElementsTellsNothing) {
  ElementHints hints;
  UntoldElements untold;
  play(hints, {}, untold, kReadTicks);
  EXPECT_EQ(hints.hint(), "");
  EXPECT_EQ(untold, UntoldElements());
}

// The edge at the top of a face on the screen of a player with this up; of two, the left one.
int topEdge(Angle up, int edges) {
  const auto heightOf = [&](int edge) {
    const double turn = 2 * std::numbers::pi * (0.5 + double{1} * edge / edges - double{1} * up.centidegrees() / 36000);
    return std::pair(std::round(1e6 * std::cos(turn)), std::sin(turn));  // then by how far it is to the left
  };
  int top = 0;
  for (int edge = 1; edge < edges; ++edge) {
    if (heightOf(edge) > heightOf(top)) top = edge;
  }
  return top;
}

// The hint said "while its arrow points up on the screen", but on levels 10, 15, 22 and 27 to 30 arrows of blocks that
// are solid lean by 36° and 60°.
TEST(ElementHints, ThatOfUpSaysWhenItBlocks) {
  ElementHints hints;
  UntoldElements untold;
  play(hints, elementsOf({ElementKind::kUp}), untold, 1);
  EXPECT_EQ(hints.hint(),
            "A wall of arrows is solid while its arrows are filled, and they are while they point up for you");
  for (const int edges : {3, 4, 5}) {
    for (int degrees = 0; degrees < 360; ++degrees) {
      Element element;
      for (element.number = 0; element.number < edges; ++element.number) {
        const Angle up(degrees * 100);
        EXPECT_EQ(pointsTo(up, element, edges), topEdge(up, edges) == element.number)
            << degrees << "° and edge " << int{element.number} << " of " << edges;
      }
    }
  }
}

// On level 5, a door with a key told of a plate, and there is none.
TEST(ElementHints, ThatOfADoorSaysWhatOpensItOnThisLevel) {
  const auto hintOf = [](std::initializer_list<ElementKind> kinds) {
    ElementHints hints;
    UntoldElements untold;
    play(hints, elementsOf(kinds), untold, 1, ballOn(0));
    return std::string(hints.hint());
  };
  constexpr ElementKind kDoor = ElementKind::kDoor;
  EXPECT_EQ(hintOf({kDoor, ElementKind::kKey}), "A door opens with the key of its number");
  EXPECT_EQ(hintOf({kDoor, ElementKind::kPlate}), "A door is open while somebody stands on the plate of its number");
  EXPECT_EQ(hintOf({kDoor, ElementKind::kPlate, ElementKind::kKey}),
            "A door opens with the key of its number, or while somebody stands on the plate of its number");
}

TEST(ElementHints, EveryKindHasAHint) {
  for (const ElementKind kind : kElementKinds) {
    ElementHints hints;
    UntoldElements untold;
    play(hints, elementsOf({kind}), untold, 1);
    EXPECT_FALSE(hints.hint().empty()) << wordOf(kind);
  }
}

TEST(UntoldElements, ParsingTheTextGivesTheSame) {
  for (ElementKindMask mask = 0; mask <= UntoldElements().mask; ++mask) {
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
}  // namespace platon::element_hints_test
