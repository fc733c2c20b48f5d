#include "client/play/settings_preview.h"

#include <algorithm>
#include <array>

#include "platon/game/level.h"

namespace platon {
namespace {

// A floor that goes on over one edge of the cube.
constexpr const char* kLevel = R"(HEXAHEDRON
0 120 -180 0
3 0 0
480
%  # face 0
-240 -200 240 -200
%  # face 1
-240 -200 240 -200
%  # face 2
%  # face 3
%  # face 4
%  # face 5
)";

constexpr std::uint32_t kTicksThere = 40;  // on a face before the ball turns round
constexpr std::uint32_t kJumpFrom = 4;     // ticks after the turn
constexpr std::uint32_t kJumpTo = 16;

NetSample sampleConnection() {
  NetSample sample;
  sample.link.rttMs = 40;
  sample.aheadTicks = 4;
  return sample;
}

}  // namespace

SettingsPreview::SettingsPreview() : game_(loadLevel(kLevel).level, {""}) { begin(); }

void SettingsPreview::begin() {
  game_.begin();
  game_.advance(std::array{Input{Input::kPresent}});
  home_ = face();
  away_ = true;
  ticks_ = ticksThere_ = 0;
}

std::uint32_t SettingsPreview::face() const { return game().world().entities()[0].part; }

void SettingsPreview::advance(const Settings& settings, double seconds) {
  due_ = std::min(due_ + seconds * kTicksPerSecond * settings.gameSpeed / 100, double{kMaxTicks});
  for (; due_ >= 1; --due_) tick();
}

void SettingsPreview::tick() {
  if (game().over()) begin();  // its time is up
  const bool there = (face() != home_) == away_;
  ticksThere_ = there ? ticksThere_ + 1 : 0;
  ++ticks_;
  if (ticksThere_ == kTicksThere) {
    away_ = !away_;
    ticks_ = ticksThere_ = 0;
  }
  Input input{static_cast<std::uint8_t>(Input::kPresent | (away_ ? Input::kRight : Input::kLeft))};
  if (ticks_ >= kJumpFrom && ticks_ < kJumpTo) input.buttons |= Input::kJump;
  game_.advance(std::array{input});
}

void SettingsPreview::draw(GameView& view, Settings settings, const KeyHints& keys, const Overlay& menu,
                           double seconds) {
  const Scene scene = game_.scene(settings.ball);
  netGraph_.add(sampleConnection());
  HudStatus status;
  status.timer = settings.timer;
  status.keys = keys;
  if (settings.netGraph) status.netGraph = &netGraph_;
  settings.netGraph = false;  // that of the view is of a match
  view.look({});
  view.setFlights(false);
  view.draw(&scene, status, settings, menu, seconds);
}

}  // namespace platon
