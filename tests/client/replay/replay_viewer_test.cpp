#include "client/replay/replay_viewer.h"

#include <gtest/gtest.h>

#include "tests/client/replay/followed_game.h"
#include "tests/client/replay/replay_of.h"
#include "tests/exactness/properties/seeded_cases.h"
#include "tests/shared/game/played_game.h"
#include "tests/shared/game/recorded_game.h"
#include "tests/support/files.h"

namespace platon::replay_viewer_test {
namespace {

constexpr double kTick = 1.0 / kTicksPerSecond;

TEST(ReplayPlayer, PlaysOneTickInOneTicksTime) {
  const RecordedGame recorded = recordGame(200, 60);
  ReplayPlayer player(replayOf(recorded.recording));
  EXPECT_EQ(player.tick(), 0U);
  for (std::uint32_t i = 1; i <= 200; ++i) {
    player.advance(kTick * 0.999999);
    EXPECT_NEAR(player.tick() - 1 + player.fraction(), i, 0.01);
  }
  EXPECT_EQ(player.game().save(), recorded.states[200]);
}

// Every way to move about, in any order.
TEST(ReplayPlayer, EveryStateIsThatOfTheStraightPlay) {
  const RecordedGame recorded = recordGame(900, 60);
  const auto replay = replayOf(recorded.recording);
  properties::forEachCase(3, [&](oracle::RandomSource& random) {
    ReplayPlayer player(replay);
    for (int i = 0; i < 200; ++i) {
      const auto choice = random.below(6);
      if (choice == 0) player.seek(static_cast<std::uint32_t>(random.below(1000)));
      if (choice == 1) player.step(1);
      if (choice == 2) player.step(-1);
      if (choice == 3) player.step(static_cast<std::int32_t>(random.below(100)) - 50);
      if (choice == 4) player.togglePause();
      if (choice == 5) player.advance(static_cast<double>(random.below(100)) / 50);
      ASSERT_EQ(player.game().save(), recorded.states[player.tick()]) << player.tick();
    }
  });
}

TEST(ReplayPlayer, SkippingLeadsToThePictureThatPlayingLeadsTo) {
  const auto replay = replayOf(recordGame(300, 60).recording);
  for (const double seconds : {0.0, 0.004, 0.5, 2.0, 3.21, 4.999, 5.0, 6.0, 1e6}) {
    ReplayPlayer played(replay);
    played.advance(seconds);
    ReplayPlayer skipped(replay);
    skipped.skipTo(seconds);
    EXPECT_EQ(skipped.tick(), played.tick()) << seconds;
    EXPECT_NEAR(skipped.fraction(), played.fraction(), 1e-6) << seconds;
    EXPECT_EQ(skipped.paused(), played.paused()) << seconds;
    EXPECT_TRUE(skipped.game() == played.game()) << seconds;
    ASSERT_EQ(skipped.players().before.size(), played.players().before.size());
    for (std::size_t slot = 0; slot < played.players().before.size(); ++slot) {
      EXPECT_EQ(skipped.players().before[slot].position, played.players().before[slot].position) << seconds;
      EXPECT_EQ(skipped.players().now[slot].position, played.players().now[slot].position) << seconds;
    }
  }
}

TEST(ReplayPlayer, StepsOnAllGoldenRecordings) {
  for (const std::string& file : filesIn("tests/determinism/golden", ".recording")) {
    const auto replay = replayOf(readBytes(file));
    ReplayPlayer player(replay);
    player.seek(replay->ticks() / 2);
    const std::uint64_t middle = player.game().hash();
    player.step(1);
    const std::uint64_t next = player.game().hash();
    player.step(-1);
    EXPECT_EQ(player.game().hash(), middle) << file;
    player.advance(1);
    EXPECT_EQ(player.game().hash(), middle) << "a step pauses";
    player.togglePause();
    player.advance(kTick);
    EXPECT_EQ(player.game().hash(), next) << file;
    player.seek(UINT32_MAX);
    EXPECT_EQ(player.game().hash(), replay->gameAfter(replay->ticks()).hash()) << file;
  }
}

TEST(ReplayPlayer, StopsAtTheEndAndBeginsAgain) {
  ReplayPlayer player(replayOf(recordGame(100, 60).recording));
  player.advance(10);
  EXPECT_EQ(player.tick(), 100U);
  EXPECT_TRUE(player.paused());
  EXPECT_EQ(player.fraction(), 1);
  player.step(1);
  EXPECT_EQ(player.tick(), 100U);
  player.togglePause();
  EXPECT_EQ(player.tick(), 0U);
  EXPECT_FALSE(player.paused());
  player.step(-1);
  EXPECT_EQ(player.tick(), 0U);
}

TEST(ReplayPlayer, HasFiveSpeeds) {
  ReplayPlayer player(replayOf(recordGame(400, 60).recording));
  EXPECT_EQ(player.speed(), 1);
  for (const double speed : {2, 4, 4}) {
    player.faster();
    EXPECT_EQ(player.speed(), speed);
  }
  player.advance(0.5);
  EXPECT_NEAR(player.tick() - 1 + player.fraction(), 120, 0.01);
  for (const double speed : {2.0, 1.0, 0.5, 0.25, 0.25}) {
    player.slower();
    EXPECT_EQ(player.speed(), speed);
  }
}

TEST(ReplayPlayer, InterpolatesBetweenTheLastTwoTicks) {
  ReplayPlayer player(replayOf(recordGame(100, 60).recording));
  player.seek(50);
  EXPECT_EQ(player.players().before[0].position, player.players().now[0].position);
  const Point last = player.players().now[0].position;
  player.advance(kTick / 2);
  EXPECT_EQ(player.tick(), 51U);
  EXPECT_NEAR(player.fraction(), 0.5, 1e-6);
  EXPECT_EQ(player.players().before[0].position, last);
  EXPECT_EQ(player.players().now[0].position, player.game().world().entities()[0].position);
}

TEST(ReplayPlayer, FollowsThosePresent) {
  PlayedGame played(recordedLevel());
  Recorder recorder(played.game);
  const std::vector<Input> inputs{{}, {Input::kPresent}, {}, {Input::kPresent}};
  played.game.advance(inputs);
  recorder.record(inputs, played.game);
  recorder.finish(played.game);
  ReplayPlayer player(replayOf(recorder.takeBytes()));
  player.followNext();
  player.seek(1);
  EXPECT_EQ(player.followed(), 1U);
  player.followNext();
  EXPECT_EQ(player.followed(), 3U);
  player.followNext();
  EXPECT_EQ(player.followed(), 1U);
}

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

// Who followed the second player read another medal than the game had given.
TEST(ReplayOfATeam, HasTheTimeOfTheTeamWhoeverIsFollowed) {
  const auto replay = replayOf(readBytes("levels/data/ways/06_hold_the_door.recording"));
  ReplayViewer viewer(replay);
  viewer.skipTo(secondsOf(replay->ticks()));
  const std::uint32_t team = teamOf(viewer.player().game()).finishTicks;
  ASSERT_GT(team, 0U);
  for (const int player : {1, 2}) {
    ASSERT_TRUE(viewer.scene().teamSeconds) << player;
    EXPECT_DOUBLE_EQ(*viewer.scene().teamSeconds, secondsOf(team)) << player;
    viewer.handle(KeyEvent{.key = Key::kTab});
  }
}

TEST_F(ReplayViewerTest, BeforeTheFirstTickTheStartIsShown) {
  const Scene scene = viewer_.scene();
  EXPECT_TRUE(scene.players.empty());
  EXPECT_EQ(viewer_.status().tick, 0U);
  EXPECT_EQ(viewer_.status().ticks, 1000U);
}

}  // namespace
}  // namespace platon::replay_viewer_test
