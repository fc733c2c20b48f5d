#include "client/audio/volumes.h"

#include <gtest/gtest.h>

namespace platon::volumes_test {
namespace {

TEST(Volumes, GainsGoFromSilenceToFull) {
  EXPECT_EQ(gainOf(0), 0);
  EXPECT_EQ(gainOf(50), 0.25);
  EXPECT_EQ(gainOf(100), 1);
}

}  // namespace
}  // namespace platon::volumes_test
