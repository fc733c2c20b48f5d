#include "client/menu/pages/settings_page.h"

#include <array>
#include <cstdint>
#include <optional>

#include "client/menu/pages/quality_items.h"
#include "client/menu/pages/setting_items.h"
#include "client/ui/ball_choice_text.h"

namespace platon {
namespace {

constexpr std::array<NamedValue, 5> kTurnSpeeds{
    {{2, "very slow"}, {4, "slow"}, {7, "normal"}, {12, "fast"}, {30, "very fast"}}};

constexpr SliderRange kVolumes{0, 100, 5, 1};

constexpr std::array<NamedValue, 6> kFrameCaps{
    {{0, "none"}, {30, "30 fps"}, {60, "60 fps"}, {120, "120 fps"}, {144, "144 fps"}, {240, "240 fps"}}};

MenuItem inMotion(MenuItem item) {
  item.inMotion = true;
  return item;
}

MenuItem heading(const char* name) { return {MenuItem::Kind::kHeading, name}; }

MenuItem controlsItem(ControlFrame& frame) {
  const bool player = frame == ControlFrame::kPlayer;
  MenuItem item{MenuItem::Kind::kChoice, "Left and right", player ? "of the ball" : "of the screen"};
  item.flips = true;
  item.step = [&frame, player](int) { frame = player ? ControlFrame::kScreen : ControlFrame::kPlayer; };
  return item;
}

// `toggled`: a press turns the control on and the next press off.
MenuItem heldItem(const char* control, bool& toggled) {
  MenuItem item{MenuItem::Kind::kChoice, control, toggled ? "press on, press off" : "while the key is held"};
  item.flips = true;
  item.step = [&toggled](int) { toggled = !toggled; };
  return item;
}

// Goes through the values and, before the first of them, none.
template <class Value>
MenuItem ballItem(const char* name, std::optional<Value>& value, std::uint32_t count) {
  MenuItem item{MenuItem::Kind::kChoice, name, value ? wordOf(value) : "by your number"};
  item.step = [&value, count](int direction) {
    const std::uint32_t now = value ? static_cast<std::uint32_t>(*value) + 1 : 0;
    const std::uint32_t next = (now + count + 1 + static_cast<std::uint32_t>(direction)) % (count + 1);
    value.reset();
    if (next > 0) value = static_cast<Value>(next - 1);
  };
  return item;
}

MenuItem cameraItem(CameraView& view) {
  constexpr std::array kNames{"follows you", "stands still, cuts", "stands still, fades"};
  const auto now = static_cast<std::size_t>(view);
  MenuItem item{MenuItem::Kind::kChoice, "Camera", kNames.at(now)};
  item.step = [&view, now, kNames](int direction) {
    view = static_cast<CameraView>((now + kNames.size() + static_cast<std::size_t>(direction)) % kNames.size());
  };
  return item;
}

// On while a hint is left. Turned on, it shows all of them again.
MenuItem hintsItem(Settings& settings) {
  const bool on = settings.firstKeys || settings.untold != UntoldElements{0};
  MenuItem item{MenuItem::Kind::kToggle, "Hints for new players", on ? "on" : "off", on ? 1.0 : 0.0};
  item.step = [&settings, on](int) {
    settings.firstKeys = !on;
    settings.untold = on ? UntoldElements{0} : UntoldElements();
  };
  return item;
}

}  // namespace

MenuPage settingsPage(Settings& settings, const std::function<void()>& showKeys, bool alone) {
  MenuPage page{"Settings"};
  page.standsAside = true;
  page.items = {heading("Picture"),
                toggleItem("Full screen", settings.fullscreen),
                toggleItem("VSync", settings.vsync),
                choiceItem("Frame rate limit", settings.frameCap, kFrameCaps),
                qualityItem(settings.quality),
                renderScaleItem(settings.quality),
                multisamplingItem(settings.quality),
                measureItem(settings.quality),
                inMotion(percentItem("Zoom", settings.zoom, {0.5, 2, 0.05})),
                inMotion(percentItem("UI scale", settings.uiScale, {kMinUiScale, kMaxUiScale, 0.05})),
                inMotion(toggleItem("Numbers on faces", settings.faceNumbers)),
                inMotion(ballItem("Colour of your ball", settings.ball.colour, kBallColours)),
                inMotion(ballItem("Pattern of your ball", settings.ball.pattern, kBallPatterns)),
                heading("Sound"),
                percentItem("Master volume", settings.volume, kVolumes),
                percentItem("Effects volume", settings.effectsVolume, kVolumes),
                percentItem("Music volume", settings.musicVolume, kVolumes),
                heading("Comfort"),
                inMotion(cameraItem(settings.comfort.view)),
                inMotion(choiceItem("Camera turn speed", settings.comfort.turnRate, kTurnSpeeds)),
                inMotion(toggleItem("Instant camera cut", settings.comfort.instantCut)),
                inMotion(toggleItem("Reduced motion", settings.comfort.reducedMotion)),
                inMotion(toggleItem("Flashes", settings.flashes)),
                inMotion(toggleItem("High contrast", settings.highContrast)),
                heading("Controls"),
                {.name = "Keys and buttons", .value = "choose", .choose = showKeys},
                controlsItem(settings.controls),
                heldItem("Run slower", settings.toggled.slow),
                heldItem("Look round", settings.toggled.look),
                heading("Game"),
                inMotion(toggleItem("Timer", settings.timer)),
                toggleItem("Ghosts", settings.ghosts),
                toggleItem("Chat", settings.chat),
                inMotion(toggleItem("Connection graph", settings.netGraph)),
                hintsItem(settings)};
  if (alone) page.items.push_back(inMotion(percentItem("Game speed, alone", settings.gameSpeed, {50, 100, 5, 1})));
  return page;
}

}  // namespace platon
