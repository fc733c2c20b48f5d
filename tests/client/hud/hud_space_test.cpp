#include "client/hud/hud_space.h"

#include <gtest/gtest.h>

namespace platon::hud_space_test {
namespace {

const Font& font() {
  static const Font font;
  return font;
}

Overlay panelAt(glm::vec2 low, glm::vec2 high) {
  Overlay overlay;
  overlay.panels.push_back({low, high, 4, glm::vec4(1)});
  return overlay;
}

TEST(HudSpace, PartsNeitherOverlapNorLeaveTheScreen) {
  HudSpace space(font(), {100, 100});
  EXPECT_TRUE(space.add(panelAt({10, 10}, {40, 40})));
  EXPECT_FALSE(space.add(panelAt({39, 39}, {60, 60})));
  EXPECT_TRUE(space.add(panelAt({40, 10}, {60, 40}))) << "touching is no overlap";
  EXPECT_FALSE(space.add(panelAt({80, 80}, {101, 90})));
  EXPECT_FALSE(space.add(panelAt({-1, 80}, {10, 90})));
  EXPECT_EQ(space.overlay().panels.size(), 2U);
}

TEST(HudSpace, AnEmptyPartNeedsNoRoom) {
  HudSpace space(font(), {100, 100});
  EXPECT_TRUE(space.add({}));
  EXPECT_TRUE(space.add(panelAt({0, 0}, {100, 100})));
  EXPECT_TRUE(space.add({}));
}

TEST(HudSpace, WhatMayBeCoveredTakesNoRoom) {
  HudSpace space(font(), {100, 100});
  space.addOver(panelAt({10, 10}, {40, 40}));
  EXPECT_TRUE(space.add(panelAt({10, 10}, {40, 40})));
  space.addOver(panelAt({10, 10}, {40, 40}));
  EXPECT_EQ(space.overlay().panels.size(), 2U);
}

TEST(HudSpace, TellsWhereTheColumnsEndAndTheFootStarts) {
  HudSpace space(font(), {100, 100});
  EXPECT_EQ(space.endOfColumn(false), 0);
  EXPECT_EQ(space.startOfFoot(), 100);
  space.add(panelAt({5, 5}, {20, 25}));
  space.add(panelAt({70, 5}, {90, 35}));
  space.add(panelAt({30, 80}, {70, 95}));
  EXPECT_EQ(space.endOfColumn(false), 25);
  EXPECT_EQ(space.endOfColumn(true), 35);
  EXPECT_EQ(space.startOfFoot(), 80);
}

TEST(HudSpace, AReservedFootStaysFree) {
  HudSpace space(font(), {100, 100});
  space.reserveFoot(0);
  EXPECT_EQ(space.startOfFoot(), 100);
  space.reserveFoot(20);
  EXPECT_EQ(space.startOfFoot(), 80);
  EXPECT_FALSE(space.add(panelAt({10, 50}, {20, 81})));
  EXPECT_TRUE(space.add(panelAt({10, 50}, {20, 80})));
  EXPECT_EQ(space.overlay().panels.size(), 1U);
}

TEST(HudSpace, BoundsAndMovesAgree) {
  Overlay part = panelAt({10, 20}, {30, 40});
  part.texts.push_back({{28, 44}, 10, glm::vec4(1), "W"});
  const HudBox box = boundsOf(part, font());
  EXPECT_EQ(box.low, glm::vec2(10, 20));
  EXPECT_FLOAT_EQ(box.high.x, 28 + 10 * font().width("W"));
  EXPECT_FLOAT_EQ(box.high.y, 47);
  EXPECT_EQ(boundsOf(movedBy(part, {1, 2}), font()).low, glm::vec2(11, 22));
}

}  // namespace
}  // namespace platon::hud_space_test
