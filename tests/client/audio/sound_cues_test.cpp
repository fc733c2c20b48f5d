#include "client/audio/sound_cues.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "client/netcode/prediction.h"
#include "platon/game/player_motion.h"
#include "tests/client/audio/observed_player.h"
#include "tests/support/test_levels.h"

namespace platon::sound_cues_test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

// Looks at the face from outside: right is +x.
const Pose kListener{{10, 20, 100}, {0, 1, 0}, {0, 0, 1}};

TEST(Hearing, OnesOwnSoundIsFullAndInTheMiddle) {
  const Heard heard = hear(kListener, kListener.position);
  EXPECT_EQ(heard.gain, 1);
  EXPECT_EQ(heard.pan, 0);
}

TEST(Hearing, TheGainFallsWithTheDistance) {
  const auto gainAt = [](double distance) {
    return hear(kListener, kListener.position + glm::dvec3(0, 0, -distance)).gain;
  };
  EXPECT_EQ(gainAt(kHalfGainDistance), 0.5);
  double before = 1;
  for (double distance = 10; distance < 2000; distance += 10) {
    EXPECT_LT(gainAt(distance), before);
    before = gainAt(distance);
  }
}

TEST(Hearing, ThePlayersRightIsOnTheRight) {
  EXPECT_EQ(hear(kListener, {10 + kFullPanDistance / 2, 20, 100}).pan, 0.5);
  EXPECT_EQ(hear(kListener, {10 - kFullPanDistance / 2, 20, 100}).pan, -0.5);
  EXPECT_EQ(hear(kListener, {10 + 9 * kFullPanDistance, 20, 100}).pan, 1);
  EXPECT_EQ(hear(kListener, {10, 500, 100}).pan, 0);
  Pose upsideDown = kListener;
  upsideDown.up = {0, -1, 0};
  EXPECT_EQ(hear(upsideDown, {10 + kFullPanDistance / 2, 20, 100}).pan, -0.5);
}

TEST(RepeatFilter, AnEventPassesAgainOnlyAfterTheTime) {
  RepeatFilter filter;
  EXPECT_TRUE(filter.passes(1, 100, 10));
  EXPECT_FALSE(filter.passes(1, 101, 10));
  EXPECT_FALSE(filter.passes(1, 109, 10));
  EXPECT_TRUE(filter.passes(1, 110, 10));
}

TEST(RepeatFilter, KeysDoNotAffectEachOther) {
  RepeatFilter filter;
  EXPECT_TRUE(filter.passes(1, 0, 10));
  EXPECT_TRUE(filter.passes(2, 0, 10));
  EXPECT_FALSE(filter.passes(2, 1, 10));
}

constexpr Sound kNone = Sound::kRoll;

class PlayedElements {
 public:
  explicit PlayedElements(const std::string& segments) : game(cubeWith(segments)), mesh(SolidKind::kHexahedron, 480) {
    landing = hold(0, 60);
  }

  std::vector<Cue> hold(std::uint8_t buttons, int ticks) {
    std::vector<Cue> heard;
    const Input input{static_cast<std::uint8_t>(buttons | Input::kPresent)};
    for (int i = 0; i < ticks; ++i) {
      game.advance(std::span(&input, 1));
      for (const Cue& cue : observeNow()) heard.push_back(cue);
    }
    return heard;
  }
  std::vector<Cue> observeNow() { return cues.observe(game, game.tick(), mesh, poseOf(game, 0, mesh)); }

  Game game;
  SolidMesh mesh;
  ElementCues cues;
  std::vector<Cue> landing;  // the first second
};

Sound soundAt(const std::vector<Cue>& cues, std::size_t i) { return i < cues.size() ? cues[i].sound : kNone; }

TEST(ElementCues, AKeyAndItsDoorSoundTogether) {
  PlayedElements played("-100 -190 -90 -190 key 1\n200 -200 200 -100 door 1\n");
  const std::vector<Cue> heard = played.hold(Input::kRight, 30);
  ASSERT_EQ(heard.size(), 2u);
  EXPECT_EQ(soundAt(heard, 0), Sound::kKey);
  EXPECT_EQ(soundAt(heard, 1), Sound::kDoorOpens);
  EXPECT_GT(heard[0].gain, heard[1].gain);
  EXPECT_GT(heard[1].pan, 0.3);
}

