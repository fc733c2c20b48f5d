#include "client/offscreen_play.h"

#include <chrono>
#include <cstdio>
#include <thread>

#include "client/client_error.h"
#include "client/image.h"
#include "client/steady_now.h"

namespace platon {

namespace {

constexpr Moment kBeat = std::chrono::milliseconds(4);

Moment fromSeconds(double seconds) { return Moment(static_cast<Moment::rep>(seconds * 1e6)); }

}  // namespace

OffscreenPlay::OffscreenPlay(const ClientOptions& options, const ServerAddress& server)
    : options_(options), match_(options, server, steadyNow()) {}

void OffscreenPlay::run(const std::function<bool()>& stopAsked) {
  const Controls controls = [this](const Game& game, std::uint32_t slot) {
    return options_.demo ? demo_.choose(game, slot) : Input{};
  };
  const Moment end = steadyNow() + fromSeconds(options_.seconds.value_or(kSeconds));
  while (steadyNow() < end && !stopAsked()) {
    match_.update(steadyNow(), controls);
    if (match_.client().ending()) throw ClientError(ClientError::kFailed, *match_.client().ending());
    std::this_thread::sleep_for(kBeat);
  }
  if (!options_.screenshot.empty()) takeScreenshot();
  match_.leave();
}

void OffscreenPlay::takeScreenshot() {
  const std::optional<Scene> scene = match_.scene(steadyNow());
  view_.draw(scene ? &*scene : nullptr, {match_.message(), false, false}, Settings(), Menu(), 0);
  writePng(view_.read(), options_.screenshot);
  std::printf("screenshot: %s\n", options_.screenshot.c_str());
}

}  // namespace platon
