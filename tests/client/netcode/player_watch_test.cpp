#include "client/netcode/player_watch.h"

#include <gtest/gtest.h>

#include <initializer_list>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "platon/game/game.h"
#include "tests/levels/shipped_level.h"
#include "tests/shared/game/played_game.h"
#include "tests/support/files.h"
#include "tests/support/test_levels.h"

namespace platon::player_watch_test {
namespace {

int lapsOf(std::initializer_list<std::uint32_t> faces) {
  FallLaps laps;
  for (const std::uint32_t face : faces) laps.enter(face);
  return laps.count();
}

TEST(FallLaps, ALapEndsOnAFaceOfItAfterFourOrMore) {
  EXPECT_EQ(lapsOf({0, 1, 5, 3}), 0);
  EXPECT_EQ(lapsOf({0, 1, 5, 3, 0}), 1);
  EXPECT_EQ(lapsOf({2, 0, 1, 5, 3, 0}), 1) << "the face that was left is not on the way round";
  EXPECT_EQ(lapsOf({0, 0, 1, 1, 5, 5, 3, 3, 0, 0}), 1) << "a tick on the same face";
  EXPECT_EQ(lapsOf({0, 1, 5, 3, 0, 1, 5, 3}), 1);
  EXPECT_EQ(lapsOf({0, 1, 5, 3, 0, 1, 5, 3, 0, 1, 5, 3, 0}), 3);
}

TEST(FallLaps, RoundACornerAndOverAnEdgeAndBackIsNoLap) {
  EXPECT_EQ(lapsOf({0, 1, 2, 0, 1, 2, 0, 1, 2}), 0);
  EXPECT_EQ(lapsOf({0, 1, 0, 1, 0, 1}), 0);
}

// A cube whose player begins in the air, in the middle of face 0, with one segment or none. Below face 0 are face 5,
// face 2 and face 4.
std::shared_ptr<const Level> airLevel(int face = 0, const std::string& segment = "") {
  std::string text = "HEXAHEDRON\n0 0 0 0\n4 200 200\n480\n";
  for (int i = 0; i < 6; ++i) text += "%\n" + (i == face ? segment + "\n" : "");
  const LevelResult result = loadLevel(text);
  if (!result.level) throw std::logic_error("test level: " + result.diagnostics.front().message);
  return result.level;
}

class EndlessFallTest : public testing::Test {
 protected:
  void begin(const std::shared_ptr<const Level>& level) {
    game_.emplace(level);
    fall_ = {};
    play(0);
  }

  void play(std::uint8_t buttons, std::uint32_t ticks = 1) {
    inputs_[0] = {static_cast<std::uint8_t>(buttons | Input::kPresent)};
    for (std::uint32_t tick = 0; tick < ticks; ++tick) {
      game_->advance(inputs_);
      fall_.observe(game_->tick(), *game_, 0);
    }
  }

  // Plays until it is so. Returns the ticks that this took; `limit` if it is not so until then.
  template <class Condition>
  std::uint32_t playUntil(std::uint8_t buttons, std::uint32_t limit, Condition condition) {
    for (std::uint32_t ticks = 0; ticks < limit; ++ticks) {
      if (condition()) return ticks;
      play(buttons);
    }
    return limit;
  }

  std::uint32_t crossings() const { return game_->world().entities()[0].crossings; }
  bool stands() const { return game_->player(0).ground != Point(); }

