#include "platon/game/recorded_run.h"

#include <gtest/gtest.h>

#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <tuple>
#include <variant>
#include <vector>

#include "tests/shared/game/forged_recording.h"
#include "tests/shared/game/played_game.h"
#include "tests/sim/seeded_random.h"
#include "tests/support/run/repetitions.h"

namespace platon::recorded_run_test {
namespace {

constexpr std::uint64_t kSeed = 45;
constexpr const char* kElsewhere = "is no run: its player does not begin at the start of the level, at rest";
constexpr const char* kOtherElsewhere =
    "is no run: another player, who can open doors, does not begin at the start of the level, at rest";
constexpr const char* kDoorsOpen = "is no run: doors are open at its beginning";
constexpr const char* kBefore = "is no run: its attempt began before the recording";
constexpr const char* kNoGoal = "is no run: it does not end with a player at the goal";

// The goal is on the floor to the right of the start.
std::shared_ptr<const Level> floorLevel() { return cubeLevel("0 0 -150 0", {"-240 -200 240 -200"}, "0 100 -190"); }

// A door between start and goal, and its key on the other side.
std::shared_ptr<const Level> doorLevel() {
  return cubeLevel("0 0 -180 0", {"-240 -200 240 -200\n60 -200 60 200 door 1\n-60 -200 -60 -150 key 1"}, "0 150 -190");
}

Input with(std::uint8_t buttons) { return {static_cast<std::uint8_t>(buttons | Input::kPresent)}; }

// Plays on from `start` with the inputs of each tick until somebody touches the goal, at most for 400 ticks.
std::variant<RunFinish, std::string> playToGoal(const Game& start,
                                                const std::function<std::vector<Input>(int)>& inputsOf) {
  RecordedRun run(start);
  Game game = start;
  Game before = start;
  const auto arrived = [](const Game& played) {
    for (std::uint32_t slot = 0; slot < played.slots(); ++slot) {
      if (played.player(slot).arrived != 0) return true;
    }
    return false;
  };
  for (int tick = 0; tick < 400 && (tick == 0 || !arrived(game)); ++tick) {
    const std::vector<Input> inputs = inputsOf(tick);
    before = game;
    game.advance(inputs);
    run.add(inputs);
  }
  return run.finish(before, game);
}

std::variant<RunFinish, std::string> runToGoal(const Game& start) {
  return playToGoal(start, [](int) { return std::vector{with(Input::kRight)}; });
}

std::string faultOf(const std::variant<RunFinish, std::string>& run) {
  return std::holds_alternative<std::string>(run) ? std::get<std::string>(run) : "none";
}

std::uint32_t ticksOf(const std::variant<RunFinish, std::string>& run) {
  return std::holds_alternative<RunFinish>(run) ? std::get<RunFinish>(run).ticks : 0;
}

Game atRest(const std::shared_ptr<const Level>& level, int ticks = 100) {
  PlayedGame played(level);
  played.run(ticks, kNone);
  return played.game;
}

TEST(LevelRest, KnowsEveryTickOfTheFallFromTheStart) {
  const auto level = floorLevel();
  const LevelRest rest(level);
  PlayedGame played(level);
  played.hold(1, kNone);
  played.hold(2, Input::kRight);
  played.advance();
  std::uint32_t ticks = 1;
  for (; played.player(1).ground == Point(); ++ticks, played.advance()) {
    ASSERT_EQ(rest.ticksTo(played.game, 1), ticks);
  }
  EXPECT_GT(ticks, 10U);
  played.advance(5000);
  EXPECT_TRUE(rest.ticksTo(played.game, 1));
  EXPECT_FALSE(rest.ticksTo(played.game, 0)) << "absent";
  EXPECT_FALSE(rest.ticksTo(played.game, 2)) << "moves";
  EXPECT_FALSE(rest.ticksTo(played.game, 3)) << "no slot";
}

TEST(LevelRest, WhoReturnsToTheStartLiesThereAgain) {
  const auto level = floorLevel();
  PlayedGame played(level);
  played.run(150, Input::kRight);
  ASSERT_NE(played.player().finishTicks, 0U);
  played.run(1, Input::kRestart);
  EXPECT_EQ(LevelRest(level).ticksTo(played.game, 0), 1U);
}

TEST(LevelRest, ThereIsOneWhereNobodyMeetsATimedSegment) {
  const auto beside = cubeLevel("0 0 -150 0", {"-240 -200 240 -200\n60 -200 60 200 timed 50 50"}, "0 150 -190");
  const auto below = cubeLevel("0 0 -100 0", {"-240 -200 240 -200\n-40 -150 40 -150 timed 50 50"}, "0 150 -190");
  for (const int ticks : {20, 60, 130}) {
    EXPECT_TRUE(LevelRest(beside).ticksTo(atRest(beside, ticks), 0)) << ticks;
    EXPECT_FALSE(LevelRest(below).ticksTo(atRest(below, ticks), 0)) << ticks;
  }
}

TEST(RecordedRun, AnAttemptFromTheStartIsARun) {
  const auto fresh = runToGoal(Game(floorLevel()));
  EXPECT_EQ(faultOf(fresh), "none");
  for (const int ticks : {1, 5, 100, 700}) EXPECT_EQ(faultOf(runToGoal(atRest(floorLevel(), ticks))), "none") << ticks;
  EXPECT_EQ(ticksOf(runToGoal(atRest(floorLevel(), 100))), ticksOf(runToGoal(atRest(floorLevel(), 700))));
}

TEST(RecordedRun, WithoutAnArrivalInTheLastTickThereIsNone) {
  EXPECT_EQ(faultOf(playToGoal(Game(floorLevel()), [](int) { return std::vector{with(Input::kLeft)}; })), kNoGoal);
}

TEST(RecordedRun, TheRunIsThatOfThePlayerWhoTouchesTheGoalInTheLastTick) {
  PlayedGame played(floorLevel());
  RecordedRun run(played.game);
  played.hold(0, Input::kRight);
  played.hold(1, Input::kLeft);
  int ticks = 0;
  const auto advance = [&] {
    played.advance();
    run.add(std::vector<Input>(2, with(kNone)));
    ++ticks;
  };
  do advance();
  while (played.player(0).arrived == 0);
  played.hold(1, Input::kRight);
  Game before = played.game;
  while (played.player(1).arrived == 0) {
    before = played.game;
    advance();
  }
  ASSERT_NE(played.player(0).arrived, 0U);
  const auto finish = run.finish(before, played.game);
  ASSERT_EQ(faultOf(finish), "none");
  EXPECT_EQ(std::get<RunFinish>(finish).slot, 1U);
  EXPECT_EQ(ticksOf(finish), static_cast<std::uint32_t>(ticks)) << "the attempt began with the recording";
  Game later(floorLevel());
  later.advance({});
  EXPECT_EQ(faultOf(RecordedRun(later).finish(before, played.game)), kBefore) << "and here before it";
}

TEST(RecordedRun, APlaceBesideTheGoalIsRefused) {
  ForgedState state(atRest(floorLevel()));
  state.entities[0].position.x = units(70);
  EXPECT_EQ(faultOf(runToGoal(state.game())), kElsewhere);
}

TEST(RecordedRun, AVelocityIsRefused) {
  ForgedState state(atRest(floorLevel()));
  state.players[0].velocity.x = 9000;
  EXPECT_EQ(faultOf(runToGoal(state.game())), kElsewhere);
}

TEST(RecordedRun, AClockThatRunsIsRefused) {
  ForgedState state(atRest(floorLevel()));
  state.players[0].startedAt = state.tick;
  EXPECT_EQ(faultOf(runToGoal(state.game())), kBefore);
}

// The player takes the key too, so that it reaches the goal with each of them.
TEST(RecordedRun, OpenDoorsAreRefused) {
  const auto overTheKey = [](int tick) { return std::vector{with(tick < 60 ? Input::kLeft : Input::kRight)}; };
  const Game honest = atRest(doorLevel());
  EXPECT_EQ(faultOf(playToGoal(honest, overTheKey)), "none");
  for (const auto field : {&ForgedState::keys, &ForgedState::plates}) {
    ForgedState state(honest);
    state.*field = honest.level().doorNumbers;
    EXPECT_EQ(faultOf(playToGoal(state.game(), overTheKey)), kDoorsOpen);
  }
}

// The start lies on a plate, or on a key, whose number is that of the door.
TEST(RecordedRun, APlateAtTheStartStandsForNoKeyAndAKeyForNoPlate) {
  const auto withAtStart = [](const std::string& element, const std::string& place) {
    return cubeLevel("0 0 -180 0",
                     {"-40 " + place + " 40 " + place + " " + element + "\n-240 -200 240 -200\n60 -200 60 200 door 1"},
                     "0 150 -190");
  };
  const Game onPlate = atRest(withAtStart("plate 1", "-200"));
  ASSERT_EQ(onPlate.pressedPlates(), 2U);
  EXPECT_EQ(faultOf(runToGoal(onPlate)), kNoGoal) << "the door closes behind the plate";
  ForgedState keys(onPlate);
  keys.keys = 2;
  EXPECT_EQ(faultOf(runToGoal(keys.game())), kDoorsOpen);

  const Game onKey = atRest(withAtStart("key 1", "-195"));
  ASSERT_EQ(onKey.takenKeys(), 2U);
  EXPECT_EQ(faultOf(runToGoal(onKey)), "none");
  ForgedState plates(onKey);
  plates.plates = 2;
  EXPECT_EQ(faultOf(runToGoal(plates.game())), kDoorsOpen);
}

// The only key is one that every player falls through.
TEST(RecordedRun, AKeyIsTakenNoEarlierThanByWhoPressesNothing) {
  const auto level =
      cubeLevel("0 0 -100 0", {"-40 -180 40 -180 key 1\n-240 -200 240 -200\n60 -200 60 200 door 1"}, "0 150 -190");
  const Game falling = atRest(level, 2);
  ASSERT_EQ(falling.takenKeys(), 0U);
  EXPECT_EQ(faultOf(runToGoal(falling)), "none");
  ForgedState early(falling);
  early.keys = 2;
  EXPECT_EQ(faultOf(runToGoal(early.game())), kDoorsOpen);
  EXPECT_EQ(faultOf(runToGoal(atRest(level))), "none") << "it has been taken on the way";
}

// A helper who begins beside the key.
TEST(RecordedRun, WhoCanOpenDoorsMustComeFromTheStartToo) {
  PlayedGame played(doorLevel());
  played.hold(1, kNone);
  played.run(100, kNone);
  const auto help = [](int tick) {
    return std::vector{with(tick < 40 ? kNone : Input::kRight), with(tick < 40 ? Input::kLeft : kNone)};
  };
  const auto honest = playToGoal(played.game, help);
  EXPECT_EQ(faultOf(honest), "none");
  EXPECT_GT(ticksOf(honest), 40U) << "timed from the first input of the helper";
  ForgedState state(played.game);
  state.entities[1].position.x = units(-45);
  EXPECT_EQ(faultOf(playToGoal(state.game(), help)), kOtherElsewhere);
}

// The game resets the keys at a restart, but not if somebody has begun in the same tick.
TEST(RecordedRun, WhoHasTakenAKeyAndRestartsAsTheAttemptBeginsMustComeFromTheStartToo) {
  PlayedGame played(doorLevel());
  played.hold(1, kNone);
  played.run(100, kNone);
  ForgedState state(played.game);
  state.entities[1].position.x = units(-60);  // at the key
  const auto asHelper = [](int tick) {
    return std::vector{with(tick < 2 ? kNone : Input::kRight), with(tick == 2 ? Input::kRestart : kNone)};
  };
  EXPECT_EQ(faultOf(playToGoal(played.game, asHelper)), kNoGoal) << "nobody opens the door";
  EXPECT_EQ(faultOf(playToGoal(state.game(), asHelper)), kOtherElsewhere);
  const auto asRunner = [](int tick) {
    const std::uint8_t restart = tick == 2 ? Input::kRestart : kNone;
    return std::vector{with(tick == 2 ? Input::kJump : kNone),
                       with(tick < 2 ? kNone : static_cast<std::uint8_t>(Input::kRight | restart))};
  };
  EXPECT_EQ(faultOf(playToGoal(played.game, asRunner)), kNoGoal);
  EXPECT_EQ(faultOf(playToGoal(state.game(), asRunner)), kElsewhere);
}

TEST(RecordedRun, WithoutDoorsItDoesNotMatterWhereOthersAre) {
  PlayedGame played(floorLevel());
  played.hold(1, Input::kLeft);
  played.run(100, kNone);
  const auto run = playToGoal(played.game, [](int) { return std::vector{with(Input::kRight), with(Input::kLeft)}; });
  EXPECT_EQ(faultOf(run), "none");
}

// The game itself puts these to the start.
TEST(RecordedRun, WhoRestartsOrJoinsLaterHasARun) {
  PlayedGame played(floorLevel());
  played.run(10, Input::kRight | Input::kJump);
  const auto after = [&](Input first) {
    return playToGoal(played.game, [&](int tick) { return std::vector{tick == 0 ? first : with(Input::kRight)}; });
  };
  EXPECT_EQ(faultOf(after(with(kNone))), kBefore);
  EXPECT_EQ(faultOf(after(with(Input::kRestart))), "none");
  EXPECT_EQ(faultOf(after({})), "none");
  played.run(1, Input::kRestart);
  played.run(10, Input::kRestart | Input::kRight);
  EXPECT_EQ(faultOf(after(with(Input::kRestart))), kBefore) << "a button that is held does not restart";
  const auto joined = playToGoal(played.game, [](int) { return std::vector{with(kNone), with(Input::kRight)}; });
  EXPECT_EQ(faultOf(joined), "none");
  EXPECT_EQ(ticksOf(joined), ticksOf(runToGoal(Game(floorLevel()))));
}

TEST(RecordedRun, AHeldRestartHidesNothing) {
  ForgedState state(atRest(floorLevel()));
  state.entities[0].position.x = units(60);
  state.players[0].held = Input::kPresent | Input::kRestart;
  const auto restart = [](int) { return std::vector{with(Input::kRight | Input::kRestart)}; };
  EXPECT_EQ(faultOf(playToGoal(state.game(), restart)), kElsewhere);
}

// An attempt of nobody would keep the doors open when the one who has opened them restarts. Nobody's entity that waits
// to be turned would fall towards the goal.
TEST(RecordedRun, AnAbsentPlayerHasNoAttemptAndNobodyWaitsToBeTurned) {
  PlayedGame played(doorLevel());
  played.hold(1, kNone);
  played.run(100, kNone);
  played.release(1);
  played.run(1, kNone);
  ForgedState attempt(played.game);
  ASSERT_NO_THROW(attempt.game());
  attempt.players[1].startedAt = 1;
  EXPECT_THROW(attempt.game(), std::invalid_argument);
  for (const std::size_t slot : {0U, 1U}) {
    ForgedState turn(played.game);
    turn.entities[slot].turn = 9000;
    EXPECT_THROW(turn.game(), std::invalid_argument) << slot;
  }
}

// The start is at an edge, so the ball is on two faces at once. An instance without a parent would stay for good, and
// touch keys and plates of its face from afar.
TEST(RecordedRun, AnInstanceThatComesFromNowhereIsRefused) {
  const Game honest = atRest(cubeLevel("0 -235 -180 0", {"-240 -200 240 -200"}, "0 100 -190"));
  EXPECT_EQ(faultOf(runToGoal(honest)), "none");
  ForgedState state(honest);
  ASSERT_EQ(state.instances.size(), 1U);
  ASSERT_NE(state.instances[0].parent, InstanceState::kNoParent);
  state.instances[0].parent = InstanceState::kNoParent;
  EXPECT_EQ(faultOf(runToGoal(state.game())), kElsewhere);
}

// The start is at an edge, and there is each kind of element that a player or a game remembers.
std::shared_ptr<const Level> elementLevel() {
  const std::string face = "-240 -200 240 -200\n0 -200 0 -100 key 2\n0 -180 20 -180 door 2";
  const std::string first =
      "-240 -200 240 -200\n60 -200 60 200 door 1\n-60 -200 -60 -150 key 1\n-240 -150 -100 -150 hazard\n"
      "0 -180 0 -160 checkpoint\n100 -198 120 -198 plate 2";
  return cubeLevel("0 -235 -180 0", {first, face, face, face}, "0 150 -190");
}

// Two players who come, go and press anything.
Game playedAtRandom(sim::SeededRandom& random) {
  PlayedGame played(elementLevel());
  for (std::uint64_t i = random.below(12); i > 0; --i) {
    for (const std::size_t slot : {0U, 1U}) played.hold(slot, static_cast<std::uint8_t>(random.below(64)));
    if (random.below(6) == 0) played.release(1);
    played.advance(static_cast<int>(random.below(40)));
  }
  return played.game;
}

// The game with some bytes of its state changed; nothing if that is no state.
std::optional<Game> changed(const Game& game, sim::SeededRandom& random) {
  std::vector<std::uint8_t> bytes = game.save();
  for (std::uint64_t edits = 1 + random.below(3); edits > 0; --edits) {
    std::uint8_t& byte = bytes[random.below(bytes.size())];
    byte = static_cast<std::uint8_t>(random.below(2) == 0 ? random.below(256) : byte ^ 1U << random.below(8));
  }
  Game forged = game;
  return forged.restore(bytes) ? std::optional(forged) : std::nullopt;
}

// Where the player of slot 0 is, how it moves, and what is open.
auto statusOf(const Game& game) {
  const EntityState& entity = game.world().entities()[0];
  const PlayerState& player = game.player(0);
  return std::tuple(entity.part, entity.position.x, entity.position.y, entity.angle.centidegrees(), player.velocity.x,
                    player.velocity.y, player.ground.x, player.ground.y, player.checkpoint, player.arrived,
                    game.takenKeys(), game.pressedPlates());
}

// All buttons are released first: one that is held already is not pressed again.
void expectSameFuture(Game one, Game other, sim::SeededRandom& random) {
  std::vector<Input> inputs{with(kNone)};
  for (int tick = 0; tick < 60; ++tick) {
    if (tick % 10 == 1) inputs[0] = with(static_cast<std::uint8_t>(random.below(32)));
    one.advance(inputs);
    other.advance(inputs);
    ASSERT_EQ(statusOf(one), statusOf(other)) << tick;
  }
}

// A recording may begin in any state, but not an attempt: who has restarted or joined is as in a new game.
TEST(RecordedRun, WhoeverRestartsOrJoinsBeginsAsInANewGameWhateverWasInvented) {
  sim::SeededRandom random(kSeed);
  Game fresh(elementLevel());
  fresh.advance(std::vector{with(Input::kRestart)});
  int tried = 0;
  for (int round = 0; round < repetitions(500); ++round) {
    const Game game = playedAtRandom(random);
    for (int i = 0; i < 10; ++i) {
      std::optional<Game> restarts = changed(game, random);
      if (!restarts) continue;
      ++tried;
      SCOPED_TRACE(round);
      Game joins = *restarts;
      joins.advance({});
      restarts->advance(std::vector{with(kNone)});
      for (Game* each : {&joins, &*restarts}) {
        each->advance(std::vector{with(Input::kRestart)});
        ASSERT_NO_FATAL_FAILURE(expectSameFuture(*each, fresh, random));
      }
    }
  }
  EXPECT_GT(tried, repetitions(500));
}

// Whoever is accepted as lying where one falls goes on as one who has fallen there.
TEST(RecordedRun, WhoeverIsFoundAtRestGoesOnAsOneWhoHasFallenThereWhateverWasInvented) {
  sim::SeededRandom random(kSeed);
  const auto level = elementLevel();
  const LevelRest rest(level);
  int tried = 0;
  for (int round = 0; round < repetitions(200); ++round) {
    const Game game = atRest(level, 1 + static_cast<int>(random.below(100)));
    for (int i = 0; i < 100; ++i) {
      const std::optional<Game> forged = changed(game, random);
      const auto ticks = forged ? rest.ticksTo(*forged, 0) : std::nullopt;
      if (!ticks || forged->openDoors() != 0) continue;
      ++tried;
      SCOPED_TRACE(round);
      ASSERT_NO_FATAL_FAILURE(expectSameFuture(*forged, atRest(level, static_cast<int>(*ticks)), random));
    }
  }
  EXPECT_GT(tried, repetitions(500));
}

// Whatever is invented of the beginning, a run is not shorter for it.
TEST(RecordedRun, NoChangedBitOfTheBeginningMakesItShorter) {
  const Game honest = atRest(floorLevel(), 20);
  const std::uint32_t ticks = ticksOf(runToGoal(honest));
  ASSERT_GT(ticks, 0U);
  int refused = 0;
  for (std::size_t bit = 0; bit < 8 * honest.save().size(); ++bit) {
    std::vector<std::uint8_t> bytes = honest.save();
    bytes[bit / 8] ^= static_cast<std::uint8_t>(1 << bit % 8);
    Game forged = honest;
    if (!forged.restore(bytes)) continue;
    const auto run = runToGoal(forged);
    if (std::holds_alternative<RunFinish>(run)) {
      EXPECT_GE(ticksOf(run), ticks) << bit;
    } else {
      ++refused;
    }
  }
  EXPECT_GT(refused, 50);
}

}  // namespace
}  // namespace platon::recorded_run_test
