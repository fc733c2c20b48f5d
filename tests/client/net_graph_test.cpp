#include "client/net_graph.h"

#include <gtest/gtest.h>

namespace platon {
namespace {

TEST(NetGraph, EmptyWithoutSamples) {
  const Font font;
  EXPECT_TRUE(NetGraph().overlay(font, 1280).panels.empty());
}

TEST(NetGraph, StaysInItsPanelWhateverTheSamples) {
  const Font font;
  NetGraph graph;
  for (std::size_t i = 0; i < NetGraph::kSamples * 2; ++i) {
    graph.add({.rttMs = i % 7 == 0 ? 4000.0 : 0.0,
               .aheadTicks = 3,
               .correctionSubunits = 5,
               .downBytesPerSecond = 2345,
               .upBytesPerSecond = 999});
  }
  const Overlay overlay = graph.overlay(font, 1280);
  ASSERT_EQ(overlay.panels.size(), NetGraph::kSamples + 1) << "one bar for each of the last samples";
  const Overlay::Panel& frame = overlay.panels[0];
  EXPECT_LT(frame.high.x, 1280);
  EXPECT_LT(frame.high.y, Overlay::kHeight);
  for (const Overlay::Panel& bar : overlay.panels) {
    EXPECT_GE(bar.low.x, frame.low.x);
    EXPECT_GE(bar.low.y, frame.low.y);
    EXPECT_LE(bar.high.x, frame.high.x);
    EXPECT_LE(bar.high.y, frame.high.y);
  }
  for (const Overlay::Text& text : overlay.texts) {
    EXPECT_LT(text.place.x + font.width(text.words) * text.size, frame.high.x) << text.words;
  }
  EXPECT_EQ(overlay.texts[1].words, "down 2.3, up 1.0 kB/s");
}

TEST(NetGraph, CorrectionsHaveAnotherColour) {
  const Font font;
  NetGraph graph;
  graph.add({.rttMs = 20, .aheadTicks = 3, .correctionSubunits = 0, .downBytesPerSecond = 0, .upBytesPerSecond = 0});
  graph.add({.rttMs = 20, .aheadTicks = 3, .correctionSubunits = 9, .downBytesPerSecond = 0, .upBytesPerSecond = 0});
  const Overlay overlay = graph.overlay(font, 1280);
  EXPECT_NE(overlay.panels[1].colour, overlay.panels[2].colour);
}

}  // namespace
}  // namespace platon
