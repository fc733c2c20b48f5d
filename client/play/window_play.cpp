#include "client/play/window_play.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <stdexcept>
#include <string>

#include "client/gl/image.h"
#include "protocol/program_error.h"

namespace platon {

namespace {

constexpr int kWidth = 1280;
constexpr int kHeight = 720;
constexpr Moment kShortestFrame = std::chrono::milliseconds(2);  // where showing does not wait for a screen

Window openWindow() {
  try {
    return Window("Platon", kWidth, kHeight);
  } catch (const std::runtime_error& error) {
    throw ProgramError(ProgramError::kUsage, std::string(error.what()) + "; --offscreen plays without one");
  }
}

}  // namespace

WindowPlay::WindowPlay(const ClientOptions& options, const ServerAddress& server, const Clock& clock)
    : options_(options),
      clock_(clock),
      settings_(settingsFile_.load()),
      window_(openWindow()),
      view_(std::max(window_.pixelWidth(), 1u), std::max(window_.pixelHeight(), 1u)),
      match_(options, server, clock.now()),
      begunAt_(clock.now()),
      drawnAt_(begunAt_) {
  if (settings_.fullscreen) window_.setFullscreen(true);
}

void WindowPlay::run(const std::function<bool()>& stopAsked) {
  const Controls controls = [this](const Game& game, std::uint32_t slot) { return choose(game, slot); };
  for (Moment now = clock_.now(); goesOn(now) && !stopAsked(); now = clock_.now()) {
    window_.poll();
    takePresses();
    match_.update(now, controls);
    if (match_.client().ending() && !toldEnding_) tellEnding();
    draw(now);
    window_.show();
    clock_.sleepUntil(now + kShortestFrame);
  }
  if (!options_.screenshot.empty()) takeScreenshot();
  settingsFile_.save(settings_);
  match_.leave(clock_);
}

bool WindowPlay::goesOn(Moment now) const {
  const bool timeLeft = !options_.seconds || toSeconds(now - begunAt_) < *options_.seconds;
  return timeLeft && !window_.closing() && !menu_.leaving();
}

void WindowPlay::tellEnding() {
  const std::string& reason = *match_.client().ending();
  if (!match_.client().welcomed()) throw ProgramError(ProgramError::kFailed, reason);
  std::fprintf(stderr, "platon-client: %s\n", reason.c_str());
  toldEnding_ = true;
}

void WindowPlay::takePresses() {
  for (const Window::Press press : window_.takePresses()) take(press);
}

void WindowPlay::take(Window::Press press) {
  switch (press) {
    case Window::Press::kMenu:
      return menu_.toggle();
    case Window::Press::kUp:
      return menu_.take(Menu::Step::kUp, settings_);
    case Window::Press::kDown:
      return menu_.take(Menu::Step::kDown, settings_);
    case Window::Press::kLeft:
      return menu_.take(Menu::Step::kLess, settings_);
    case Window::Press::kRight:
      return menu_.take(Menu::Step::kMore, settings_);
    case Window::Press::kChoose:
      if (menu_.open()) menu_.choose(settings_);
      break;
    case Window::Press::kHelp:
      help_ = !help_;
      break;
    case Window::Press::kNetGraph:
      settings_.netGraph = !settings_.netGraph;
      break;
    case Window::Press::kFullscreen:
      settings_.fullscreen = !settings_.fullscreen;
      break;
  }
  window_.setFullscreen(settings_.fullscreen);
}

Input WindowPlay::choose(const Game& game, std::uint32_t slot) {
  if (options_.demo) return demo_.choose(game, slot);
  return steering_.input(menu_.open() ? HeldKeys() : window_.held(), view_.roll(), settings_.controls);
}

void WindowPlay::draw(Moment now) {
  view_.resize(window_.pixelWidth(), window_.pixelHeight());
  const std::optional<Scene> scene = match_.scene(now);
  if (scene) view_.netGraph().add(meter_.sample(match_.client(), now));
  const HudStatus status{match_.message(), match_.client().ending().has_value(), help_};
  view_.draw(scene ? &*scene : nullptr, status, settings_, menu_, toSeconds(now - drawnAt_));
  view_.present();
  drawnAt_ = now;
}

void WindowPlay::takeScreenshot() {
  writePng(view_.read(), options_.screenshot);
  std::printf("screenshot: %s\n", options_.screenshot.c_str());
}

}  // namespace platon