TEST(ElementCues, ANumberSoundsOnceFromTheNearest) {
  PlayedElements near("-100 -190 -90 -190 key 1\n100 -200 100 -100 door 1\n200 -200 200 -100 door 1\n");
  const std::vector<Cue> heard = near.hold(Input::kRight, 30);
  ASSERT_EQ(heard.size(), 2u);
  PlayedElements alone("-100 -190 -90 -190 key 1\n100 -200 100 -100 door 1\n");
  EXPECT_EQ(heard[1].gain, alone.hold(Input::kRight, 30).at(1).gain);
}

TEST(ElementCues, APlateSoundsWhenItIsSteppedOnAndWhenItIsLeft) {
  PlayedElements played("-200 -190 -100 -190 plate 2\n200 -200 200 -100 door 2\n");
  ASSERT_EQ(played.landing.size(), 2u);
  EXPECT_EQ(soundAt(played.landing, 0), Sound::kPlateDown);
  EXPECT_EQ(soundAt(played.landing, 1), Sound::kDoorOpens);
  const std::vector<Cue> off = played.hold(Input::kRight, 40);
  ASSERT_EQ(off.size(), 2u);
  EXPECT_EQ(soundAt(off, 0), Sound::kPlateUp);
  EXPECT_EQ(soundAt(off, 1), Sound::kDoorCloses);
}

TEST(ElementCues, WhatIsTakenBackAndPredictedAnewSoundsOnce) {
  PlayedElements played("-100 -190 -90 -190 key 1\n200 -200 200 -100 door 1\n");
  const Game before = played.game;
  EXPECT_EQ(played.hold(Input::kRight, 30).size(), 2u);
  const Game after = played.game;
  EXPECT_THAT(played.cues.observe(before, after.tick() + 1, played.mesh, Pose()),
              testing::Each(testing::Field(&Cue::sound, Sound::kDoorCloses)));
  EXPECT_THAT(played.cues.observe(after, after.tick() + 3, played.mesh, Pose()), IsEmpty());
}

TEST(ElementCues, ReplayedTicksAndTheFirstStateAreSilent) {
  PlayedElements played("-100 -190 -90 -190 key 1\n200 -200 200 -100 door 1\n");
  const std::vector<Cue> heard = played.hold(Input::kRight, 30);
  EXPECT_EQ(heard.size(), 2u);
  EXPECT_THAT(played.observeNow(), IsEmpty());
  ElementCues later;
  EXPECT_THAT(later.observe(played.game, 7, played.mesh, Pose()), IsEmpty());
}

std::vector<Sound> soundsOf(const std::vector<Cue>& cues) {
  std::vector<Sound> sounds;
  for (const Cue& cue : cues) sounds.push_back(cue.sound);
  return sounds;
}

// A game of one player, whose cues are collected after every `every` ticks.
class PlayedAlone {
 public:
  explicit PlayedAlone(std::shared_ptr<const Level> level, std::uint32_t every = 1)
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
    PlayedAlone played(endlessLevel(), every);
    played.hold(Input::kJump, 60);
    EXPECT_THAT(soundsOf(played.heard), ElementsAre(Sound::kJump, Sound::kLand)) << every;
  }
}

TEST(PlayerCues, AShortPressIsHeardAsAJump) {
  for (const std::uint32_t every : {1u, 2u, 3u}) {
    PlayedAlone played(endlessLevel(), every);
    played.hold(Input::kJump, 1);
    played.hold(0, 30);
    ASSERT_FALSE(played.heard.empty()) << every;
    EXPECT_EQ(played.heard.front().sound, Sound::kJump) << every;
  }
}

TEST(PlayerCues, NeitherRunningNorStandingIsACue) {
  PlayedAlone played(endlessLevel());
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
  PlayedAlone played(endlessLevel());
  played.hold(Input::kRight, 20);
  played.hold(Input::kRestart, 2);
  EXPECT_THAT(soundsOf(played.heard), ElementsAre(Sound::kRestart));
}

