#include "client/audio/element_cues.h"

#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/client/audio/observed_player.h"

namespace platon::element_cues_test {
namespace {

using testing::IsEmpty;

constexpr Sound kNone = Sound::kRoll;

class Played {
 public:
  explicit Played(const std::string& segments) : game(cubeWith(segments)), mesh(SolidKind::kHexahedron, 480) {
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
  Played played("-100 -190 -90 -190 key 1\n200 -200 200 -100 door 1\n");
  const std::vector<Cue> heard = played.hold(Input::kRight, 30);
  ASSERT_EQ(heard.size(), 2u);
  EXPECT_EQ(soundAt(heard, 0), Sound::kKey);
  EXPECT_EQ(soundAt(heard, 1), Sound::kDoorOpens);
  EXPECT_GT(heard[0].gain, heard[1].gain);
  EXPECT_GT(heard[1].pan, 0.3);
}

TEST(ElementCues, ANumberSoundsOnceFromTheNearest) {
  Played near("-100 -190 -90 -190 key 1\n100 -200 100 -100 door 1\n200 -200 200 -100 door 1\n");
  const std::vector<Cue> heard = near.hold(Input::kRight, 30);
  ASSERT_EQ(heard.size(), 2u);
  Played alone("-100 -190 -90 -190 key 1\n100 -200 100 -100 door 1\n");
  EXPECT_EQ(heard[1].gain, alone.hold(Input::kRight, 30).at(1).gain);
}

TEST(ElementCues, APlateSoundsWhenItIsSteppedOnAndWhenItIsLeft) {
  Played played("-200 -190 -100 -190 plate 2\n200 -200 200 -100 door 2\n");
  ASSERT_EQ(played.landing.size(), 2u);
  EXPECT_EQ(soundAt(played.landing, 0), Sound::kPlateDown);
  EXPECT_EQ(soundAt(played.landing, 1), Sound::kDoorOpens);
  const std::vector<Cue> off = played.hold(Input::kRight, 40);
  ASSERT_EQ(off.size(), 2u);
  EXPECT_EQ(soundAt(off, 0), Sound::kPlateUp);
  EXPECT_EQ(soundAt(off, 1), Sound::kDoorCloses);
}

TEST(ElementCues, WhatIsTakenBackAndPredictedAnewSoundsOnce) {
  Played played("-100 -190 -90 -190 key 1\n200 -200 200 -100 door 1\n");
  const Game before = played.game;
  EXPECT_EQ(played.hold(Input::kRight, 30).size(), 2u);
  const Game after = played.game;
  EXPECT_THAT(played.cues.observe(before, after.tick() + 1, played.mesh, Pose()),
              testing::Each(testing::Field(&Cue::sound, Sound::kDoorCloses)));
  EXPECT_THAT(played.cues.observe(after, after.tick() + 3, played.mesh, Pose()), IsEmpty());
}

TEST(ElementCues, ReplayedTicksAndTheFirstStateAreSilent) {
  Played played("-100 -190 -90 -190 key 1\n200 -200 200 -100 door 1\n");
  const std::vector<Cue> heard = played.hold(Input::kRight, 30);
  EXPECT_EQ(heard.size(), 2u);
  EXPECT_THAT(played.observeNow(), IsEmpty());
  ElementCues later;
  EXPECT_THAT(later.observe(played.game, 7, played.mesh, Pose()), IsEmpty());
}

}  // namespace
}  // namespace platon::element_cues_test
