#include "client/ui/replay_bar.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "client/ui/overlay_writer.h"
#include "platon/game/game.h"

namespace platon {
namespace {

using namespace overlay_colours;

constexpr float kMargin = 16;
constexpr float kTop = Overlay::kHeight - 74;
constexpr float kLine = Overlay::kHeight - 54;  // middle of the line
constexpr float kThick = 8;
constexpr float kReach = 14;      // above and below the line, where a click counts
constexpr float kTextWidth = 96;  // left and right of the line
constexpr const char* kKeys = "Space pause    ← → tick    Shift + ← → 5 s    + − speed    Tab next player    Esc leave";

float left() { return kMargin + kTextWidth; }
float right(float width) { return std::max(width - kMargin - kTextWidth, left() + 1); }

// Minutes, seconds and hundredths.
std::string timeText(std::uint32_t ticks) {
  const long hundredths = std::lround(ticks * 100.0 / kTicksPerSecond);
  const auto two = [](long value) { return (value < 10 ? "0" : "") + std::to_string(value); };
  return std::to_string(hundredths / 6000) + ":" + two(hundredths / 100 % 60) + "." + two(hundredths % 100);
}

std::string speedText(const ReplayStatus& status) {
  if (status.paused) return "paused";
  std::string text = std::to_string(status.speed);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text + " ×";
}

}  // namespace

Overlay makeReplayBar(const ReplayStatus& status, const Font& font, float width) {
  OverlayWriter writer(font);
  const double share = status.ticks == 0 ? 0 : double{1} * status.tick / status.ticks;
  const float at = left() + (right(width) - left()) * static_cast<float>(share);
  const glm::vec2 half(0, kThick / 2);
  writer.panel({kMargin, kTop}, {width - kMargin, Overlay::kHeight - kMargin}, 12, kPanel);
  writer.panel(glm::vec2(left(), kLine) - half, glm::vec2(right(width), kLine) + half, kThick / 2, kSelected);
  writer.panel(glm::vec2(left(), kLine) - half, glm::vec2(at, kLine) + half, kThick / 2, kGold);
  writer.panel(glm::vec2(at, kLine) - kThick, glm::vec2(at, kLine) + kThick, kThick, kBright);
  writer.left(timeText(status.tick), {kMargin + 16, kLine + 5}, 15, kBright);
  writer.right(speedText(status), {width - kMargin - 16, kLine + 5}, 15, status.paused ? kGold : kBright);
  writer.left(timeText(status.ticks), {kMargin + 16, kLine + 27}, 12, kSoft);
  writer.centred(kKeys, {width / 2, kLine + 27}, 12, kSoft);
  return writer.take();
}

std::optional<double> replayBarAt(glm::dvec2 place, float width) {
  const bool beside = place.x < left() - kThick || place.x > right(width) + kThick;
  if (beside || std::abs(place.y - kLine) > kReach) return std::nullopt;
  return replayBarNear(place, width);
}

double replayBarNear(glm::dvec2 place, float width) {
  return std::clamp((place.x - left()) / (right(width) - left()), 0.0, 1.0);
}

}  // namespace platon
