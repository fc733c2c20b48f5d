#include "client/replay/replay_viewer.h"

#include <gtest/gtest.h>

#include "tests/client/replay/followed_game.h"
#include "tests/client/replay/replay_of.h"
#include "tests/shared/game/played_game.h"
#include "tests/shared/game/recorded_game.h"

namespace platon::replay_viewer_test {
namespace {

constexpr float kWidth = 1280;
constexpr glm::vec2 kScreen(kWidth, Overlay::kHeight);

class ReplayViewerTest : public testing::Test {
 protected:
  void press(Key key, bool shift = false) { viewer_.handle(KeyEvent{.key = key, .shift = shift}); }
  void point(PointerEvent::Kind kind, glm::dvec2 place) {
    viewer_.handle(PointerEvent{.kind = kind, .place = place}, kScreen);
  }
  std::uint32_t tick() const { return viewer_.player().tick(); }

  // The place of the bar for a tick.
  static glm::dvec2 placeOf(double share) {
    double from = 0;
    while (!replayBarAt({from, kLine}, kScreen)) from += 1;
    while (replayBarAt({from, kLine}, kScreen) == 0) from += 1;
    from -= 1;
    double to = from + 1;
    while (replayBarAt({to, kLine}, kScreen) < 1) to += 1;
    return {from + (to - from) * share, kLine};
  }

  static constexpr double kLine = Overlay::kHeight - 56;
  const RecordedGame recorded_ = recordGame(1000, 60);
  ReplayViewer viewer_{replayOf(recorded_.recording)};
};

TEST_F(ReplayViewerTest, TheArrowsStepAndLeap) {
  viewer_.advance(1);
  press(Key::kArrowRight, true);
  EXPECT_EQ(tick(), 60U + ReplayViewer::kLeapTicks);
  EXPECT_FALSE(viewer_.player().paused()) << "it goes on from there";
  press(Key::kArrowRight);
  EXPECT_EQ(tick(), 61U + ReplayViewer::kLeapTicks);
  EXPECT_TRUE(viewer_.player().paused());
  press(Key::kArrowLeft);
  press(Key::kArrowLeft);
  EXPECT_EQ(tick(), 59U + ReplayViewer::kLeapTicks);
  viewer_.handle(KeyEvent{.key = Key::kArrowLeft, .kind = KeyEvent::Kind::kRepeat});
  EXPECT_EQ(tick(), 57U + ReplayViewer::kLeapTicks);
  viewer_.handle(KeyEvent{.key = Key::kArrowLeft, .kind = KeyEvent::Kind::kRelease});
  press(Key::kArrowLeft, true);
  press(Key::kArrowLeft, true);
  EXPECT_EQ(tick(), 0U);
}

TEST_F(ReplayViewerTest, KeysPauseAndChangeTheSpeed) {
  press(Key::kSpace);
  EXPECT_TRUE(viewer_.status().paused);
  press(Key::kSpace);
  press(Key::kPlus);
  EXPECT_EQ(viewer_.status().speed, 2);
  press(Key::kMinus);
  press(Key::kMinus);
  EXPECT_EQ(viewer_.status().speed, 0.5);
}

TEST_F(ReplayViewerTest, AGamepadPausesStepsAndChangesTheSpeed) {
  press(Key::kPadA);
  EXPECT_TRUE(viewer_.status().paused);
  press(Key::kPadRight);
  press(Key::kPadRight);
  press(Key::kPadLeft);
  EXPECT_EQ(tick(), 1U);
  press(Key::kPadUp);
  press(Key::kPadUp);
  press(Key::kPadDown);
  EXPECT_EQ(viewer_.status().speed, 2);
  press(Key::kPadRightBumper);
  press(Key::kPadRightBumper);
  EXPECT_EQ(tick(), 1U + 2 * ReplayViewer::kLeapTicks);
  press(Key::kPadLeftBumper);
  EXPECT_EQ(tick(), 1U + ReplayViewer::kLeapTicks);
}

TEST_F(ReplayViewerTest, AClickOnThePicturePausesAndPlaysOn) {
  for (const bool paused : {true, false}) {
    point(PointerEvent::Kind::kPress, {kWidth / 2, 100});
    point(PointerEvent::Kind::kRelease, {kWidth / 2, 100});
    EXPECT_EQ(viewer_.status().paused, paused);
  }
  point(PointerEvent::Kind::kPress, {20, kLine});
  EXPECT_FALSE(viewer_.status().paused) << "beside the line of the bar";
}

TEST_F(ReplayViewerTest, TabFollowsTheNextPlayer) {
  viewer_.advance(0.5);
  const Scene first = viewer_.scene();
  ASSERT_EQ(first.players.size(), 3U);
  EXPECT_TRUE(first.players.back().local);
  EXPECT_EQ(first.focus.position, first.players.back().pose.position);
  press(Key::kTab);
  EXPECT_NE(viewer_.scene().players.back().slot, first.players.back().slot);
}

TEST_F(ReplayViewerTest, TheBarIsClickedAndDragged) {
  viewer_.advance(1);
  point(PointerEvent::Kind::kMove, placeOf(0.5));
  EXPECT_EQ(tick(), 60U) << "not pressed";
  point(PointerEvent::Kind::kPress, placeOf(0.5));
  EXPECT_NEAR(tick(), 500, 2);
  viewer_.advance(1);
  EXPECT_NEAR(tick(), 500, 2) << "held";
  point(PointerEvent::Kind::kMove, {kWidth, 0});
  EXPECT_EQ(tick(), 1000U);
  point(PointerEvent::Kind::kRelease, {kWidth, 0});
  point(PointerEvent::Kind::kMove, placeOf(0.5));
  EXPECT_EQ(tick(), 1000U);
  point(PointerEvent::Kind::kPress, {kWidth / 2, 100});
  EXPECT_EQ(tick(), 1000U) << "beside the bar";
}

// Before, a run began under a clock that showed 4:59.
TEST_F(ReplayViewerTest, TheClockOfTheRoundIsShownOnlyForSeveralPlayers) {
  viewer_.advance(0.5);
  EXPECT_TRUE(viewer_.scene().timed);
  FollowedGame game(cubeLevel("0 0 -180 0", {"-240 -200 240 -200"}, "0 100 -190"));
  game.hold(30, 0);
  game.holdToGoal(300, Input::kRight);
  ReplayViewer run(replayOf(game.run.value().recording));
  for (const double seconds : {0.0, 0.5, 60.0}) {
    run.skipTo(seconds);
    EXPECT_FALSE(run.scene().timed) << seconds;
  }
  EXPECT_TRUE(run.scene().attempt->arrived);
}

TEST_F(ReplayViewerTest, BeforeTheFirstTickTheStartIsShown) {
  const Scene scene = viewer_.scene();
  EXPECT_TRUE(scene.players.empty());
  EXPECT_EQ(viewer_.status().tick, 0U);
  EXPECT_EQ(viewer_.status().ticks, 1000U);
}

}  // namespace
}  // namespace platon::replay_viewer_test
