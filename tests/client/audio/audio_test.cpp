#include "client/audio/audio.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/wait_until.h"

// On OpenAL's loopback device, which needs no sound card.
namespace platon::audio_test {
namespace {

TEST(Volumes, GainsGoFromSilenceToFull) {
  EXPECT_EQ(gainOf(0), 0);
  EXPECT_EQ(gainOf(50), 0.25);
  EXPECT_EQ(gainOf(100), 1);
}

constexpr SolidKind kA = SolidKind::kHexahedron;
constexpr SolidKind kB = SolidKind::kIcosahedron;
constexpr double kStep = 0.01;

void advance(MusicFade& fade, std::optional<SolidKind> solid, double seconds) {
  for (double time = 0; time < seconds - kStep / 2; time += kStep) fade.advance(solid, kStep);
}

TEST(MusicFade, TheFirstMusicFadesIn) {
  MusicFade fade;
  EXPECT_EQ(fade.gain(kA), 0);
  advance(fade, kA, MusicFade::kFadeSeconds / 2);
  EXPECT_NEAR(fade.gain(kA) * fade.gain(kA), 0.5, 1e-9);
  advance(fade, kA, MusicFade::kFadeSeconds);
  EXPECT_EQ(fade.gain(kA), 1);
}

TEST(MusicFade, AChangeOfSolidKeepsTheLoudness) {
  MusicFade fade;
  advance(fade, kA, 10);
  for (double time = 0; time < MusicFade::kFadeSeconds - kStep; time += kStep) {
    fade.advance(kB, kStep);
    ASSERT_NEAR(fade.gain(kA) * fade.gain(kA) + fade.gain(kB) * fade.gain(kB), 1, 1e-9);
  }
  fade.advance(kB, 1);
  EXPECT_EQ(fade.gain(kA), 0);
  EXPECT_EQ(fade.gain(kB), 1);
}

TEST(MusicFade, TheGoalMakesItSofterForAWhile) {
  MusicFade fade;
  advance(fade, kA, 10);
  fade.duck();
  advance(fade, kA, MusicFade::kAttackSeconds);
  EXPECT_NEAR(fade.gain(kA), MusicFade::kDuckGain, 1e-9);
  advance(fade, kA, MusicFade::kDuckSeconds - MusicFade::kAttackSeconds);
  EXPECT_NEAR(fade.gain(kA), MusicFade::kDuckGain, 0.02);
  advance(fade, kA, MusicFade::kReleaseSeconds + 2 * kStep);
  EXPECT_EQ(fade.gain(kA), 1);
}

TEST(MusicFade, NoStepOfTheGainIsAudible) {
  MusicFade fade;
  double before = 0;
  for (int i = 0; i < 3000; ++i) {
    if (i == 700) fade.duck();
    fade.advance(i < 1500 ? std::optional(kA) : std::nullopt, kStep);
    ASSERT_NEAR(fade.gain(kA), before, 0.03) << i;
    before = fade.gain(kA);
  }
}

constexpr double kFrame = 1.0 / 60;
constexpr std::size_t kFrameSamples = kSampleRate / 60;

double peak(const std::vector<float>& samples) {
  double peak = 0;
  for (const float sample : samples) peak = std::max(peak, double{std::abs(sample)});
  return peak;
}

class AudioTest : public testing::Test {
 protected:
  AudioTest() : audio_(&OpenalOutput::openLoopback) {}

  void SetUp() override {
    ASSERT_TRUE(waitUntil([this] {
      audio_.update({}, {}, 0);
      return audio_.output() != nullptr;
    }));
  }

  // The loudest sample of `frames` frames that all bring `frame`.
  double play(const SoundFrame& frame, int frames, const Volumes& volumes = {}) {
    double loudest = 0;
    for (int i = 0; i < frames; ++i) {
      audio_.update(frame, volumes, kFrame);
      loudest = std::max(loudest, peak(audio_.output()->render(kFrameSamples)));
    }
    return loudest;
  }

  Audio audio_;
};

TEST_F(AudioTest, PlaysACue) {
  EXPECT_EQ(play({}, 6), 0);
  play({.cues = {Cue{.sound = Sound::kLand}}}, 1);
  EXPECT_GT(play({}, 6), 0.05);
  play({}, 30);
  EXPECT_EQ(play({}, 30), 0);
}

TEST_F(AudioTest, RollsAsLongAsThePlayerDoes) {
  EXPECT_GT(play({.roll = 1}, 60), 0.02);
  play({}, 60);
  EXPECT_LT(play({}, 10), 1e-4);
}

TEST_F(AudioTest, PlaysTheMusicOfTheSolidOnceItIsMade) {
  const SoundFrame frame{.solid = SolidKind::kHexahedron};
  EXPECT_TRUE(waitUntil([&] { return play(frame, 1) > 0.02; }));
}

TEST_F(AudioTest, VolumesApplyAtOnce) {
  play({.cues = {Cue{.sound = Sound::kGoal}}, .roll = 1}, 30);
  EXPECT_GT(play({.roll = 1}, 6), 0.05);
  play({.roll = 1}, 3, {.effects = 0});
  EXPECT_LT(play({.roll = 1}, 3, {.effects = 0}), 1e-6);
  play({.roll = 1}, 3);
  EXPECT_GT(play({.roll = 1}, 6), 0.05);
  play({.roll = 1}, 3, {.all = 0});
  EXPECT_LT(play({.roll = 1}, 3, {.all = 0}), 1e-6);
}

TEST(Audio, WithoutADeviceThatIsSaidOnceAndNothingFails) {
  testing::internal::CaptureStderr();
  {
    std::atomic<bool> opened = false;
    Audio audio([&]() -> std::unique_ptr<OpenalOutput> {
      opened = true;
      return nullptr;
    });
    const SoundFrame frame{.cues = {Cue{}}, .roll = 1, .solid = SolidKind::kHexahedron};
    ASSERT_TRUE(waitUntil([&] { return opened.load(); }));
    for (int i = 0; i < 100; ++i) {
      audio.update(frame, {}, kFrame);
      audio.play(Sound::kMenuMove);
      waitUntil([] { return true; });
    }
    EXPECT_EQ(audio.output(), nullptr);
  }
  const std::string said = testing::internal::GetCapturedStderr();
  EXPECT_TRUE(said.empty() || said == "platon-client: no sound: there is no audio device\n") << said;
}

TEST(Audio, CanEndWhileItStarts) {
  for (int i = 0; i < 5; ++i) Audio audio(&OpenalOutput::openLoopback);
}

}  // namespace
}  // namespace platon::audio_test
