#include "client/play/replay_play.h"

#include <array>
#include <chrono>
#include <cstdio>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>

#include "client/gl/image.h"
#include "client/replay/replay_file.h"
#include "client/ui/hud.h"
#include "client/ui/replay_bar.h"
#include "protocol/program_error.h"

namespace platon {

namespace {

constexpr std::uint32_t kWidth = 1280;
constexpr std::uint32_t kHeight = 720;
constexpr Moment kMinFrameTime = std::chrono::milliseconds(2);  // for drivers that do not wait for the vertical blank

std::optional<Window> openWindow(bool offscreen) {
  if (offscreen) return std::nullopt;
  try {
    return std::optional<Window>(std::in_place, "Replay – Platon", static_cast<int>(kWidth), static_cast<int>(kHeight));
  } catch (const std::runtime_error& error) {
    throw ProgramError(ProgramError::kUsage,
                       std::string(error.what()) + "; to draw a replay without one, use --offscreen --screenshot");
  }
}

std::optional<Offscreen> openOffscreen(bool offscreen) {
  if (!offscreen) return std::nullopt;
  return std::optional<Offscreen>(std::in_place);
}

}  // namespace

std::shared_ptr<const Replay> loadReplay(const std::filesystem::path& file) {
  auto replay = readReplay(file);
  if (const auto* fault = std::get_if<std::string>(&replay)) throw ProgramError(ProgramError::kLevel, *fault);
  return std::get<std::shared_ptr<const Replay>>(std::move(replay));
}

ReplayPlay::ReplayPlay(const ClientOptions& options, const Settings& settings, const Clock& clock)
    : options_(options),
      settings_(settings),
      clock_(clock),
      viewer_(loadReplay(options.replay)),
      window_(openWindow(options.offscreen)),
      offscreen_(openOffscreen(options.offscreen)),
      view_(kWidth, kHeight),
      startedAt_(clock_.now()) {
  settings_.netGraph = false;
}

void ReplayPlay::run(const std::function<bool()>& stopRequested) {
  if (window_) {
    runWindow(stopRequested);
  } else {
    viewer_.advance(options_.seconds.value_or(viewer_.player().replay().ticks()));
    draw(0);
  }
  if (!options_.screenshot.empty()) takeScreenshot();
}

void ReplayPlay::runWindow(const std::function<bool()>& stopRequested) {
  Moment before = clock_.now();
  for (Moment now = before; timeIsLeft(now) && !viewer_.leaving() && !stopRequested(); now = clock_.now()) {
    handleEvents();
    const double seconds = toSeconds(now - before);
    before = now;
    viewer_.advance(seconds);
    draw(seconds);
    view_.present();
    window_->show();
    clock_.sleepUntil(now + kMinFrameTime);
  }
}

bool ReplayPlay::timeIsLeft(Moment now) const {
  return !window_->closing() && (!options_.seconds || toSeconds(now - startedAt_) < *options_.seconds);
}

void ReplayPlay::handleEvents() {
  window_->poll();
  view_.resize(window_->pixelWidth(), window_->pixelHeight());
  for (const KeyEvent& event : window_->takeKeyEvents()) viewer_.handle(event);
  for (const PointerEvent& event : window_->takePointerEvents()) viewer_.handle(event, view_.screenWidth());
  window_->setFullscreen(viewer_.fullscreen());
}

void ReplayPlay::draw(double seconds) {
  const Scene scene = viewer_.scene();
  const std::array bar{makeReplayBar(viewer_.status(), view_.font(), view_.screenWidth())};
  view_.draw(&scene, HudStatus(), settings_, Overlay(), seconds, bar);
}

void ReplayPlay::takeScreenshot() {
  writePng(view_.read(), options_.screenshot);
  std::printf("screenshot: %s\n", options_.screenshot.c_str());
}

}  // namespace platon
