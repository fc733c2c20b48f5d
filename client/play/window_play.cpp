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
constexpr Moment kMinFrameTime = std::chrono::milliseconds(2);  // for drivers that do not wait for the vertical blank

Window openWindow() {
  try {
    return Window("Platon", kWidth, kHeight);
  } catch (const std::runtime_error& error) {
    throw ProgramError(ProgramError::kUsage, std::string(error.what()) + "; to play without one, use --offscreen");
  }
}

}  // namespace

WindowPlay::WindowPlay(const ClientOptions& options, const ServerAddress& server, const Clock& clock)
    : options_(options),
      clock_(clock),
      interface_(settingsFile_.load()),
      window_(openWindow()),
      view_(std::max(window_.pixelWidth(), 1u), std::max(window_.pixelHeight(), 1u)),
      match_(options, server, clock.now()),
      startedAt_(clock.now()),
      drawnAt_(startedAt_) {
  view_.enableFlights();
}

void WindowPlay::run(const std::function<bool()>& stopRequested) {
  const Controls controls = [this](const Game& game, std::uint32_t slot) { return choose(game, slot); };
  for (Moment now = clock_.now(); shouldContinue(now) && !stopRequested(); now = clock_.now()) {
    handleKeys();
    match_.update(now, controls);
    if (match_.client().ending() && !endingReported_) reportEnding();
    draw(now);
    window_.show();
    clock_.sleepUntil(now + kMinFrameTime);
  }
  if (!options_.screenshot.empty()) takeScreenshot();
  settingsFile_.save(interface_.settings());
  match_.leave(clock_);
}

bool WindowPlay::shouldContinue(Moment now) const {
  const bool timeLeft = !options_.seconds || toSeconds(now - startedAt_) < *options_.seconds;
  return timeLeft && !window_.closing() && !interface_.menu().leaving();
}

void WindowPlay::reportEnding() {
  const std::string& reason = *match_.client().ending();
  if (!match_.client().welcomed()) throw ProgramError(ProgramError::kFailed, reason);
  std::fprintf(stderr, "platon-client: %s\n", reason.c_str());
  endingReported_ = true;
}

void WindowPlay::handleKeys() {
  window_.poll();
  for (const KeyEvent& event : window_.takeKeyEvents()) {
    if (event.kind == KeyEvent::Kind::kPress) view_.skip();
    const bool wasOpen = interface_.menu().open();
    interface_.handle(event);
    sound_.key(event, wasOpen || interface_.menu().open());
  }
  if (interface_.takeVote()) match_.toggleVote();
  window_.setFullscreen(interface_.settings().fullscreen);
}

Input WindowPlay::choose(const Game& game, std::uint32_t slot) {
  if (options_.demo) return demo_.choose(game, slot);
  const HeldKeys held = interface_.takeHeld();
  if (held != HeldKeys()) view_.skip();
  return steering_.input(held, view_.roll(), interface_.settings().controls);
}

void WindowPlay::draw(Moment now) {
  view_.resize(window_.pixelWidth(), window_.pixelHeight());
  match_.show(interface_.settings());
  const std::optional<Scene> scene = match_.scene(now);
  if (scene) view_.netGraph().add(meter_.sample(match_.client(), now));
  const HudStatus status = match_.hudStatus(now, interface_.helpShown());
  view_.look(interface_.look());
  view_.draw(scene ? &*scene : nullptr, status, interface_.settings(), interface_.menu(), toSeconds(now - drawnAt_));
  view_.present();
  playSounds(scene ? &*scene : nullptr, status, toSeconds(now - drawnAt_));
  drawnAt_ = now;
}

// During an outage nothing is heard.
void WindowPlay::playSounds(const Scene* scene, const HudStatus& status, double seconds) {
  const NetworkClient& client = match_.client();
  const std::optional<double> next = status.summary ? std::optional(status.summary->secondsLeft) : std::nullopt;
  sound_.update(client.outage() ? nullptr : client.session(), scene, next, interface_.settings(), seconds);
}

void WindowPlay::takeScreenshot() {
  writePng(view_.read(), options_.screenshot);
  std::printf("screenshot: %s\n", options_.screenshot.c_str());
}

}  // namespace platon
