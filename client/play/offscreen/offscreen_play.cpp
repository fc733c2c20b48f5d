#include "client/play/offscreen/offscreen_play.h"

#include <chrono>
#include <cstdio>
#include <string>

#include "client/gl/image.h"
#include "protocol/program_error.h"

namespace platon {

namespace {

constexpr Moment kUpdateInterval = std::chrono::milliseconds(4);

Moment fromSeconds(double seconds) { return Moment(static_cast<Moment::rep>(seconds * 1e6)); }

}  // namespace

OffscreenPlay::OffscreenPlay(const ClientOptions& options, const ServerAddress& server, const Clock& clock)
    : options_(options), clock_(clock), match_(options, server, clock.now()) {}

void OffscreenPlay::run(const std::function<bool()>& stopRequested) {
  const Controls controls = [this](const Game& game, std::uint32_t slot) {
    return options_.demo ? demo_.choose(game, slot) : Input{};
  };
  const Moment end = clock_.now() + fromSeconds(options_.seconds.value_or(kSeconds));
  for (Moment now = clock_.now(); now < end && !stopRequested(); now = clock_.now()) {
    match_.update(now, controls);
    if (match_.client().ending()) throw ProgramError(ProgramError::kFailed, *match_.client().ending());
    clock_.sleepUntil(now + kUpdateInterval);
  }
  if (!options_.screenshot.empty()) takeScreenshot();
  const std::string unfinished = match_.message();
  match_.leave(clock_);
  if (!unfinished.empty()) throw ProgramError(ProgramError::kFailed, "time limit reached: " + unfinished);
}

void OffscreenPlay::takeScreenshot() {
  const Moment now = clock_.now();
  const std::optional<Scene> scene = match_.scene(now);
  view_.setQuality(kBestQuality);
  view_.draw(scene ? &*scene : nullptr, match_.hudStatus(now, false), Settings(), Overlay(), 0);
  writePng(view_.read(), options_.screenshot);
  std::printf("screenshot: %s\n", options_.screenshot.c_str());
}

}  // namespace platon
