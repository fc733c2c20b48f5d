#include "client/play/offscreen/offscreen_replay.h"

#include <chrono>
#include <cstdio>

#include "client/gl/image.h"
#include "client/play/play_window.h"
#include "protocol/program_error.h"

namespace platon {
namespace {

constexpr Moment kPollInterval = std::chrono::milliseconds(5);
constexpr Moment kToldInterval = std::chrono::seconds(2);

}  // namespace

OffscreenReplay::OffscreenReplay(const ClientOptions& options, const Settings& settings, const Clock& clock,
                                 const std::function<bool()>& stopRequested)
    : options_(options), settings_(settings), replay_(options.replay), view_(kPictureWidth, kPictureHeight) {
  read(clock, stopRequested);
}

void OffscreenReplay::read(const Clock& clock, const std::function<bool()>& stopRequested) {
  Moment toldAt = clock.now();
  for (;; clock.sleepUntil(clock.now() + kPollInterval)) {
    if (stopRequested()) throw ProgramError(ProgramError::kFailed, options_.replay + ": " + Replay::kStopped);
    replay_.advance(0);
    if (!replay_.fault().empty()) throw ProgramError(ProgramError::kLevel, replay_.fault());
    if (replay_.viewer() != nullptr) return;
    if (clock.now() - toldAt < kToldInterval) continue;
    toldAt = clock.now();
    std::fprintf(stderr, "platon-client: %s\n", replay_.readingText().c_str());
  }
}

void OffscreenReplay::run() {
  replay_.skipTo(options_.seconds.value_or(viewer().player().replay().ticks()));
  drawReplay(viewer(), view_, settings_, 0);
  if (options_.screenshot.empty()) return;
  writePng(view_.read(), options_.screenshot);
  std::printf("screenshot: %s\n", options_.screenshot.c_str());
}

}  // namespace platon
