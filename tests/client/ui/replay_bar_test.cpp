#include "client/ui/replay_bar.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

namespace platon {
namespace {

constexpr float kWidth = 1280;
constexpr glm::vec2 kScreen(kWidth, Overlay::kHeight);
constexpr double kLine = Overlay::kHeight - 56;

bool has(const Overlay& overlay, const std::string& text) {
  return std::any_of(overlay.texts.begin(), overlay.texts.end(),
                     [&](const auto& each) { return each.content == text; });
}

TEST(ReplayBar, ShowsTimesAndSpeed) {
  const Font font;
  const Overlay playing = makeReplayBar({3661, 7200, 0.25, false}, font, kScreen);
  EXPECT_TRUE(has(playing, "1:01.02"));
  EXPECT_TRUE(has(playing, "2:00.00"));
  EXPECT_TRUE(has(playing, "0.25 ×"));
  EXPECT_TRUE(has(makeReplayBar({0, 7200, 4, false}, font, kScreen), "4 ×"));
  EXPECT_TRUE(has(makeReplayBar({0, 7200, 4, true}, font, kScreen), "paused"));
}

TEST(ReplayBar, APlaceChoosesWhatIsDrawnThere) {
  const Font font;
  for (const std::uint32_t tick : {0U, 1U, 250U, 999U, 1000U}) {
    const Overlay bar = makeReplayBar({tick, 1000, 1, false}, font, kScreen);
    const Overlay::Panel& knob = bar.panels.back();
    const auto share = replayBarAt((knob.low + knob.high) / 2.0F, kScreen);
    ASSERT_TRUE(share) << tick;
    EXPECT_NEAR(*share * 1000, tick, 0.01);
  }
}

TEST(ReplayBar, OnlyTheBarIsClickable) {
  EXPECT_FALSE(replayBarAt({kWidth / 2, 300}, kScreen));
  EXPECT_FALSE(replayBarAt({20, kLine}, kScreen));
  EXPECT_FALSE(replayBarAt({kWidth - 20, kLine}, kScreen));
  EXPECT_TRUE(replayBarAt({kWidth / 2, kLine}, kScreen));
  EXPECT_EQ(replayBarNear({-50, 0}, kScreen), 0);
  EXPECT_EQ(replayBarNear({kWidth + 50, 0}, kScreen), 1);
}

TEST(ReplayBar, AnEmptyRecordingHasABar) {
  const Font font;
  EXPECT_FALSE(makeReplayBar({0, 0, 1, true}, font, {10, 10}).panels.empty());
}

}  // namespace
}  // namespace platon
