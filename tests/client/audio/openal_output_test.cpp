#include "client/audio/openal_output.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include <gtest/gtest.h>

#include "client/audio/music.h"
#include "client/audio/sounds.h"

// On OpenAL's loopback device, which needs no sound card.
namespace platon::openal_output_test {
namespace {

using Group = OpenalOutput::Group;

// Loudness of a channel: root mean square, full scale is 1.
double loudness(const std::vector<float>& samples, std::size_t channel) {
  double squares = 0;
  for (std::size_t i = channel; i < samples.size(); i += 2) squares += double{1} * samples[i] * samples[i];
  return std::sqrt(squares / (static_cast<double>(samples.size()) / 2));
}

double peak(const std::vector<float>& samples) {
  double peak = 0;
  for (const float sample : samples) peak = std::max(peak, double{std::abs(sample)});
  return peak;
}

class OpenalOutputTest : public testing::Test {
 protected:
  void SetUp() override { ASSERT_NE(output_, nullptr); }

  std::unique_ptr<OpenalOutput> output_ = OpenalOutput::openLoopback();
};

TEST_F(OpenalOutputTest, IsSilentUntilASoundIsPlayed) {
  EXPECT_EQ(peak(output_->render(4800)), 0);
  output_->play(output_->addBuffer(makeSound(Sound::kGoal)), 1, 0, 1);
  EXPECT_GT(peak(output_->render(4800)), 0.05);
}

TEST_F(OpenalOutputTest, ASoundEndsAndFreesItsSource) {
  output_->play(output_->addBuffer(makeSound(Sound::kJump)), 1, 0, 1);
  EXPECT_EQ(output_->sounding(), 1u);
  output_->render(kSampleRate);
  EXPECT_EQ(output_->sounding(), 0u);
  EXPECT_EQ(peak(output_->render(4800)), 0);
}

TEST_F(OpenalOutputTest, ThePanIsHeard) {
  const OpenalOutput::Buffer buffer = output_->addBuffer(makeSound(Sound::kLand));
  output_->play(buffer, 1, -1, 1);
  const std::vector<float> left = output_->render(kSampleRate);
  output_->play(buffer, 1, 0, 1);
  const std::vector<float> middle = output_->render(kSampleRate);
  output_->play(buffer, 1, 1, 1);
  const std::vector<float> right = output_->render(kSampleRate);
  EXPECT_GT(loudness(left, 0), 10 * loudness(left, 1));
  EXPECT_NEAR(loudness(middle, 0), loudness(middle, 1), 1e-4);
  EXPECT_GT(loudness(right, 1), 10 * loudness(right, 0));
}

TEST_F(OpenalOutputTest, ThePitchChangesTheLength) {
  const OpenalOutput::Buffer buffer = output_->addBuffer(makeSound(Sound::kJump));
  output_->play(buffer, 1, 0, 0.5);
  output_->render(24000);
  EXPECT_EQ(output_->sounding(), 1u);
  output_->play(buffer, 1, 0, 2);
  output_->render(14400);
  EXPECT_EQ(output_->sounding(), 0u);
}

TEST_F(OpenalOutputTest, TooManySoundsAreLeftOut) {
  const OpenalOutput::Buffer buffer = output_->addBuffer(makeSound(Sound::kGoal));
  for (int i = 0; i < 100; ++i) output_->play(buffer, 0.01, 0, 1);
  EXPECT_EQ(output_->sounding(), OpenalOutput::kSources - OpenalOutput::kMaxLoops);
}

TEST_F(OpenalOutputTest, ALoopRepeatsWithoutEnd) {
  const OpenalOutput::Loop loop = output_->startLoop(output_->addBuffer(makeSound(Sound::kRoll)), Group::kEffects);
  EXPECT_EQ(peak(output_->render(4800)), 0);
  output_->setLoop(loop, 1, 1);
  for (int second = 0; second < 8; ++second) EXPECT_GT(loudness(output_->render(kSampleRate), 0), 0.01) << second;
}

TEST_F(OpenalOutputTest, AGroupIsMutedAtOnce) {
  const OpenalOutput::Loop music =
      output_->startLoop(output_->addBuffer(makeMusic(SolidKind::kHexahedron)), Group::kMusic);
  output_->setLoop(music, 1, 1);
  output_->setGain(Group::kEffects, 0);
  EXPECT_GT(loudness(output_->render(kSampleRate), 0), 0.01);
  output_->setGain(Group::kMusic, 0);
  output_->render(4800);  // OpenAL lets a gain fall over some milliseconds, without a click
  EXPECT_LT(peak(output_->render(4800)), 1e-6);
  output_->setGain(Group::kMusic, 1);
  output_->render(4800);
  EXPECT_GT(peak(output_->render(4800)), 0.01);
  output_->setGain(0);
  output_->render(4800);
  EXPECT_LT(peak(output_->render(4800)), 1e-6);
}

// A run, music, and what can happen at about the same time, all at full volume.
TEST_F(OpenalOutputTest, ManySoundsTogetherDoNotClip) {
  for (const SolidKind solid : {SolidKind::kTetrahedron, SolidKind::kIcosahedron}) {
    output_->setLoop(output_->startLoop(output_->addBuffer(makeMusic(solid)), Group::kMusic), 0.7, 1);
  }
  output_->setLoop(output_->startLoop(output_->addBuffer(makeSound(Sound::kRoll)), Group::kEffects), 0.5, 1);
  for (const Sound sound : {Sound::kLand, Sound::kGoal, Sound::kEdge}) {
    output_->play(output_->addBuffer(makeSound(sound)), 1, 0, 1);
  }
  double loudest = 0;
  for (int second = 0; second < 5; ++second) loudest = std::max(loudest, peak(output_->render(kSampleRate)));
  EXPECT_GT(loudest, 0.2);
  EXPECT_LT(loudest, 1);
}

}  // namespace
}  // namespace platon::openal_output_test