TEST(PlayerCues, AHazardAndACheckpoint) {
  for (const std::uint32_t every : {1u, 2u}) {
    PlayedAlone played(cubeWith("-110 -200 -110 -140 checkpoint\n-60 -190 -40 -190 hazard\n"), every);
    played.hold(Input::kRight, 25);
    EXPECT_EQ(soundsOf(played.heard).front(), Sound::kCheckpoint) << every;
    played.hold(Input::kRight, 10);
    EXPECT_EQ(std::ranges::count(soundsOf(played.heard), Sound::kHazard), 1) << every;
    EXPECT_EQ(std::ranges::count(soundsOf(played.heard), Sound::kRestart), 0) << every;
  }
}

TEST(PlayerCues, TheGoalSoundsOnceAnAttempt) {
  PlayedAlone played(flatLevel());
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
  PlayedAlone played(endlessLevel());
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
  PlayedAlone played(endlessLevel());
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
    PlayedAlone played(endlessLevel());
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
  PlayedAlone played(endlessLevel());
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

// Two players on one game, of whom the first one listens.
class TwoPlayers {
 public:
  explicit TwoPlayers(std::shared_ptr<const Level> level)
      : game(std::move(level)), mesh(game.level().solid, game.level().faceSize) {
    play(0, 0, 60);
    cues.clear();
  }

  void play(std::uint8_t own, std::uint8_t other, int ticks) {
    const std::vector<Input> inputs{{static_cast<std::uint8_t>(own | Input::kPresent)},
                                    {static_cast<std::uint8_t>(other | Input::kPresent)}};
    for (int i = 0; i < ticks; ++i) {
      game.advance(inputs);
      hear();
    }
  }

  void hear() {
    CueSource source;
    source.round = round;
    source.mesh = &mesh;
    source.predicted = source.confirmed = &game;
    source.predictedTicks = source.confirmedTicks = game.tick();
    source.othersTick = game.tick() - delay;
    source.over = over;
    source.timed = timed;
    source.nextRoundSeconds = nextRoundSeconds;
    frame = decide.update(&source);
    cues.insert(cues.end(), frame.cues.begin(), frame.cues.end());
  }

  std::ptrdiff_t count(Sound sound) const {
    return std::ranges::count_if(cues, [&](const Cue& cue) { return cue.sound == sound; });
  }

  Game game;
  SolidMesh mesh;
  SoundCues decide;
  std::uint32_t round = 1;
  double delay = 0;
  bool over = false;
  bool timed = true;
  std::optional<double> nextRoundSeconds;
  SoundFrame frame;
  std::vector<Cue> cues;
};

TEST(SoundCues, WithoutARoundNothingIsHeard) {
  SoundCues cues;
  const SoundFrame frame = cues.update(nullptr);
  EXPECT_THAT(frame.cues, IsEmpty());
  EXPECT_EQ(frame.roll, 0);
  EXPECT_FALSE(frame.solid.has_value());
}

TEST(SoundCues, OthersAreSofterAndBySide) {
  TwoPlayers heard(endlessLevel());
  heard.play(0, Input::kRight, 60);
  heard.cues.clear();
  heard.play(Input::kJump, Input::kJump, 4);
  ASSERT_EQ(heard.cues.size(), 2u);
  const Cue& own = heard.cues[0];
  const Cue& other = heard.cues[1];
  EXPECT_EQ(own.slot, 0u);
  EXPECT_EQ(own.gain, 1);
  EXPECT_EQ(own.pan, 0);
  EXPECT_EQ(other.slot, 1u);
  EXPECT_LT(other.gain, SoundCues::kOthersGain);
  EXPECT_GT(other.pan, 0);
}

TEST(SoundCues, OthersAreHeardWhenTheyAreDrawn) {
  TwoPlayers heard(endlessLevel());
  heard.delay = 12;
  heard.play(0, Input::kJump, 12);
  EXPECT_EQ(heard.count(Sound::kJump), 0);
  heard.play(0, Input::kJump, 3);
  EXPECT_EQ(heard.count(Sound::kJump), 1);
}

TEST(SoundCues, RollingFollowsTheSpeedOnTheGround) {
  TwoPlayers heard(endlessLevel());
  EXPECT_EQ(heard.frame.roll, 0);
  heard.play(Input::kRight, 0, 30);
  EXPECT_NEAR(heard.frame.roll, 1, 0.01);
  heard.play(Input::kRight | Input::kCreep, 0, 30);
  EXPECT_NEAR(heard.frame.roll, 1 / 3.0, 0.01);
  heard.play(Input::kJump, 0, 3);
  EXPECT_EQ(heard.frame.roll, 0);
}

TEST(SoundCues, TheLocalPlayersGoalIsCelebrated) {
  TwoPlayers heard(flatLevel());
  heard.play(0, Input::kRight, 100);
  EXPECT_EQ(heard.count(Sound::kGoal), 1);
  bool celebrated = false;
  for (int i = 0; i < 100; ++i) {
    heard.play(Input::kRight, 0, 1);
    celebrated = celebrated || heard.frame.celebrates;
  }
  EXPECT_EQ(heard.count(Sound::kGoal), 2);
  EXPECT_TRUE(celebrated);
}

TEST(SoundCues, TheMoodIsThatOfTheSolid) {
  TwoPlayers heard(endlessLevel());
  EXPECT_EQ(heard.frame.solid, SolidKind::kHexahedron);
}

TEST(SoundCues, TheLastSecondsOfARoundAreCounted) {
  TwoPlayers heard(endlessLevel());
  heard.play(0, 0, static_cast<int>(heard.game.ticksLeft()) - 1);
  EXPECT_EQ(heard.count(Sound::kCountdown), SoundCues::kRoundCountdown);
}

TEST(SoundCues, ARoundWithoutATimeLimitIsNotCounted) {
  TwoPlayers heard(endlessLevel());
  heard.timed = false;
  heard.play(0, 0, static_cast<int>(heard.game.ticksLeft()) + 60);
  EXPECT_EQ(heard.count(Sound::kCountdown), 0);
}

TEST(SoundCues, TheStartOfTheNextRoundIsCountedDown) {
  TwoPlayers heard(endlessLevel());
  heard.over = true;
  for (int tenths = 50; tenths > 0; --tenths) {
    heard.nextRoundSeconds = tenths / 10.0;
    heard.hear();
  }
  EXPECT_EQ(heard.count(Sound::kCountdown), SoundCues::kNextCountdown);
  EXPECT_EQ(heard.count(Sound::kRoundStart), 0);
  heard.round = 2;
  heard.over = false;
  heard.hear();
  EXPECT_EQ(heard.count(Sound::kRoundStart), 1);
  heard.hear();
  EXPECT_EQ(heard.count(Sound::kRoundStart), 1);
}

// A jump in each second.
Input jumping(std::uint32_t tick) {
  const bool jumps = tick % kTicksPerSecond >= 30 && tick % kTicksPerSecond < 40;
  return {static_cast<std::uint8_t>(Input::kPresent | (jumps ? Input::kJump : 0))};
}

// The server decides every input up to three ticks late, and confirms it long after it was heard.
TEST(SoundCues, ReconciliationRepeatsNoCue) {
  constexpr std::uint32_t kSeconds = 60;
  constexpr std::uint32_t kRoundTrip = 15;
  Prediction prediction(Game(endlessLevel()), {0});
  const SolidMesh mesh(SolidKind::kHexahedron, 480);
  SoundCues cues;
  std::map<Sound, std::uint32_t> heard;
  for (std::uint32_t tick = 0; tick < kSeconds * kTicksPerSecond; ++tick) {
    prediction.predict({jumping(tick)});
    if (tick >= kRoundTrip) {
      const std::uint32_t confirmed = tick - kRoundTrip;
      const Input late = jumping(confirmed - std::min(confirmed, confirmed / kTicksPerSecond % 4));
      prediction.confirm(std::span(&late, 1));
      prediction.reconcile(Time(0));
    }
    CueSource source;
    source.mesh = &mesh;
    source.predicted = &prediction.predicted();
    source.predictedTicks = prediction.predictedTicks();
    source.confirmed = &prediction.confirmed();
    source.confirmedTicks = prediction.confirmedTicks();
    for (const Cue& cue : cues.update(&source).cues) ++heard[cue.sound];
  }
  EXPECT_GT(prediction.statistics().missedInputs, kSeconds / 2);
  EXPECT_EQ(heard[Sound::kJump], kSeconds);
  EXPECT_EQ(heard[Sound::kLand], kSeconds);  // with that on the floor at the start, without that of the last jump
  EXPECT_EQ(heard.size(), 2u);
}

}  // namespace
}  // namespace platon::sound_cues_test
