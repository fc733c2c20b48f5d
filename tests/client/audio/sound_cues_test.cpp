#include "client/audio/sound_cues.h"

#include <algorithm>
#include <map>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "client/netcode/prediction.h"
#include "tests/client/audio/observed_player.h"
#include "tests/support/test_level.h"

namespace platon::sound_cues_test {
namespace {

using testing::IsEmpty;

// Two players on one game, of whom the first one listens.
class Heard {
 public:
  explicit Heard(std::shared_ptr<const Level> level)
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
  Heard heard(endlessLevel());
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
  Heard heard(endlessLevel());
  heard.delay = 12;
  heard.play(0, Input::kJump, 12);
  EXPECT_EQ(heard.count(Sound::kJump), 0);
  heard.play(0, Input::kJump, 3);
  EXPECT_EQ(heard.count(Sound::kJump), 1);
}

TEST(SoundCues, RollingFollowsTheSpeedOnTheGround) {
  Heard heard(endlessLevel());
  EXPECT_EQ(heard.frame.roll, 0);
  heard.play(Input::kRight, 0, 30);
  EXPECT_NEAR(heard.frame.roll, 1, 0.01);
  heard.play(Input::kRight | Input::kCreep, 0, 30);
  EXPECT_NEAR(heard.frame.roll, 1 / 3.0, 0.01);
  heard.play(Input::kJump, 0, 3);
  EXPECT_EQ(heard.frame.roll, 0);
}

TEST(SoundCues, TheLocalPlayersGoalIsCelebrated) {
  Heard heard(flatLevel());
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
  Heard heard(endlessLevel());
  EXPECT_EQ(heard.frame.solid, SolidKind::kHexahedron);
}

TEST(SoundCues, TheLastSecondsOfARoundAreCounted) {
  Heard heard(endlessLevel());
  heard.play(0, 0, static_cast<int>(heard.game.ticksLeft()) - 1);
  EXPECT_EQ(heard.count(Sound::kCountdown), SoundCues::kRoundCountdown);
}

TEST(SoundCues, ARoundWithoutATimeLimitIsNotCounted) {
  Heard heard(endlessLevel());
  heard.timed = false;
  heard.play(0, 0, static_cast<int>(heard.game.ticksLeft()) + 60);
  EXPECT_EQ(heard.count(Sound::kCountdown), 0);
}

TEST(SoundCues, TheStartOfTheNextRoundIsCountedDown) {
  Heard heard(endlessLevel());
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
  Prediction prediction(Game(endlessLevel()), 0);
  const SolidMesh mesh(SolidKind::kHexahedron, 480);
  SoundCues cues;
  std::map<Sound, std::uint32_t> heard;
  for (std::uint32_t tick = 0; tick < kSeconds * kTicksPerSecond; ++tick) {
    prediction.predict(jumping(tick));
    if (tick >= kRoundTrip) {
      const std::uint32_t confirmed = tick - kRoundTrip;
      const Input late = jumping(confirmed - std::min(confirmed, confirmed / kTicksPerSecond % 4));
      prediction.confirm(std::span(&late, 1));
      prediction.reconcile(Moment(0));
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
