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

// Returns when the file has been read.
ReplayPlay readToPlay(const std::string& file, const Clock& clock, const std::function<bool()>& stopRequested) {
  ReplayPlay replay(file);
  Moment toldAt = clock.now();
  for (;; clock.sleepUntil(clock.now() + kPollInterval)) {
    if (stopRequested()) throw ProgramError(ProgramError::kFailed, file + ": " + Replay::kStopped);
    replay.advance(0);
    if (!replay.fault().empty()) throw ProgramError(ProgramError::kInvalid, replay.fault());
    if (replay.viewer() != nullptr) return replay;
    if (clock.now() - toldAt < kToldInterval) continue;
    toldAt = clock.now();
    std::fprintf(stderr, "platon-client: %s\n", replay.readingText().c_str());
  }
}

}  // namespace

OffscreenReplay::OffscreenReplay(const ClientOptions& options, const Settings& settings, const Clock& clock,
                                 const std::function<bool()>& stopRequested)
    : options_(options),
      settings_(settings),
      replay_(readToPlay(options.replay, clock, stopRequested)),
      view_(kPictureWidth, kPictureHeight) {}

void OffscreenReplay::run() {
  replay_.skipTo(options_.seconds.value_or(viewer().player().replay().ticks()));
  drawReplay(viewer(), view_, settings_, 0);
  if (options_.screenshot.empty()) return;
  writePng(view_.read(), options_.screenshot);
  std::printf("screenshot: %s\n", options_.screenshot.c_str());
}

}  // namespace platon
