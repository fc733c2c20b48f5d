#include "client/audio/player_cues.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "platon/game/player_motion.h"
#include "tests/client/audio/observed_player.h"
#include "tests/support/test_level.h"

namespace platon::player_cues_test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

std::vector<Sound> soundsOf(const std::vector<Cue>& cues) {
  std::vector<Sound> sounds;
  for (const Cue& cue : cues) sounds.push_back(cue.sound);
  return sounds;
}

// A game of one player, whose cues are collected after every `every` ticks.
class Played {
 public:
  explicit Played(std::shared_ptr<const Level> level, std::uint32_t every = 1)
      : game(std::move(level)), mesh(game.level().solid, game.level().faceSize), every_(every) {
    hold(0, 60);  // falls to the floor
    heard.clear();
  }

  void hold(std::uint8_t buttons, int ticks) {
    const Input input{static_cast<std::uint8_t>(buttons | Input::kPresent)};
    for (int i = 0; i < ticks; ++i) {
      game.advance(std::span(&input, 1));
      if (game.tick() % every_ != 0) continue;
      for (const Cue& cue : cues.observe(observe(game, 0, mesh))) heard.push_back(cue);
    }
  }

  Game game;
  SolidMesh mesh;
  PlayerCues cues;
  std::vector<Cue> heard;

 private:
  std::uint32_t every_;
};

TEST(PlayerCues, AJumpAndItsLanding) {
  for (const std::uint32_t every : {1u, 2u, 3u}) {
    Played played(endlessLevel(), every);
    played.hold(Input::kJump, 60);
    EXPECT_THAT(soundsOf(played.heard), ElementsAre(Sound::kJump, Sound::kLand)) << every;
  }
}

TEST(PlayerCues, AShortPressIsHeardAsAJump) {
  for (const std::uint32_t every : {1u, 2u, 3u}) {
    Played played(endlessLevel(), every);
    played.hold(Input::kJump, 1);
    played.hold(0, 30);
    ASSERT_FALSE(played.heard.empty()) << every;
    EXPECT_EQ(played.heard.front().sound, Sound::kJump) << every;
  }
}

TEST(PlayerCues, NeitherRunningNorStandingIsACue) {
  Played played(endlessLevel());
  played.hold(Input::kRight, 30);
  played.hold(0, 30);
  EXPECT_THAT(played.heard, IsEmpty());
}

TEST(PlayerCues, AHarderLandingIsLouderAndDeeper) {
  const auto land = [](std::int32_t speed) {
    PlayerCues cues;
    ObservedPlayer player;
    player.ticks = 1;
    player.state.present = 1;
    player.state.velocity.y = -speed;
    cues.observe(player);
    player.ticks = 2;
    player.state.ground = Point(0, PlayerState::kUnit);
    return cues.observe(player);
  };
  EXPECT_THAT(land(PlayerCues::kSoftLanding - 1), IsEmpty());
  const Cue soft = land(PlayerCues::kSoftLanding).front();
  const Cue hard = land(motion::kFallSpeed).front();
  EXPECT_EQ(soft.gain, 0.25);
  EXPECT_EQ(hard.gain, 1);
  EXPECT_GT(soft.pitch, hard.pitch);
  EXPECT_EQ(land(motion::kFastFallSpeed).front().gain, 1);
}

TEST(PlayerCues, ARestartIsNoHazard) {
  Played played(endlessLevel());
  played.hold(Input::kRight, 20);
  played.hold(Input::kRestart, 2);
  EXPECT_THAT(soundsOf(played.heard), ElementsAre(Sound::kRestart));
}

TEST(PlayerCues, AHazardAndACheckpoint) {
  for (const std::uint32_t every : {1u, 2u}) {
    Played played(cubeWith("-110 -200 -110 -140 checkpoint\n-60 -190 -40 -190 hazard\n"), every);
    played.hold(Input::kRight, 25);
    EXPECT_EQ(soundsOf(played.heard).front(), Sound::kCheckpoint) << every;
    played.hold(Input::kRight, 10);
    EXPECT_EQ(std::ranges::count(soundsOf(played.heard), Sound::kHazard), 1) << every;
    EXPECT_EQ(std::ranges::count(soundsOf(played.heard), Sound::kRestart), 0) << every;
  }
}

