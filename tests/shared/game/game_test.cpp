#include "platon/game/game.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <string>

#include "platon/physics/sweep.h"
#include "tests/shared/game/played_game.h"
#include "tests/shared/physics/step/leg_checker.h"
#include "tests/sim/button_presses.h"

namespace platon::game_test {
namespace {

constexpr std::uint64_t kSeed = 515;

const std::string kFlat = "-240 -200 240 -200";
const std::string kLedges = "-240 -200 240 -200\n-150 -140 -40 -140\n60 -90 150 -90\n-100 20 100 40\n-200 100 -150 180";

std::shared_ptr<const Level> flatLevel(const std::string& goal = "5 0 0") {
  return cubeLevel("0 0 -180 0", {kFlat, kFlat, kFlat, kFlat}, goal);
}

std::shared_ptr<const Level> busyLevel() {
  return cubeLevel("0 0 -180 0", {kLedges, kLedges, kLedges, kLedges, kLedges, kLedges}, "2 0 100");
}

// Seeded inputs of players who press buttons, restart, leave and join.
class Crowd {
 public:
  explicit Crowd(std::uint64_t seed) : random_(seed) {
    for (std::uint32_t slot = 0; slot < 4; ++slot) presses_.emplace_back(seed, slot);
  }

  std::vector<Input> next() {
    std::vector<Input> inputs;
    for (std::size_t slot = 0; slot < presses_.size(); ++slot) {
      if (random_.below(100) == 0) away_[slot] = !away_[slot];
      Input input = presses_[slot].next();
      if (random_.below(150) == 0) input.buttons |= Input::kRestart;
      inputs.push_back(away_[slot] ? Input() : input);
    }
    return inputs;
  }