  std::optional<Game> game_;
  EndlessFall fall_;
  std::vector<Input> inputs_ = std::vector<Input>(1);
};

TEST_F(EndlessFallTest, ItIsToldWithinOneAndAHalfSeconds) {
  for (const std::uint8_t buttons : {std::uint8_t{0}, Input::kLeft, Input::kRight, Input::kDown}) {
    begin(airLevel());
    const std::uint32_t ticks = playUntil(buttons, 200, [&] { return fall_.needsHint(); });
    EXPECT_GE(ticks, EndlessFall::kPatience) << int{buttons};
    EXPECT_LE(ticks, 90u) << int{buttons};
    EXPECT_LT(crossings(), 4u) << "within the first lap";
  }
}

TEST_F(EndlessFallTest, ItIsLongOverFourEdgesOrOnceItIsToldUntilThePlayerStands) {
  begin(airLevel());
  playUntil(0, 200, [&] { return fall_.isLong(); });
  EXPECT_TRUE(fall_.needsHint());
  begin(airLevel(4, "-240 -100 240 -100"));
  playUntil(0, 1000, [&] { return stands() || fall_.isLong(); });
  EXPECT_TRUE(stands()) << "three edges, and it lands";
  begin(airLevel(0, "-240 220 240 220"));
  playUntil(0, 1000, [&] { return stands() || fall_.isLong(); });
  EXPECT_TRUE(fall_.isLong());
  EXPECT_FALSE(fall_.needsHint()) << "it lands above the start, from the other side";
  EXPECT_EQ(crossings(), EndlessFall::kLongCrossings);
  playUntil(0, 100, [&] { return stands(); });
  EXPECT_FALSE(fall_.isLong());
}

TEST_F(EndlessFallTest, TheRestartIsNeededAfterTheThirdLap) {
  begin(airLevel());
  playUntil(0, 3000, [&] { return fall_.needsRestart(); });
  EXPECT_EQ(crossings(), 12u) << "four faces a lap";
}

TEST_F(EndlessFallTest, AFallThatLandsIsNotToldHoweverLongItIs) {
  begin(airLevel(4, "-240 -100 240 -100"));
  const std::uint32_t ticks = playUntil(0, 1000, [&] { return stands() || fall_.needsHint(); });
  EXPECT_TRUE(stands());
  EXPECT_GT(ticks, 4 * EndlessFall::kPatience);
  EXPECT_EQ(crossings(), 3u);
}

// Without the key, this fall does not land.
TEST_F(EndlessFallTest, AFallThatLandsBecauseAKeyIsHeldIsNotTold) {
  begin(airLevel(3, "-100 -240 -100 240"));
  EXPECT_LT(playUntil(0, 100, [&] { return fall_.needsHint(); }), 100u);
  begin(airLevel(3, "-100 -240 -100 240"));
  playUntil(Input::kRight, 1000, [&] { return stands() || fall_.needsHint(); });
  EXPECT_TRUE(stands());
}

// With the key held, this fall does not land; for a while, it does when the player lets go.
TEST_F(EndlessFallTest, AFallThatLandsWithoutAKeyIsNotToldUntilItIsTooLate) {
  begin(airLevel(0, "-100 -240 -100 240"));
  EXPECT_GT(playUntil(Input::kRight, 1000, [&] { return stands() || fall_.needsHint(); }), 100u);
  EXPECT_TRUE(fall_.needsHint());
  EXPECT_LT(crossings(), 8u) << "before the second lap is over";
}

TEST_F(EndlessFallTest, TheHintGoesWhenAKeyIsPressedThatMakesTheFallLand) {
  begin(airLevel(4, "-100 -240 -100 240"));
  play(0, 90);
  ASSERT_TRUE(fall_.needsHint());
  EXPECT_LT(playUntil(Input::kRight, 100, [&] { return !fall_.needsHint(); }), 20u);
}

TEST_F(EndlessFallTest, TheHintGoesOnceThePlayerRestartsOrLeaves) {
  for (const Input end : {Input{Input::kPresent | Input::kRestart}, Input{}}) {
    begin(airLevel());
    play(0, 100);
    ASSERT_TRUE(fall_.needsHint());
    game_->advance(std::vector{end});
    fall_.observe(game_->tick(), *game_, 0);
    EXPECT_FALSE(fall_.needsHint()) << int{end.buttons};
  }
}

// Who has touched the goal may fall as it likes.
TEST_F(EndlessFallTest, WhoHasArrivedNeedsNoHint) {
  const LevelResult result = loadLevel("HEXAHEDRON\n0 0 0 0\n0 0 -60\n480\n%\n%\n%\n%\n%\n%\n");
  ASSERT_TRUE(result.level);
  begin(result.level);
  playUntil(0, 3000, [&] { return fall_.needsHint(); });
  EXPECT_EQ(game_->player(0).arrived, 1);
  EXPECT_GT(crossings(), 30u);
  EXPECT_FALSE(fall_.needsHint());
}

TEST_F(EndlessFallTest, ReplayedTicksAreIgnored) {
  begin(airLevel());
  play(0, 100);
  ASSERT_TRUE(fall_.needsHint());
  Game standing(flatLevel());
  for (int tick = 0; tick < 50; ++tick) standing.advance(inputs_);
  ASSERT_NE(standing.player(0).ground, Point());
  fall_.observe(game_->tick(), standing, 0);
  EXPECT_TRUE(fall_.needsHint());
  fall_.observe(game_->tick() + 1, standing, 0);
  EXPECT_FALSE(fall_.needsHint());
}

// A player who joins is observed late: what was before is not known.
TEST_F(EndlessFallTest, CountsFromTheFirstObservation) {
  begin(airLevel());
  for (int tick = 0; tick < 500; ++tick) game_->advance(inputs_);
  fall_ = {};
  play(0, EndlessFall::kPatience);
  EXPECT_FALSE(fall_.needsHint());
}

// "R: back to the start" showed during the falls of levels 26 and 32 that lead to the goal.
TEST(EndlessFallOnTheWays, TheHintNeverShowsOnARecordedWay) {
  for (const std::string& file : shippedLevels()) {
    const ShippedLevel shipped(file);
    ASSERT_TRUE(shipped.isRecordedAsItIs()) << file;
    Game game(shipped.level());
    std::vector<EndlessFall> falls(shipped.way().front().size());
    for (const std::vector<Input>& inputs : shipped.way()) {
      game.advance(inputs);
      for (std::uint32_t slot = 0; slot < falls.size(); ++slot) {
        falls[slot].observe(game.tick(), game, slot);
        ASSERT_FALSE(falls[slot].needsHint()) << file << ", tick " << game.tick();
      }
    }
  }
}

PlayerState startedAt(std::uint32_t tick) {
  PlayerState player;
  player.present = 1;
  player.startedAt = tick;
  return player;
}

PlayerState arrivedAt(std::uint32_t start, std::uint32_t best) {
  PlayerState player = startedAt(start);
  player.arrived = 1;
  player.finishTicks = best;
  return player;
}

TEST(AttemptTime, RunsFromTheFirstInput) {
  AttemptTime time;
  time.observe(40, startedAt(0));
  EXPECT_EQ(time.ticks(), 0u);
  time.observe(41, startedAt(41));
  EXPECT_EQ(time.ticks(), 1u);
  time.observe(141, startedAt(41));
  EXPECT_EQ(time.ticks(), 101u);
  EXPECT_FALSE(time.arrived());
}

TEST(AttemptTime, StandsStillAfterTheArrivalUntilARestart) {
  AttemptTime time;
  time.observe(50, startedAt(41));
  time.observe(60, arrivedAt(41, 20));
  time.observe(90, arrivedAt(41, 20));
  EXPECT_EQ(time.ticks(), 20u);
  EXPECT_TRUE(time.arrived());
  PlayerState again = startedAt(0);
  again.finishTicks = 20;
  time.observe(91, again);
  EXPECT_EQ(time.ticks(), 0u);
  EXPECT_FALSE(time.arrived());
}

TEST(AttemptTime, ASlowerAttemptKeepsItsOwnTime) {
  AttemptTime time;
  time.observe(60, arrivedAt(41, 20));
  PlayerState again = startedAt(100);
  again.finishTicks = 20;
  time.observe(120, again);
  time.observe(130, arrivedAt(100, 20));
  time.observe(160, arrivedAt(100, 20));
  EXPECT_EQ(time.ticks(), 31u);
}

// The state knows the exact time where the prediction learns of the arrival late.
TEST(AttemptTime, ANewBestTimeIsThatOfTheGame) {
  AttemptTime time;
  time.observe(60, startedAt(41));
  time.observe(64, arrivedAt(41, 20));
  EXPECT_EQ(time.ticks(), 20u);
}

TEST(AttemptTime, APlayerWhoRejoinsAtTheGoalHasItsBestTime) {
  AttemptTime time;
  time.observe(500, arrivedAt(41, 20));
  EXPECT_EQ(time.ticks(), 20u);
}

TEST(AttemptTime, ReplayedTicksAreIgnored) {
  AttemptTime time;
  time.observe(60, startedAt(41));
  time.observe(50, startedAt(0));
  EXPECT_EQ(time.ticks(), 20u);
}

TEST(AttemptTime, IsTheTimeOfTheGame) {
  Game game(flatLevel());
  AttemptTime time;
  const auto advance = [&](std::uint8_t buttons) {
    game.advance(std::vector{Input{static_cast<std::uint8_t>(Input::kPresent | buttons)}});
    time.observe(game.tick(), game.player(0));
  };
  for (int tick = 0; tick < 30; ++tick) advance(0);
  EXPECT_EQ(time.ticks(), 0u);
  while (!game.player(0).finished() && game.tick() < 1000) advance(Input::kRight);
  ASSERT_TRUE(game.player(0).finished());
  EXPECT_EQ(time.ticks(), game.player(0).finishTicks);
  for (int tick = 0; tick < 30; ++tick) advance(0);
  EXPECT_EQ(time.ticks(), game.player(0).finishTicks);
}

PlayerState falling() {
  PlayerState player;
  player.present = 1;
  return player;
}

PlayerState standing() {
  PlayerState player = falling();
  player.ground = {0, PlayerState::kUnit};
  return player;
}

// The player stands, falls from tick 10 on, and lands at tick `landing`.
void fall(PlayerFlashes& flashes, std::uint32_t slot, std::uint32_t landing) {
  for (std::uint32_t tick = 1; tick < 10; ++tick) flashes.observe(slot, tick, standing());
  for (std::uint32_t tick = 10; tick < landing; ++tick) flashes.observe(slot, tick, falling());
  flashes.observe(slot, landing, standing());
}

TEST(PlayerFlashes, ALandingFlashesAtItsTickAndFades) {
  PlayerFlashes flashes;
  fall(flashes, 3, 40);
  EXPECT_EQ(flashes.brightness(3, 39.9), 0);
  EXPECT_EQ(flashes.brightness(3, 40), 1);
  EXPECT_DOUBLE_EQ(flashes.brightness(3, 40 + PlayerFlashes::kTicks / 2.0), 0.5);
  EXPECT_EQ(flashes.brightness(3, 40 + PlayerFlashes::kTicks), 0);
  EXPECT_EQ(flashes.brightness(2, 40), 0);
  EXPECT_EQ(flashes.brightness(9, 40), 0);
}

TEST(PlayerFlashes, ReplayedTicksAreIgnored) {
  PlayerFlashes flashes;
  fall(flashes, 0, 40);
  for (std::uint32_t tick = 30; tick < 38; ++tick) flashes.observe(0, tick, falling());
  flashes.observe(0, 38, standing());  // the replay lands at another tick
  for (std::uint32_t tick = 39; tick < 60; ++tick) flashes.observe(0, tick, standing());
  EXPECT_EQ(flashes.brightness(0, 38), 0);
  EXPECT_EQ(flashes.brightness(0, 40), 1);
  EXPECT_EQ(flashes.brightness(0, 41), 1 - 1.0 / PlayerFlashes::kTicks);
}

TEST(PlayerFlashes, AShortFallDoesNotFlash) {
  PlayerFlashes flashes;
  fall(flashes, 0, 10 + PlayerFlashes::kMinAirTicks - 1);
  EXPECT_EQ(flashes.brightness(0, 10 + PlayerFlashes::kMinAirTicks - 1), 0);
  PlayerFlashes others;
  fall(others, 0, 10 + PlayerFlashes::kMinAirTicks);
  EXPECT_EQ(others.brightness(0, 10 + PlayerFlashes::kMinAirTicks), 1);
}

TEST(PlayerFlashes, AFinishFlashesOnce) {
  PlayerFlashes flashes;
  PlayerState player = standing();
  flashes.observe(0, 1, player);
  player.finishTicks = 1;
  for (std::uint32_t tick = 2; tick < 100; ++tick) flashes.observe(0, tick, player);
  EXPECT_EQ(flashes.brightness(0, 2), 1);
  EXPECT_EQ(flashes.brightness(0, 50), 0);
}

TEST(PlayerFlashes, AnEarlierFinishDoesNotFlash) {
  PlayerFlashes flashes;
  PlayerState player = standing();
  player.finishTicks = 1;
  for (std::uint32_t tick = 300; tick < 330; ++tick) flashes.observe(0, tick, player);
  for (std::uint32_t tick = 300; tick < 330; ++tick) EXPECT_EQ(flashes.brightness(0, tick), 0) << tick;
}

// A viewer behind the newest tick sees each flash later.
TEST(PlayerFlashes, EachShowsAtItsOwnTick) {
  PlayerFlashes flashes;
  std::uint32_t tick = 0;
  for (int landing = 0; landing < 3; ++landing) {
    for (std::uint32_t air = 0; air < PlayerFlashes::kMinAirTicks; ++air) flashes.observe(0, ++tick, falling());
    flashes.observe(0, ++tick, standing());
  }
  for (std::uint32_t landing = 1; landing <= 3; ++landing) {
    EXPECT_EQ(flashes.brightness(0, landing * (PlayerFlashes::kMinAirTicks + 1)), 1) << landing;
    EXPECT_EQ(flashes.brightness(0, landing * (PlayerFlashes::kMinAirTicks + 1) - 1), 0) << landing;
  }
}

// Two players of a level whose time they share: the first input starts it, and the first at the goal ends it.
TEST(TeamTime, ATeamStartsAndArrivesWithTheFirstOfThem) {
  Game game(cubeLevel("0 0 -180 0", {"-240 -200 240 -200\n-100 -200 -60 -200 plate 1"}, "0 100 -190"));
  AttemptTime team;
  AttemptTime other;
  std::uint32_t ticks = 0;
  const auto advance = [&](std::uint8_t first, std::uint8_t second) {
    const auto present = [](std::uint8_t buttons) {
      return Input{static_cast<std::uint8_t>(buttons | Input::kPresent)};
    };
    game.advance(std::vector<Input>{present(first), present(second)});
    team.observe(++ticks, teamOf(game));
    other.observe(ticks, game.player(1));
  };
  for (int tick = 0; tick < 30; ++tick) advance(0, 0);
  EXPECT_EQ(team.ticks(), 0U);
  for (int tick = 0; tick < 5; ++tick) advance(Input::kLeft, 0);
  EXPECT_EQ(team.ticks(), 5U);
  while (!team.arrived() && ticks < 300) advance(Input::kRight, 0);
  ASSERT_TRUE(team.arrived());
  EXPECT_EQ(team.ticks(), game.player(0).finishTicks);
  for (int tick = 0; tick < 9; ++tick) advance(0, Input::kLeft);
  EXPECT_EQ(team.ticks(), game.player(0).finishTicks) << "it stands still";
  EXPECT_FALSE(other.arrived());
}

}  // namespace
}  // namespace platon::player_watch_test
