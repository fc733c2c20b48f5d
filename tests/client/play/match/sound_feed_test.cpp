#include "client/play/match/sound_feed.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "client/play/match/scene_feed.h"
#include "tests/support/session_network.h"
#include "tests/support/test_level.h"
#include "tests/support/wait_until.h"

// On OpenAL's loopback device, which needs no sound card.
namespace platon::sound_feed_test {
namespace {

constexpr double kFrame = 1.0 / 60;

class SoundFeedTest : public testing::Test {
 protected:
  void SetUp() override {
    settings_.musicVolume = 0;
    ASSERT_TRUE(waitUntil([this] {
      feed_.update(nullptr, nullptr, std::nullopt, settings_, 0);
      return feed_.audio().output() != nullptr;
    }));
  }

  // The loudest sample of the next frame.
  double hear() {
    double loudest = 0;
    for (const float sample : feed_.audio().output()->render(kSampleRate / 60)) {
      loudest = std::max(loudest, double{std::abs(sample)});
    }
    return loudest;
  }

  Settings settings_;
  SoundFeed feed_{&OpenalOutput::openLoopback};
};

TEST_F(SoundFeedTest, WithoutASessionNothingIsHeard) {
  feed_.update(nullptr, nullptr, std::nullopt, settings_, kFrame);
  EXPECT_EQ(hear(), 0);
}

TEST_F(SoundFeedTest, WhatTheMenuDoesIsHeard) {
  feed_.menu(Menu::Deed::kNone);
  EXPECT_EQ(hear(), 0);
  feed_.menu(Menu::Deed::kMoved);
  EXPECT_GT(hear(), 0.01);
}

TEST_F(SoundFeedTest, AChosenItemIsHeard) {
  feed_.menu(Menu::Deed::kChosen);
  EXPECT_GT(hear(), 0.01);
}

TEST_F(SoundFeedTest, ARunningPlayerIsHeardUnlessTheVolumeIsZero) {
  SessionNetwork match({endlessLevel()}, 1);
  match.join({}, [](const Game&, std::uint32_t) { return Input{Input::kRight}; });
  match.run(std::chrono::seconds(1));
  SceneFeed scenes;
  double loudest = 0;
  for (int frame = 0; frame < 120; ++frame) {
    if (frame == 60) settings_.effectsVolume = loudest = 0;
    match.run(std::chrono::microseconds(16'667));
    const std::optional<Scene> scene = scenes.scene(match.session(0), match.now());
    feed_.update(&match.session(0), &scene.value(), std::nullopt, settings_, kFrame);
    const double heard = hear();
    if (frame >= 65) loudest = std::max(loudest, heard);
    if (frame == 59) {
      EXPECT_GT(heard, 0.002);
    }
  }
  EXPECT_LT(loudest, 1e-6);
}

}  // namespace
}  // namespace platon::sound_feed_test
