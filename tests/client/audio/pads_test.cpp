#include "client/audio/pads.h"

#include <map>

#include <gtest/gtest.h>

#include "tests/client/audio/pcm_laws.h"

namespace platon::pads_test {
namespace {

// Makes each pad once.
const Pcm& padOf(SolidKind solid) {
  static std::map<SolidKind, Pcm> pads;
  const auto [found, isNew] = pads.try_emplace(solid);
  if (isNew) found->second = makePad(solid);
  return found->second;
}

class EveryPad : public testing::TestWithParam<SolidKind> {};

INSTANTIATE_TEST_SUITE_P(Pads, EveryPad,
                         testing::Values(SolidKind::kTetrahedron, SolidKind::kHexahedron, SolidKind::kOctahedron,
                                         SolidKind::kDodecahedron, SolidKind::kIcosahedron));

TEST_P(EveryPad, IsALoopWithoutASeam) {
  const Pcm& pcm = padOf(GetParam());
  EXPECT_EQ(pcm.channels, 2);
  EXPECT_EQ(pcm.frames(), std::size_t{kPadSeconds} * kSampleRate);
  EXPECT_FALSE(hasSeam(pcm));
}

TEST_P(EveryPad, IsSoftAndWarmAndHasNoOffset) {
  const Pcm& pcm = padOf(GetParam());
  EXPECT_LE(peakOf(pcm), kMaxSample);
  EXPECT_LT(brightnessOf(pcm), 1000);
  for (const int channel : {0, 1}) EXPECT_LT(std::abs(offsetOf(pcm, channel)), 0.05);
}

// No second of it is silent, and none stands out.
TEST_P(EveryPad, IsEven) {
  const Pcm& pcm = padOf(GetParam());
  double softest = 1e9;
  double loudest = 0;
  for (int second = 0; second < kPadSeconds; ++second) {
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

TEST(Pads, AreAlwaysTheSameAndDifferFromEachOther) {
  const Pcm& earth = padOf(SolidKind::kHexahedron);
  EXPECT_EQ(earth.samples, makePad(SolidKind::kHexahedron).samples);
  EXPECT_NE(earth.samples, padOf(SolidKind::kTetrahedron).samples);
}

}  // namespace
}  // namespace platon::pads_test
