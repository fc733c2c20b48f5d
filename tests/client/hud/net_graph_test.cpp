#include "client/hud/net_graph.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace platon::net_graph_test {
namespace {

NetSample sampleOf(double rttMs) {
  NetSample sample;
  sample.link = {rttMs, 345, -12, 100, 20};
  sample.aheadTicks = 123;
  sample.correctionSubunits = 5;
  sample.corrections = 9999;
  sample.lastCorrection = 1536;
  sample.downBytesPerSecond = 12345;
  sample.upBytesPerSecond = 999;
  sample.framesPerSecond = 143.6;
  return sample;
}

TEST(NetGraph, IsEmptyWithoutSamples) {
  const Font font;
  const Overlay overlay = NetGraph().overlay(font, 1280);
  EXPECT_TRUE(overlay.panels.empty());
  EXPECT_TRUE(overlay.texts.empty());
}

TEST(NetGraph, BarsAndTextStayInThePanel) {
  const Font font;
  NetGraph graph;
  for (std::size_t i = 0; i < NetGraph::kSamples * 2; ++i) {
    graph.add(sampleOf(i % 7 == 0 ? 4000 : 0));
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
  ASSERT_EQ(overlay.texts.size(), 6U);
  for (const Overlay::Text& text : overlay.texts) {
    EXPECT_LT(text.place.x + font.width(text.content) * text.size, frame.high.x) << text.content;
  }
  for (std::size_t line = 1; line < overlay.texts.size(); ++line) {
    EXPECT_GT(overlay.texts[line].place.y, overlay.texts[line - 1].place.y);
  }
  EXPECT_LT(overlay.texts.back().place.y, frame.high.y);
}

TEST(NetGraph, ShowsTheLatestLinkStatistics) {
  const Font font;
  NetGraph graph;
  graph.add(sampleOf(1234));
  const Overlay overlay = graph.overlay(font, 1280);
  std::vector<std::string> lines;
  for (const Overlay::Text& text : overlay.texts) lines.push_back(text.content);
  const std::vector<std::string> expected = {
      "round trip 1234 ms, jitter 345 ms",    "lead 123 ticks, slack -12 ticks", "lost 100 % down, 20 % up",
      "9999 corrections, the last 1.5 units", "12.3 kB/s down, 1.0 kB/s up",     "144 frames per second"};
  EXPECT_EQ(lines, expected);
}

TEST(NetGraph, ShowsThatThereWereNoCorrections) {
  const Font font;
  NetGraph graph;
  graph.add(NetSample());
  const Overlay overlay = graph.overlay(font, 1280);
  ASSERT_EQ(overlay.texts.size(), 6U);
  EXPECT_EQ(overlay.texts[3].content, "no corrections");
}

TEST(NetGraph, CorrectionsHaveAnotherColour) {
  const Font font;
  NetGraph graph;
  NetSample sample = sampleOf(20);
  sample.correctionSubunits = 0;
  graph.add(sample);
  sample.correctionSubunits = 9;
  graph.add(sample);
  const Overlay overlay = graph.overlay(font, 1280);
  EXPECT_NE(overlay.panels[1].colour, overlay.panels[2].colour);
}

}  // namespace
}  // namespace platon::net_graph_test
