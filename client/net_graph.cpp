#include "client/net_graph.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "client/overlay_writer.h"

namespace platon {
namespace {

constexpr float kWidth = 236;
constexpr float kBars = 52;
constexpr float kHeight = kBars + 62;

std::string rounded(double value) { return std::to_string(std::lround(value)); }

std::string kilobytes(double bytesPerSecond) {
  const long tenths = std::lround(bytesPerSecond / 100);
  return std::to_string(tenths / 10) + "." + std::to_string(tenths % 10);
}

}  // namespace

void NetGraph::add(const NetSample& sample) {
  samples_.push_back(sample);
  if (samples_.size() > kSamples) samples_.pop_front();
}

Overlay NetGraph::overlay(const Font& font, float width) const {
  OverlayWriter writer(font);
  if (samples_.empty()) return writer.take();
  const glm::vec2 low(width - kWidth - 16, Overlay::kHeight - kHeight - 16);
  writer.panel(low, low + glm::vec2(kWidth, kHeight), 10, overlay_colours::kPanel);
  const auto mostRtt = std::max_element(samples_.begin(), samples_.end(), [](const NetSample& a, const NetSample& b) {
                         return a.rttMs < b.rttMs;
                       })->rttMs;
  const double scale = kBars / std::max(50.0, mostRtt * 1.1);
  const float step = (kWidth - 20) / float{kSamples};
  const float floor = low.y + 8 + kBars;
  float x = low.x + kWidth - 10 - step * static_cast<float>(samples_.size());
  for (const NetSample& sample : samples_) {
    const bool corrected = sample.correctionSubunits > 0;
    const float height = std::max(1.0F, static_cast<float>(sample.rttMs * scale));
    writer.panel({x, floor - height}, {x + step, floor}, 0,
                 corrected ? overlay_colours::kWarning : overlay_colours::kGood);
    x += step;
  }
  const NetSample& last = samples_.back();
  const glm::vec2 text = low + glm::vec2(10, kBars + 28);
  writer.left(std::string("round trip ") + rounded(last.rttMs) + " ms, " + rounded(last.aheadTicks) + " ticks ahead",
              text, 12, overlay_colours::kSoft);
  writer.left(
      std::string("down ") + kilobytes(last.downBytesPerSecond) + ", up " + kilobytes(last.upBytesPerSecond) + " kB/s",
      text + glm::vec2(0, 18), 12, overlay_colours::kSoft);
  return writer.take();
}

}  // namespace platon
