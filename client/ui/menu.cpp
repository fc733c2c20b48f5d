#include "client/ui/menu.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "client/ui/overlay_writer.h"

namespace platon {
namespace {

enum Item {
  kResume,
  kTurnSpeed,
  kInstantCut,
  kReducedMotion,
  kControls,
  kZoom,
  kFullscreen,
  kNetGraph,
  kLeave,
  kItems
};

constexpr std::array<const char*, kItems> kNames{"Resume",         "Camera turn speed",    "Instant camera cut",
                                                 "Reduced motion", "Controls relative to", "Zoom",
                                                 "Full screen",    "Connection graph",     "Leave the game"};
constexpr std::array<double, 5> kTurnSpeeds{2, 4, 7, 12, 30};
constexpr std::array<const char*, 5> kTurnSpeedNames{"very slow", "slow", "normal", "fast", "very fast"};
constexpr std::array<double, 7> kZooms{0.5, 0.65, 0.8, 1, 1.25, 1.6, 2};

// Index of the step nearest to the value.
template <std::size_t Count>
int nearest(const std::array<double, Count>& steps, double value) {
  const auto closer = [value](double a, double b) { return std::abs(a - value) < std::abs(b - value); };
  return static_cast<int>(std::min_element(steps.begin(), steps.end(), closer) - steps.begin());
}

template <std::size_t Count>
double stepped(const std::array<double, Count>& steps, double value, int direction) {
  const int next = std::clamp(nearest(steps, value) + direction, 0, static_cast<int>(Count) - 1);
  return steps[static_cast<std::size_t>(next)];
}

std::string valueOf(int item, const Settings& settings) {
  const auto onOff = [](bool flag) { return flag ? "on" : "off"; };
  switch (item) {
    case kTurnSpeed:
      return kTurnSpeedNames[static_cast<std::size_t>(nearest(kTurnSpeeds, settings.comfort.turnSpeed))];
    case kInstantCut:
      return onOff(settings.comfort.instantCut);
    case kReducedMotion:
      return onOff(settings.comfort.reducedMotion);
    case kControls:
      return settings.controls == ControlFrame::kPlayer ? "the player" : "the screen";
    case kZoom:
      return std::to_string(std::lround(settings.zoom * 100)) + " %";
    case kFullscreen:
      return onOff(settings.fullscreen);
    case kNetGraph:
      return onOff(settings.netGraph);
    default:
      return "";
  }
}

}  // namespace

void Menu::step(Step step, Settings& settings) {
  if (!open_) return;
  if (step == Step::kUp) item_ = (item_ + kItems - 1) % kItems;
  if (step == Step::kDown) item_ = (item_ + 1) % kItems;
  if (step == Step::kLess) change(settings, -1);
  if (step == Step::kMore) change(settings, 1);
}

void Menu::choose(Settings& settings) {
  if (!open_) return;
  if (item_ == kResume)
    open_ = false;
  else if (item_ == kLeave)
    leaving_ = true;
  else
    change(settings, 1);
}

void Menu::change(Settings& settings, int direction) const {
  const auto toggle = [](bool& flag) { flag = !flag; };
  switch (item_) {
    case kTurnSpeed:
      settings.comfort.turnSpeed = stepped(kTurnSpeeds, settings.comfort.turnSpeed, direction);
      break;
    case kInstantCut:
      toggle(settings.comfort.instantCut);
      break;
    case kReducedMotion:
      toggle(settings.comfort.reducedMotion);
      break;
    case kControls:
      settings.controls = settings.controls == ControlFrame::kPlayer ? ControlFrame::kScreen : ControlFrame::kPlayer;
      break;
    case kZoom:
      settings.zoom = stepped(kZooms, settings.zoom, direction);
      break;
    case kFullscreen:
      toggle(settings.fullscreen);
      break;
    case kNetGraph:
      toggle(settings.netGraph);
      break;
    default:
      break;
  }
}

Overlay Menu::overlay(const Settings& settings, const Font& font, float width) const {
  OverlayWriter writer(font);
  if (!open_) return writer.take();
  constexpr float kRowHeight = 40;
  const glm::vec2 half(230, kRowHeight * static_cast<float>(kNames.size()) / 2 + 44);
  const glm::vec2 middle(width / 2, Overlay::kHeight / 2);
  writer.panel({0, 0}, {width, Overlay::kHeight}, 0, {0.02F, 0.02F, 0.05F, 0.55F});
  writer.panel(middle - half, middle + half, 18, {0.07F, 0.08F, 0.13F, 0.96F});
  writer.centred("Platon", {middle.x, middle.y - half.y + 42}, 26, overlay_colours::kBright);
  for (int item = 0; item < kItems; ++item) {
    const float top = middle.y - half.y + 64 + kRowHeight * static_cast<float>(item);
    const bool chosen = item == item_;
    if (chosen) {
      writer.panel({middle.x - half.x + 16, top}, {middle.x + half.x - 16, top + kRowHeight - 4}, 9,
                   overlay_colours::kSelected);
    }
    const glm::vec4 colour = chosen ? overlay_colours::kBright : overlay_colours::kSoft;
    const std::string value = valueOf(item, settings);
    const float baseline = top + 24;
    writer.left(kNames[static_cast<std::size_t>(item)], {middle.x - half.x + 34, baseline}, 18, colour);
    writer.right(chosen && !value.empty() ? std::string("‹  ") + value + "  ›" : value,
                 {middle.x + half.x - 34, baseline}, 18, colour);
  }
  return writer.take();
}

}  // namespace platon
