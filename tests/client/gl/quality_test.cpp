#include "client/gl/quality.h"

#include <gtest/gtest.h>

namespace platon {
namespace {

TEST(Quality, ADriverWithoutGraphicsHardwareGetsOneSample) {
  EXPECT_EQ(qualityFor("llvmpipe (LLVM 15.0.6, 256 bits)").samples, 1);
  EXPECT_EQ(qualityFor("softpipe").samples, 1);
  EXPECT_EQ(qualityFor("Mesa Intel(R) UHD Graphics 620 (KBL GT2)"), kBestQuality);
  EXPECT_EQ(qualityFor(""), kBestQuality);
}

TEST(Quality, ShadowsAndParticlesAreOnByDefault) {
  EXPECT_TRUE(qualityFor("llvmpipe").shadows);
  EXPECT_TRUE(qualityFor("llvmpipe").particles);
  EXPECT_EQ(qualityFor("llvmpipe").scale, 1);
}

}  // namespace
}  // namespace platon
