#include "client/scene/edge_crossing.h"

#include <cmath>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "platon/game/game.h"
#include "platon/game/level.h"
#include "tests/client/scene/surface_walk.h"
#include "tests/support/sample_word.h"

namespace platon::edge_crossing_test {
namespace {

// Whether the way from the middle of face 0 upwards, and the one to the side, is free past a segment above the middle.
struct Ways {
  bool up = false;
  bool aside = false;
};

Ways waysPast(const std::string& word, bool active) {
  const LevelResult result =
      loadLevel("HEXAHEDRON\n1 0 0 0\n1 60 80\n480\n%\n-50 40 50 40 " + word + "\n%\n%\n%\n%\n%\n");
  if (!result.level) throw std::logic_error("test level: " + result.diagnostics.front().message);
  const auto stage = makeStageModel(*result.level);
  ElementStates states = elementStatesOf(Game(result.level), std::nullopt, stage->mesh);
  states.active.assign(states.active.size(), active ? 1 : 0);
  return {wayIsFree(*stage, states, 0, {0, 0}, {0, 240}), wayIsFree(*stage, states, 0, {0, 0}, {240, 0})};
}

TEST(EdgeWay, ASegmentBlocksOnlyTheWayThatItCrosses) {
  const Ways ways = waysPast("", true);
  EXPECT_FALSE(ways.up);
  EXPECT_TRUE(ways.aside);
}

// A one-way segment may be passed from one side, and a hazard only sends back: the picture takes both for free.
bool isTakenForFree(ElementKind kind) { return kind == ElementKind::kOneway || kind == ElementKind::kHazard; }

TEST(EdgeWay, EveryKindBlocksWhomItsTraitsName) {
  for (const ElementKind kind : kElementKinds) {
    SCOPED_TRACE("blocks() in client/scene/edge_crossing.cpp, for '" + std::string(wordOf(kind)) + "'");
    bool free = false;
    bool blocked = false;
    for (std::uint8_t number = 0; number < 4; ++number) {
      for (const bool active : {true, false})
        (waysPast(sampleWord(kind, number).text(), active).up ? free : blocked) = true;
    }
    EXPECT_EQ(blocked, canBlock(kind) && !isTakenForFree(kind));
    EXPECT_EQ(free, !blocksAlways(kind) || isTakenForFree(kind));
  }
}

TEST(EdgeWay, WhatOpensBlocksWhileItIsActive) {
  for (const char* word : {"up 2", "door 2", "timed 9 9"}) {
    EXPECT_FALSE(waysPast(word, true).up) << word;
    EXPECT_TRUE(waysPast(word, false).up) << word;
  }
}

constexpr double kFrame = 1.0 / 60;
constexpr double kRun = 3.2;  // level units a picture

std::shared_ptr<const StageModel> stageWith(const std::string& segments) {
  return makeStageModel(*loadLevel("HEXAHEDRON\n0 0 0 0\n5 60 80\n480\n%\n" + segments + "%\n%\n%\n%\n%\n").level);
}

class EdgeCrossingTest : public testing::Test {
 protected:
  void standAt(int face, glm::dvec2 place, double angle = 0) {
    walk_ = {&stage_->mesh, face, place, angle};
    step({0, 0});
  }
  // Moves by this way to the right and along up.
  void step(glm::dvec2 way) {
    walk_.step(way);
    crossing_.advance(*stage_, {}, walk_.pose(), seconds_ += kFrame);
  }
  double light() const { return crossing_.glows().empty() ? 0 : crossing_.glows().front().light; }
  // How long the ball stands until `done`, seconds.
  template <class Done>
  double secondsUntil(Done done) {
    double seconds = 0;
    for (; !done() && seconds < 5; seconds += kFrame) step({0, 0});
    return seconds;
  }