 private:
  sim::SeededRandom random_;
  std::vector<sim::ButtonPresses> presses_;
  bool away_[4] = {false, true, false, true};
};

TEST(GameTest, ANewGameHasNoPlayers) {
  const Game game(flatLevel());
  EXPECT_EQ(game.tick(), 0u);
  EXPECT_EQ(game.ticksLeft(), kRoundTicks);
  EXPECT_EQ(game.slots(), 0u);
  EXPECT_EQ(game.presentPlayers(), 0u);
  EXPECT_FALSE(game.over());
  EXPECT_EQ(game.level().solid, SolidKind::kHexahedron);
}

TEST(GameTest, PlayersJoinAndLeaveByTheirInput) {
  PlayedGame played(flatLevel());
  played.hold(2, kNone);
  played.advance();
  ASSERT_EQ(played.game.slots(), 3u);
  EXPECT_EQ(played.game.presentPlayers(), 1u);
  EXPECT_EQ(played.game.tick(), 1u);
  EXPECT_EQ(played.player(0).present, 0);
  EXPECT_EQ(played.player(2).present, 1);
  EXPECT_EQ(played.entity(0).inserted, 0);
  EXPECT_EQ(played.entity(2).inserted, 1);
  played.hold(2, Input::kRight);
  played.advance(30);
  EXPECT_GT(played.entity(2).position.x, 0);
  played.release(2);
  played.advance();
  EXPECT_EQ(played.game.slots(), 3u) << "the slot stays";
  EXPECT_EQ(played.game.presentPlayers(), 0u);
  EXPECT_EQ(played.player(2), PlayerState());
  EXPECT_EQ(played.entity(2).inserted, 0);
  EXPECT_TRUE(played.game.world().view(2).empty());
  played.hold(2, kNone);
  played.advance();
  EXPECT_EQ(played.entity(2).position.x, 0) << "the player joins at the start";
}

TEST(GameTest, SlotsWithoutInputHaveNoPlayer) {
  PlayedGame played(flatLevel());
  played.hold(1, kNone);
  played.advance(3);
  const Input first[] = {Input{Input::kPresent}};
  played.game.advance(first);
  EXPECT_EQ(played.player(0).present, 1);
  EXPECT_EQ(played.player(1).present, 0);
  played.game.advance({});
  EXPECT_EQ(played.player(0).present, 0);
  EXPECT_EQ(played.game.slots(), 2u);
}

TEST(GameTest, PlaysWithTheLargestNumberOfPlayers) {
  Game game(flatLevel());
  const std::vector<Input> inputs(kMaxPlayers, Input{Input::kPresent | Input::kRight});
  for (int tick = 0; tick < 30; ++tick) game.advance(inputs);
  ASSERT_EQ(game.slots(), kMaxPlayers);
  EXPECT_EQ(game.presentPlayers(), kMaxPlayers);
  for (std::uint32_t slot = 1; slot < kMaxPlayers; ++slot) {
    EXPECT_EQ(game.world().entities()[slot].position, game.world().entities()[0].position) << "they do not collide";
  }
  Game copy(flatLevel());
  EXPECT_TRUE(copy.restore(game.save()));
  EXPECT_EQ(copy, game);
}

// Runs to the right until the player has finished.
void runToGoal(PlayedGame& played) {
  for (int tick = 0; tick < 400 && !played.player().finished(); ++tick) played.run(1, Input::kRight);
  ASSERT_TRUE(played.player().finished());
}

TEST(GameTest, TheGoalIsADiscThatTheBallTouches) {
  PlayedGame played(flatLevel("0 100 -184"));
  played.run(30, kNone);
  EXPECT_FALSE(played.player().finished());
  runToGoal(played);
  EXPECT_TRUE(played.game.over());
  const auto distanceBefore = [&](int ticks) {
    const Point goal(units(100), units(-184));
    const Point before = played.position() - Point(ticks * 3277, 0);
    return std::hypot(goal.x - before.x, goal.y - before.y);
  };
  EXPECT_LT(distanceBefore(0), units(28));
  EXPECT_GE(distanceBefore(1), units(28));
}

TEST(GameTest, TheGoalIsTouchedFromTheFaceBehindAnEdge) {
  PlayedGame played(flatLevel("1 -236 -188"));
  played.run(30, kNone);
  runToGoal(played);
  EXPECT_EQ(played.entity().part, 0u) << "the centre has not crossed the edge";
  EXPECT_TRUE(played.game.world().instancesOf(0).empty()) << "and no part of the ball";
}

// The edges of the ball's shape are a quarter of a unit nearer to its centre than its radius.
TEST(GameTest, TheGoalIsNotTouchedThroughAWallThatItDoesNotCross) {
  PlayedGame played(cubeLevel("0 0 -180 0", {kFlat + "\n100 -240 100 240"}, "0 117 -188"));
  played.run(200, Input::kRight);
  EXPECT_GE(played.position().x, units(88) - 1);
  EXPECT_FALSE(played.player().finished());
}

TEST(GameTest, APlayerFinishesInTheTicksSinceItsFirstInput) {
  PlayedGame played(flatLevel("0 100 -190"));
  played.run(200, kNone);
  EXPECT_EQ(played.player().startedAt, 0u) << "waiting costs no time";
  runToGoal(played);
  EXPECT_EQ(played.player().startedAt, 201u);
  EXPECT_EQ(played.player().finishTicks, played.game.tick() - 200);
  PlayedGame late(flatLevel("0 100 -190"));
  late.run(20, kNone);
  runToGoal(late);
  EXPECT_EQ(late.player().finishTicks, played.player().finishTicks) << "whenever the player begins";
}

TEST(GameTest, ARestartBeginsANewAttemptAndTheShortestTimeCounts) {
  PlayedGame played(flatLevel("0 100 -190"));
  played.run(30, kNone);
  played.run(10, Input::kLeft);
  played.run(50, kNone);
  runToGoal(played);
  const std::uint32_t slow = played.player().finishTicks;
  played.run(50, Input::kRight);
  EXPECT_EQ(played.player().finishTicks, slow) << "an attempt ends at the goal";
  played.run(1, Input::kRestart);
  EXPECT_EQ(played.player().startedAt, 0u);
  EXPECT_EQ(played.player().arrived, 0);
  EXPECT_TRUE(played.player().finished()) << "in this round";
  while (played.player().arrived == 0) played.run(1, Input::kRight);
  const std::uint32_t fast = played.player().finishTicks;
  EXPECT_LT(fast, slow - 50);
  played.run(1, Input::kRestart);
  played.run(10, Input::kLeft);
  while (played.player().arrived == 0) played.run(1, Input::kRight);
  EXPECT_EQ(played.player().finishTicks, fast) << "a longer time changes nothing";
}

TEST(GameTest, PlayersOfALevelWithoutKeysAreTimedAlone) {
  PlayedGame played(flatLevel());
  played.run(20, Input::kRight);
  played.hold(1, Input::kRight);
  played.run(5, Input::kRight);
  EXPECT_EQ(played.player(0).startedAt, 1u);
  EXPECT_EQ(played.player(1).startedAt, 21u);
}

TEST(GameTest, AnArrivalWithoutInputTakesATick) {
  PlayedGame played(flatLevel("0 0 -184"));
  played.run(60, kNone);
  EXPECT_EQ(played.player().finishTicks, 1u);
}

TEST(GameTest, ARoundEndsWhenAllPresentHaveFinished) {
  PlayedGame played(flatLevel("0 100 -190"));
  played.hold(0, Input::kRight);
  played.hold(1, kNone);
  played.advance();
  for (int tick = 0; tick < 300 && !played.player(0).finished(); ++tick) played.advance();
  ASSERT_TRUE(played.player(0).finished());
  EXPECT_FALSE(played.game.over());
  PlayedGame other = played;
  other.release(1);
  other.advance();
  EXPECT_TRUE(other.game.over()) << "every player still present has finished";
  played.hold(1, Input::kRight);
  for (int tick = 0; tick < 300 && !played.player(1).finished(); ++tick) played.advance();
  EXPECT_TRUE(played.game.over());
}

TEST(GameTest, ARoundThatIsOverStaysOver) {
  PlayedGame played(flatLevel("0 100 -190"));
  for (int tick = 0; tick < 300 && !played.game.over(); ++tick) played.run(1, Input::kRight);
  ASSERT_TRUE(played.game.over());
  played.hold(1, kNone);
  const Point before = played.position();
  played.run(5, Input::kRight);
  EXPECT_TRUE(played.game.over());
  EXPECT_NE(played.position(), before) << "players can still move";
}

TEST(GameTest, ARoundEndsWhenTheTimeIsUp) {
  Game game(flatLevel());
  for (std::uint32_t tick = 1; tick < kRoundTicks; ++tick) game.advance({});
  EXPECT_FALSE(game.over());
  EXPECT_EQ(game.ticksLeft(), 1u);
  game.advance({});
  EXPECT_TRUE(game.over());
  EXPECT_EQ(game.ticksLeft(), 0u);
  game.advance({});
  EXPECT_EQ(game.ticksLeft(), 0u);
  EXPECT_EQ(game.tick(), kRoundTicks + 1);
}

TEST(GameTest, RestartMovesThePlayerToTheStart) {
  PlayedGame played(flatLevel());
  PlayedGame fresh(flatLevel());
  fresh.run(1, Input::kRestart);
  played.run(40, Input::kRight | Input::kJump);
  played.run(1, Input::kRestart);
  EXPECT_EQ(played.position(), fresh.position());
  EXPECT_EQ(played.player(), fresh.player());
  const Point before = played.position();
  played.run(10, Input::kRestart | Input::kRight);
  EXPECT_GT(played.position().x, before.x) << "a held button restarts once";
}

TEST(GameTest, TheSameInputsGiveTheSameGame) {
  Game one(busyLevel());
  Game two(busyLevel());
  Crowd crowdOne(kSeed);
  Crowd crowdTwo(kSeed);
  std::set<std::uint64_t> hashes;
  for (int tick = 0; tick < 1500; ++tick) {
    one.advance(crowdOne.next());
    two.advance(crowdTwo.next());
    ASSERT_EQ(one, two) << "seed " << kSeed << ", tick " << tick;
    ASSERT_EQ(one.hash(), two.hash());
    hashes.insert(one.hash());
  }
  EXPECT_EQ(hashes.size(), 1500u) << "every tick has a different hash";
}

TEST(GameTest, CopiesAreIndependent) {
  Game game(busyLevel());
  Crowd crowd(kSeed);
  for (int tick = 0; tick < 200; ++tick) game.advance(crowd.next());
  const Game before = game;
  const std::uint64_t hash = game.hash();
  Game copy = game;
  for (int tick = 0; tick < 100; ++tick) copy.advance(crowd.next());
  EXPECT_EQ(game, before);
  EXPECT_EQ(game.hash(), hash);
  EXPECT_FALSE(copy == game);
  EXPECT_NE(copy.hash(), hash);
}

TEST(GameTest, APredictedCopyBecomesTheConfirmedGame) {
  Game confirmed(busyLevel());
  Game predicted(busyLevel());
  Crowd crowd(kSeed);
  for (int tick = 0; tick < 300; ++tick) {
    predicted = confirmed;
    Crowd ahead = crowd;
    for (int step = 0; step < 8; ++step) predicted.advance(ahead.next());
    confirmed.advance(crowd.next());
  }
  Crowd ahead = crowd;
  predicted = confirmed;
  for (int step = 0; step < 8; ++step) {
    predicted.advance(ahead.next());
    confirmed.advance(crowd.next());
  }
  EXPECT_EQ(predicted, confirmed);
}

TEST(GameTest, NoPlayerEverOverlapsASegment) {
  Game game(busyLevel());
  LegChecker checker(game.world());
  Crowd crowd(kSeed);
  for (int tick = 0; tick < 2000; ++tick) {
    checker.forget();
    game.advance(crowd.next(), &checker);
  }
  EXPECT_EQ(checker.faults(), "");
  EXPECT_GT(checker.legs(), 2000u);
}

TEST(GameTest, GamesOnOtherLevelsDiffer) {
  EXPECT_FALSE(Game(flatLevel()) == Game(busyLevel()));
  EXPECT_TRUE(Game(flatLevel()) == Game(flatLevel()));
}

}  // namespace
}  // namespace platon::game_test
