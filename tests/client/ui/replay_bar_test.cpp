#include "client/ui/replay_bar.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "client/hud/hud_space.h"
#include "client/ui/overlay.h"

namespace platon::replay_bar_test {
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

TEST(ReplayBar, NamesTheKeysOrTheButtonsOfTheGamepad) {
  const Font font;
  const auto keys = [&](bool gamepad) {
    return makeReplayBar({0, 7200, 1, false, gamepad, true}, font, kScreen).texts.back().content;
  };
  EXPECT_EQ(keys(false), "Space: pause · ← →: tick · Shift + ← →: 5 s · + −: speed · Tab: next player · Esc: leave");
  EXPECT_EQ(keys(true), "pad A: pause · ← →: tick · LB RB: 5 s · ↑ ↓: speed · Back: next player · pad B: leave");
}

// Before, the bar said "Space: pause" also where Space plays on or again, and offered Tab with one player.
TEST(ReplayBar, NamesWhatTheKeysDoAtThisMoment) {
  const Font font;
  const auto bar = [&](std::uint32_t tick, bool paused) {
    return makeReplayBar({tick, 7200, 1, paused}, font, kScreen);
  };
  const std::string others = " · ← →: tick · Shift + ← →: 5 s · + −: speed · Esc: leave";
  EXPECT_EQ(bar(7199, false).texts.back().content, "Space: pause" + others);
  EXPECT_EQ(bar(7199, true).texts.back().content, "Space: play on" + others);
  EXPECT_EQ(bar(7200, true).texts.back().content, "Space: play again" + others);
  EXPECT_TRUE(has(bar(7200, true), "end"));
  EXPECT_FALSE(has(bar(7200, true), "paused"));
}

TEST(ReplayBar, ThePanelReachesBeyondTheLine) {
  EXPECT_TRUE(isOnReplayBar({20, kLine}, kScreen));
  EXPECT_FALSE(replayBarAt({20, kLine}, kScreen));
  EXPECT_TRUE(isOnReplayBar({640, kLine + 20}, kScreen));
  EXPECT_FALSE(isOnReplayBar({640, kLine - 40}, kScreen));
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

// The longest one is as long as the longest round, 24 hours.
TEST(ReplayBar, NothingOverlapsInALongRecording) {
  const Font font;
  constexpr std::uint32_t kTicks = 5'184'000;
  for (const std::uint32_t height : {360U, 720U, 2160U}) {
    const glm::vec2 screen = kScreen / textScale(1, height);
    for (const std::uint32_t tick : {0U, kTicks / 2, kTicks}) {
      const Overlay bar = makeReplayBar({tick, kTicks, 0.25, tick != kTicks / 2, false, true}, font, screen);
      std::vector<HudBox> boxes{{bar.panels[1].low, bar.panels[1].high}, {bar.panels[3].low, bar.panels[3].high}};
      const std::size_t line = boxes.size();
      for (const Overlay::Text& text : bar.texts) {
        Overlay alone;
        alone.texts.push_back(text);
        boxes.push_back(boundsOf(alone, font));
        EXPECT_GE(boxes.back().low.x, bar.panels[0].low.x) << text.content;
        EXPECT_LE(boxes.back().high.x, bar.panels[0].high.x) << text.content;
      }
      for (std::size_t i = line; i < boxes.size(); ++i) {
        const HudBox inner{boxes[i].low + 0.5F, boxes[i].high - 0.5F};
        for (std::size_t j = 0; j < i; ++j)
          EXPECT_FALSE(inner.overlaps(boxes[j])) << height << " " << tick << " " << bar.texts[i - line].content;
      }
    }
  }
}

TEST(ReplayBar, AnEmptyRecordingHasABar) {
  const Font font;
  EXPECT_FALSE(makeReplayBar({0, 0, 1, true}, font, {10, 10}).panels.empty());
}

}  // namespace
}  // namespace platon::replay_bar_test