  std::shared_ptr<const StageModel> stage_ = stageWith("");
  SurfaceWalk walk_;
  EdgeCrossing crossing_;
  double seconds_ = 1;
};

TEST_F(EdgeCrossingTest, AnEdgeIsLitWithinTheReachOfTheBall) {
  standAt(0, {240 - EdgeCrossing::kReach - 3 * kRun, 20});
  for (int i = 0; i < 3; ++i) {
    step({kRun * 0.9, 0});
    EXPECT_TRUE(crossing_.glows().empty());
  }
  double last = 0;
  while (walk_.face == 0) {
    step({kRun, 0});
    if (walk_.face != 0) break;
    EXPECT_GE(light(), last);
    last = light();
  }
  EXPECT_GT(last, 0.8);
  ASSERT_EQ(crossing_.glows().size(), 1U);
}

TEST_F(EdgeCrossingTest, TheLightIsAtTheFootOfTheBallAndItsUpPointsOverTheEdge) {
  standAt(0, {215, 20});
  step({1, 0});
  ASSERT_EQ(crossing_.glows().size(), 1U);
  const Marker& foot = crossing_.glows()[0].foot;
  EXPECT_EQ(foot.face, 0);
  EXPECT_NEAR(foot.place.x, 240, 1e-3);
  EXPECT_NEAR(foot.place.y, 20, 1e-3);
  EXPECT_NEAR(-std::sin(foot.angle), 1, 1e-9);
}

TEST_F(EdgeCrossingTest, TheLightOfOneEdgeGoesOnOverIt) {
  standAt(0, {200, 20});
  while (walk_.face == 0) step({kRun, 0});
  const double before = light();
  EXPECT_GT(before, 0.6);
  for (int i = 0; i < 3; ++i) step({kRun, 0});
  ASSERT_EQ(crossing_.glows().size(), 1U) << "one edge, seen from both faces";
  EXPECT_EQ(crossing_.glows()[0].foot.face, walk_.face);
  EXPECT_LT(light(), before);
}

TEST_F(EdgeCrossingTest, BehindTheBallItFadesIn300Milliseconds) {
  standAt(0, {200, 20});
  while (walk_.face == 0) step({kRun, 0});
  double seconds = 0;
  for (; light() > 0; seconds += kFrame) step({8, 0});
  EXPECT_LE(seconds, EdgeCrossing::kFadeSeconds + kFrame + 1e-9);
  EXPECT_GE(seconds, EdgeCrossing::kFadeSeconds / 2);
}

TEST_F(EdgeCrossingTest, BesideABallThatRestsAnEdgeIsDim) {
  standAt(0, {230, 20});
  for (int i = 0; i < 60; ++i) step({0, 0});
  EXPECT_GT(light(), 0.1);
  EXPECT_LE(light(), EdgeCrossing::kStill);
}

TEST_F(EdgeCrossingTest, NoLightRisesFasterThanItsTime) {
  standAt(0, {199, 20});
  double last = 0;
  for (int i = 0; i < 40; ++i) {
    step({7, 0});
    EXPECT_LE(light() - last, kFrame / EdgeCrossing::kRiseSeconds + 1e-9);
    last = light();
  }
}

TEST_F(EdgeCrossingTest, AnEdgeBehindAWallIsNotLit) {
  stage_ = stageWith("225 -100 225 100\n");
  standAt(0, {205, 20});
  for (int i = 0; i < 30; ++i) step({0, 0});
  EXPECT_TRUE(crossing_.glows().empty());
}

TEST_F(EdgeCrossingTest, AWaveSpreadsFromTheCrossing) {
  standAt(0, {236, 20});
  EXPECT_FALSE(crossing_.wave());
  while (walk_.face == 0) step({kRun, 0});
  ASSERT_TRUE(crossing_.wave());
  const Marker foot = crossing_.wave()->foot;
  EXPECT_EQ(foot.face, walk_.face);
  EXPECT_LT(glm::distance(stage_->mesh.toWorld(foot.face, foot.place), stage_->mesh.toWorld(0, {240, 20})), 1e-3);
  EXPECT_EQ(crossing_.wave()->part, 0);
  step({kRun, 0});
  EXPECT_NEAR(crossing_.wave()->part, kFrame / EdgeCrossing::kWaveSeconds, 1e-9);
  EXPECT_EQ(crossing_.wave()->foot.place, foot.place) << "it stays where it began";
  EXPECT_NEAR(secondsUntil([this] { return !crossing_.wave(); }), EdgeCrossing::kWaveSeconds, 1.5 * kFrame);
}

// More than three flashes a second may harm.
TEST_F(EdgeCrossingTest, WhoCrossesToAndFroSeesAtMostTwoWavesASecond) {
  for (const int ticks : {1, 2, 5, 13, 29}) {
    standAt(0, {239, 20});
    int waves = 0;
    double last = 1;
    for (int tick = 0; tick < 600; ++tick) {
      step({tick % (2 * ticks) < ticks ? 2 : -2, 0});
      const double part = crossing_.wave() ? crossing_.wave()->part : 1;
      waves += part < last ? 1 : 0;
      last = part;
    }
    EXPECT_GT(waves, 5) << ticks;
    EXPECT_LE(waves, 20) << ticks;
    crossing_.reset();
  }
}

TEST_F(EdgeCrossingTest, TheArrowPointsToTheNewDownBelowTheBall) {
  for (const double angle : {0.0, 1.2, 3.0}) {
    standAt(0, {236, 20}, angle);
    EXPECT_FALSE(crossing_.arrow());
    const glm::dvec2 toEdge(std::cos(angle), -std::sin(angle));  // in the frame of the ball
    for (int i = 0; i < 3; ++i) step(kRun * toEdge);
    ASSERT_NE(walk_.face, 0);
    const auto arrow = crossing_.arrow();
    ASSERT_TRUE(arrow);
    EXPECT_EQ(arrow->place.face, walk_.face);
    const Pose pose = walk_.pose();
    const Pose at = stage_->mesh.pose(arrow->place.face, glm::dvec2(arrow->place.place), arrow->place.angle);
    EXPECT_LT(glm::distance(at.up, pose.up), 1e-6) << "it points against its up";
    EXPECT_LT(glm::distance(at.position, pose.position - EdgeCrossing::kArrowBelow * pose.up), 1e-3);
    crossing_.reset();
  }
}

TEST_F(EdgeCrossingTest, TheArrowIsSeenFor800Milliseconds) {
  standAt(0, {238, 20});
  step({kRun, 0});
  EXPECT_NEAR(secondsUntil([this] { return !crossing_.arrow(); }), EdgeCrossing::kArrowSeconds, 1.5 * kFrame);
}

TEST_F(EdgeCrossingTest, WhoCrossesEdgeAfterEdgeSeesOneBriefArrow) {
  standAt(0, {238, 20});
  step({kRun, 0});
  for (int crossing = 0; crossing < 5; ++crossing) {
    for (double seconds = 0; seconds < EdgeCrossing::kArrowSeconds + kFrame; seconds += kFrame) step({0, 0});
    const int before = walk_.face;
    step({crossing % 2 == 0 ? -kRun : kRun, 0});
    EXPECT_NE(walk_.face, before);
    EXPECT_FALSE(crossing_.arrow());
  }
  for (double seconds = 0; seconds < EdgeCrossing::kArrowPause; seconds += kFrame) step({0, 0});
  step({kRun, 0});
  EXPECT_TRUE(crossing_.arrow());
}

TEST_F(EdgeCrossingTest, FloorsOfTheNewFaceAreTinted) {
  for (const double angle : {0.0, 1.2, 3.0}) {
    standAt(0, {236, 20}, angle);
    EXPECT_FALSE(crossing_.tint());
    const glm::dvec2 toEdge(std::cos(angle), -std::sin(angle));  // in the frame of the ball
    while (walk_.face == 0) step(kRun * toEdge);
    step({0, 0});
    const auto tint = crossing_.tint();
    ASSERT_TRUE(tint);
    EXPECT_EQ(tint->face, walk_.face);
    const glm::dvec3 up(stage_->mesh.faceToWorld(tint->face) * glm::dvec4(tint->up, 0, 0));
    EXPECT_LT(glm::distance(up, walk_.pose().up), 1e-6);
    EXPECT_NEAR(secondsUntil([this] { return !crossing_.tint(); }), EdgeCrossing::kTintSeconds, 2.5 * kFrame);
    crossing_.reset();
  }
}

TEST_F(EdgeCrossingTest, TheTintGoesOverToTheNextFaceWithoutAFlash) {
  standAt(0, {238, 20});
  step({kRun, 0});
  for (int i = 0; i < 20; ++i) step({0, 0});
  const int first = walk_.face;
  double last = crossing_.tint()->light;
  while (walk_.face == first) {
    step({-kRun, 0});
    EXPECT_NEAR(crossing_.tint()->light, last, 0.05);
    last = crossing_.tint()->light;
  }
  EXPECT_EQ(crossing_.tint()->face, walk_.face);
}

TEST_F(EdgeCrossingTest, ARestartBeginsAnew) {
  standAt(0, {238, 20});
  step({kRun, 0});
  ASSERT_TRUE(crossing_.arrow());
  standAt(0, {0, 0});
  EXPECT_FALSE(crossing_.arrow());
  EXPECT_FALSE(crossing_.tint());
  EXPECT_TRUE(crossing_.glows().empty());
}

TEST_F(EdgeCrossingTest, DarkenedItKeepsTheArrow) {
  standAt(0, {200, 20});
  while (walk_.face == 0) step({kRun, 0});
  crossing_.darken();
  EXPECT_TRUE(crossing_.glows().empty());
  EXPECT_FALSE(crossing_.wave());
  EXPECT_TRUE(crossing_.arrow());
}

}  // namespace

}  // namespace platon::edge_crossing_test
