#include "client/audio/hearing.h"

#include <gtest/gtest.h>

namespace platon::hearing_test {
namespace {

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

}  // namespace
}  // namespace platon::hearing_test
