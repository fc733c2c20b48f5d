#include "client/ui/net_graph.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "client/ui/overlay_writer.h"
#include "platon/exact/integer.h"

namespace platon {
namespace {

constexpr float kWidth = 236;
constexpr float kBars = 52;
constexpr float kLine = 18;
constexpr float kHeight = kBars + 26 + 5 * kLine;

std::string rounded(double value) { return std::to_string(std::lround(value)); }

// Of what is not negative.
std::string withTenths(double value) {
  const long tenths = std::lround(value * 10);
  return std::to_string(tenths / 10) + "." + std::to_string(tenths % 10);
}

std::string kilobytes(double bytesPerSecond) { return withTenths(bytesPerSecond / 1000); }
std::string units(double subunits) { return withTenths(subunits / kSubunitsPerUnit); }

std::array<std::string, 5> linesOf(const NetSample& sample) {
  const LinkStatistics& line = sample.line;
  return {"round trip " + rounded(line.rttMs) + " ms, jitter " + rounded(line.jitterMs) + " ms",
          rounded(sample.aheadTicks) + " ticks ahead, " + rounded(line.slackTicks) + " to spare",
          "lost " + rounded(line.lostDownPercent) + " % down, " + rounded(line.lostUpPercent) + " % up",
          rounded(sample.corrections) + " corrections, the last by " + units(sample.lastCorrection) + " units",
          kilobytes(sample.downBytesPerSecond) + " kB/s down, " + kilobytes(sample.upBytesPerSecond) + " up"};
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
                         return a.line.rttMs < b.line.rttMs;
                       })->line.rttMs;
  const double scale = kBars / std::max(50.0, mostRtt * 1.1);
  const float step = (kWidth - 20) / float{kSamples};
  const float floor = low.y + 8 + kBars;
  float x = low.x + kWidth - 10 - step * static_cast<float>(samples_.size());
  for (const NetSample& sample : samples_) {
    const bool corrected = sample.correctionSubunits > 0;
    const float height = std::max(1.0F, static_cast<float>(sample.line.rttMs * scale));
    writer.panel({x, floor - height}, {x + step, floor}, 0,
                 corrected ? overlay_colours::kWarning : overlay_colours::kGood);
    x += step;
  }
  const NetSample& last = samples_.back();
  const glm::vec2 text = low + glm::vec2(10, kBars + 28);
  float below = 0;
  for (const std::string& line : linesOf(last)) {
    writer.left(line, text + glm::vec2(0, below), 12, overlay_colours::kSoft);
    below += kLine;
  }
  return writer.take();
}

}  // namespace platon
