#include "client/ui/replay_bar.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "client/netcode/player_snapshot.h"
#include "client/ui/font.h"
#include "client/ui/overlay.h"
#include "client/ui/player_rows.h"

namespace platon {
namespace {

using namespace overlay_colours;

constexpr float kBarMargin = 16;
constexpr float kTop = 78;   // above the lower edge of the screen
constexpr float kLine = 56;  // middle of the line
constexpr float kThick = 8;
constexpr float kReach = 14;      // above and below the line, where a click counts
constexpr float kTextWidth = 96;  // left and right of the line

float left() { return kBarMargin + kTextWidth; }
float right(glm::vec2 screen) { return std::max(screen.x - kBarMargin - kTextWidth, left() + 1); }
float line(glm::vec2 screen) { return screen.y - kLine; }

// Minutes, seconds and hundredths.
std::string timeText(std::uint32_t ticks) {
  const long hundredths = std::lround(secondsOf(ticks) * 100);
  return std::to_string(hundredths / 6000) + ":" + twoDigits(hundredths / 100 % 60) + "." + twoDigits(hundredths % 100);
}

bool hasEnded(const ReplayStatus& status) { return status.paused && status.tick == status.ticks; }

std::string keysText(const ReplayStatus& status) {
  const std::string deed = hasEnded(status) ? "play again" : status.paused ? "play on" : "pause";
  if (status.gamepad)
    return "pad A: " + deed + " · ← →: tick · LB RB: 5 s · ↑ ↓: speed" +
           (status.several ? " · Back: next player" : "") + " · pad B: leave";
  return "Space: " + deed + " · ← →: tick · Shift + ← →: 5 s · + −: speed" +
         (status.several ? " · Tab: next player" : "") + " · Esc: leave";
}

std::string speedText(const ReplayStatus& status) {
  if (hasEnded(status)) return "end";
  if (status.paused) return "paused";
  std::string text = std::to_string(status.speed);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text + " ×";
}

}  // namespace

Overlay makeReplayBar(const ReplayStatus& status, const Font& font, glm::vec2 screen) {
  OverlayWriter writer(font);
  const double share = status.ticks == 0 ? 0 : double{1} * status.tick / status.ticks;
  const float at = left() + (right(screen) - left()) * static_cast<float>(share);
  const float middle = line(screen);
  const glm::vec2 half(0, kThick / 2);
  writer.panel({kBarMargin, screen.y - kTop}, screen - kBarMargin, 12, kPanel);
  writer.panel(glm::vec2(left(), middle) - half, glm::vec2(right(screen), middle) + half, kThick / 2, kSelected);
  writer.panel(glm::vec2(left(), middle) - half, glm::vec2(at, middle) + half, kThick / 2, kGold);
  writer.panel(glm::vec2(at, middle) - kThick, glm::vec2(at, middle) + kThick, kThick, kBright);
  const float upper = middle + 6;
  const float lower = middle + 29;
  writer.left(timeText(status.tick), {kBarMargin + 16, upper}, kSmallestText, kBright);
  writer.right(speedText(status), {screen.x - kBarMargin - 16, upper}, kSmallestText, status.paused ? kGold : kBright);
  writer.left(timeText(status.ticks), {kBarMargin + 16, lower}, kSmallestText, kSoft);
  const float room = (right(screen) - left()) / kSmallestText;
  writer.centred(fittedText(keysText(status), font, room), {screen.x / 2, lower}, kSmallestText, kSoft);
  return writer.take();
}

std::optional<double> replayBarAt(glm::dvec2 place, glm::vec2 screen) {
  const bool beside = place.x < left() - kThick || place.x > right(screen) + kThick;
  if (beside || std::abs(place.y - line(screen)) > kReach) return std::nullopt;
  return replayBarNear(place, screen);
}

bool isOnReplayBar(glm::dvec2 place, glm::vec2 screen) {
  return place.x >= kBarMargin && place.x <= screen.x - kBarMargin && place.y >= screen.y - kTop;
}

double replayBarNear(glm::dvec2 place, glm::vec2 screen) {
  return std::clamp((place.x - left()) / (right(screen) - left()), 0.0, 1.0);
}

}  // namespace platon
