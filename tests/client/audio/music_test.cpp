#include "client/audio/music.h"

#include <map>

#include <gtest/gtest.h>

#include "tests/client/audio/pcm_laws.h"

namespace platon::music_test {
namespace {

// Makes the music of each solid once.
const Pcm& musicOf(SolidKind solid) {
  static std::map<SolidKind, Pcm> made;
  const auto [found, isNew] = made.try_emplace(solid);
  if (isNew) found->second = makeMusic(solid);
  return found->second;
}

class EveryMusic : public testing::TestWithParam<SolidKind> {};

INSTANTIATE_TEST_SUITE_P(Music, EveryMusic,
                         testing::Values(SolidKind::kTetrahedron, SolidKind::kHexahedron, SolidKind::kOctahedron,
                                         SolidKind::kDodecahedron, SolidKind::kIcosahedron));

TEST_P(EveryMusic, IsALoopWithoutASeam) {
  const Pcm& pcm = musicOf(GetParam());
  EXPECT_EQ(pcm.channels, 2);
  EXPECT_EQ(pcm.frames(), std::size_t{kMusicSeconds} * kSampleRate);
  EXPECT_FALSE(hasSeam(pcm));
}

TEST_P(EveryMusic, IsSoftAndWarmAndHasNoOffset) {
  const Pcm& pcm = musicOf(GetParam());
  EXPECT_LE(peakOf(pcm), kMaxSample);
  EXPECT_LT(brightnessOf(pcm), 1000);
  for (const int channel : {0, 1}) EXPECT_LT(std::abs(offsetOf(pcm, channel)), 0.05);
}

// No second of it is silent, and none stands out.
TEST_P(EveryMusic, IsEven) {
  const Pcm& pcm = musicOf(GetParam());
  double softest = 1e9;
  double loudest = 0;
  for (int second = 0; second < kMusicSeconds; ++second) {
    double squares = 0;
    for (int i = 0; i < 2 * kSampleRate; ++i) {
      squares += std::pow(pcm.samples[static_cast<std::size_t>(second * 2 * kSampleRate + i)], 2);
    }
    const double level = std::sqrt(squares / (2 * kSampleRate));
    softest = std::min(softest, level);
    loudest = std::max(loudest, level);
  }
  EXPECT_GT(softest, 300);
  EXPECT_LT(loudest, 4 * softest);
}

TEST(Music, AreAlwaysTheSameAndDifferFromEachOther) {
  const Pcm& earth = musicOf(SolidKind::kHexahedron);
  EXPECT_EQ(earth.samples, makeMusic(SolidKind::kHexahedron).samples);
  EXPECT_NE(earth.samples, musicOf(SolidKind::kTetrahedron).samples);
}

}  // namespace
}  // namespace platon::music_test