TEST(PlayerCues, TheGoalSoundsOnceAnAttempt) {
  Played played(flatLevel());
  played.hold(Input::kRight, 90);
  EXPECT_EQ(std::ranges::count(soundsOf(played.heard), Sound::kGoal), 1);
  played.hold(Input::kLeft, 30);
  EXPECT_EQ(std::ranges::count(soundsOf(played.heard), Sound::kGoal), 1);
  played.hold(Input::kRestart, 1);
  played.hold(Input::kRight, 120);
  EXPECT_EQ(std::ranges::count(soundsOf(played.heard), Sound::kGoal), 2);
}

// Sideways over a vertical edge, down keeps its direction in space.
TEST(PlayerCues, ACrossingToTheSideHasTheMiddlePitch) {
  Played played(endlessLevel());
  played.hold(Input::kRight, 160);
  ASSERT_THAT(soundsOf(played.heard), ElementsAre(Sound::kEdge));
  EXPECT_EQ(played.heard.front().pitch, 1);
}

TEST(PlayerCues, ACrossingUpwardsIsHigherThanOneDownwards) {
  const SolidMesh cube(SolidKind::kHexahedron, 480);
  const int above = cube.solid().neighbour(0, 2).face;
  const int below = cube.solid().neighbour(0, 0).face;
  const Pose here = cube.pose(0, {0, 0}, 0);
  EXPECT_DOUBLE_EQ(PlayerCues::crossingPitch(here, cube.pose(above, {0, 0}, 0)), std::pow(2, 7 / 12.0));
  EXPECT_DOUBLE_EQ(PlayerCues::crossingPitch(here, cube.pose(below, {0, 0}, 0)), std::pow(2, -8 / 12.0));
  EXPECT_EQ(PlayerCues::crossingPitch(here, here), 1);
}

TEST(PlayerCues, ReplayedTicksRepeatNoCue) {
  Played played(endlessLevel());
  const Game before = played.game;
  played.hold(Input::kJump, 5);
  ASSERT_THAT(soundsOf(played.heard), ElementsAre(Sound::kJump));
  played.game = before;
  played.hold(Input::kJump, 30);
  EXPECT_THAT(soundsOf(played.heard), ElementsAre(Sound::kJump));
}

// Reconciliation shows the jump anew, a few ticks later, after the first one was heard.
TEST(PlayerCues, AJumpThatIsPredictedAnewLaterSoundsOnce) {
  for (int late = 1; late <= 6; ++late) {
    Played played(endlessLevel());
    Game other = played.game;
    played.hold(Input::kJump, 8);
    const Input still{Input::kPresent};
    const Input jump{Input::kJump | Input::kPresent};
    for (int i = 0; i < 8; ++i) other.advance(std::span(i < late ? &still : &jump, 1));
    played.game = other;
    played.hold(Input::kJump, 6);
    EXPECT_THAT(soundsOf(played.heard), ElementsAre(Sound::kJump)) << late;
  }
}

TEST(PlayerCues, ACrossingThatIsTakenBackAndPredictedAnewSoundsOnce) {
  Played played(endlessLevel());
  std::vector<ObservedPlayer> states;
  while (played.heard.empty()) {
    played.hold(Input::kRight, 1);
    states.push_back(observe(played.game, 0, played.mesh));
  }
  ASSERT_THAT(soundsOf(played.heard), ElementsAre(Sound::kEdge));
  const ObservedPlayer behind = states.back();
  std::uint32_t ticks = behind.ticks;
  for (ObservedPlayer player : {states[states.size() - 3], states[states.size() - 2], behind}) {
    player.ticks = ++ticks;
    EXPECT_THAT(played.cues.observe(player), IsEmpty());
  }
}

TEST(PlayerCues, WhoAppearsMakesNoSound) {
  PlayerCues cues;
  ObservedPlayer player;
  player.ticks = 5;
  EXPECT_THAT(cues.observe(player), IsEmpty());
  player.ticks = 6;
  player.state.present = player.state.arrived = player.state.jumping = 1;
  player.entity.part = 3;
  player.entity.id = 9;
  EXPECT_THAT(cues.observe(player), IsEmpty());
}

}  // namespace
}  // namespace platon::player_cues_test
