#include "client/ui/net_graph.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace platon {
namespace {

NetSample worst(double rttMs) {
  NetSample sample;
  sample.line = {rttMs, 345, -12, 100, 20};
  sample.aheadTicks = 123;
  sample.correctionSubunits = 5;
  sample.corrections = 9999;
  sample.lastCorrection = 1536;
  sample.downBytesPerSecond = 12345;
  sample.upBytesPerSecond = 999;
  return sample;
}

TEST(NetGraph, EmptyWithoutSamples) {
  const Font font;
  EXPECT_TRUE(NetGraph().overlay(font, 1280).panels.empty());
}

TEST(NetGraph, StaysInItsPanelWhateverTheSamples) {
  const Font font;
  NetGraph graph;
  for (std::size_t i = 0; i < NetGraph::kSamples * 2; ++i) {
    graph.add(worst(i % 7 == 0 ? 4000 : 0));
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
  for (std::size_t line = 1; line < overlay.texts.size(); ++line) {
    EXPECT_GT(overlay.texts[line].place.y, overlay.texts[line - 1].place.y);
  }
  EXPECT_LT(overlay.texts.back().place.y, frame.high.y);
}

TEST(NetGraph, SaysHowTheLineDoes) {
  const Font font;
  NetGraph graph;
  graph.add(worst(1234));
  const Overlay overlay = graph.overlay(font, 1280);
  std::vector<std::string> words;
  for (const Overlay::Text& text : overlay.texts) words.push_back(text.words);
  const std::vector<std::string> expected = {"round trip 1234 ms, jitter 345 ms", "123 ticks ahead, -12 to spare",
                                             "lost 100 % down, 20 % up", "9999 corrections, the last by 1.5 units",
                                             "12.3 kB/s down, 1.0 up"};
  EXPECT_EQ(words, expected);
}

TEST(NetGraph, CorrectionsHaveAnotherColour) {
  const Font font;
  NetGraph graph;
  NetSample sample = worst(20);
  sample.correctionSubunits = 0;
  graph.add(sample);
  sample.correctionSubunits = 9;
  graph.add(sample);
  const Overlay overlay = graph.overlay(font, 1280);
  EXPECT_NE(overlay.panels[1].colour, overlay.panels[2].colour);
}

}  // namespace
}  // namespace platon
