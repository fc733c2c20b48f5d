#include "client/hud/net_graph.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "client/ui/overlay.h"
#include "platon/exact/integer.h"

namespace platon {
namespace {

constexpr float kGraphWidth = 290;
constexpr float kGraphHeight = 52;
constexpr float kLineHeight = 21;
constexpr int kLines = 6;
constexpr float kHeight = kGraphHeight + 26 + kLines * kLineHeight;

std::string rounded(double value) { return std::to_string(std::lround(value)); }

// `value` ≥ 0.
std::string withTenths(double value) {
  const long tenths = std::lround(value * 10);
  return std::to_string(tenths / 10) + "." + std::to_string(tenths % 10);
}

std::string kilobytes(double bytesPerSecond) { return withTenths(bytesPerSecond / 1000); }
std::string units(double subunits) { return withTenths(subunits / kSubunitsPerUnit); }

std::string correctionsText(const NetSample& sample) {
  if (sample.corrections == 0) return "no corrections";
  return rounded(sample.corrections) + " corrections, the last " + units(sample.lastCorrection) + " units";
}

std::array<std::string, kLines> textOf(const NetSample& sample) {
  const LinkStatistics& link = sample.link;
  return {"round trip " + rounded(link.rttMs) + " ms, jitter " + rounded(link.jitterMs) + " ms",
          "lead " + rounded(sample.aheadTicks) + " ticks, slack " + rounded(link.slackTicks) + " ticks",
          "lost " + rounded(link.lostDownPercent) + " % down, " + rounded(link.lostUpPercent) + " % up",
          correctionsText(sample),
          kilobytes(sample.downBytesPerSecond) + " kB/s down, " + kilobytes(sample.upBytesPerSecond) + " kB/s up",
          rounded(sample.framesPerSecond) + " frames per second"};
}

}  // namespace

void NetGraph::add(const NetSample& sample) {
  samples_.push_back(sample);
  if (samples_.size() > kSamples) samples_.pop_front();
}

Overlay NetGraph::overlay(const Font& font, float width) const {
  OverlayWriter writer(font);
  if (samples_.empty()) return writer.take();
  const glm::vec2 low(width - kGraphWidth - 16, Overlay::kHeight - kHeight - 16);
  writer.panel(low, low + glm::vec2(kGraphWidth, kHeight), 10, overlay_colours::kPanel);
  const auto maxRtt = std::max_element(samples_.begin(), samples_.end(), [](const NetSample& a, const NetSample& b) {
                        return a.link.rttMs < b.link.rttMs;
                      })->link.rttMs;
  const double scale = kGraphHeight / std::max(50.0, maxRtt * 1.1);
  const float step = (kGraphWidth - 20) / float{kSamples};
  const float floor = low.y + 8 + kGraphHeight;
  float x = low.x + kGraphWidth - 10 - step * static_cast<float>(samples_.size());
  for (const NetSample& sample : samples_) {
    const bool corrected = sample.correctionSubunits > 0;
    const float height = std::max(1.0F, static_cast<float>(sample.link.rttMs * scale));
    writer.panel({x, floor - height}, {x + step, floor}, 0,
                 corrected ? overlay_colours::kWarning : overlay_colours::kGood);
    x += step;
  }
  const NetSample& last = samples_.back();
  const glm::vec2 text = low + glm::vec2(10, kGraphHeight + 28);
  float below = 0;
  for (const std::string& line : textOf(last)) {
    writer.left(line, text + glm::vec2(0, below), kSmallestText, overlay_colours::kSoft);
    below += kLineHeight;
  }
  return writer.take();
}

}  // namespace platon
