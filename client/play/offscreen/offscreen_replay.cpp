#include "client/play/offscreen/offscreen_replay.h"

#include <cstdio>
#include <memory>
#include <string>
#include <variant>

#include "client/gl/image.h"
#include "client/play/play_window.h"
#include "client/play/replay_play.h"
#include "client/replay/replay_file.h"
#include "protocol/program_error.h"

namespace platon {
namespace {

std::shared_ptr<const Replay> load(const std::string& file) {
  auto replay = readReplay(file);
  if (const auto* fault = std::get_if<std::string>(&replay)) throw ProgramError(ProgramError::kLevel, *fault);
  return std::get<std::shared_ptr<const Replay>>(std::move(replay));
}

}  // namespace

OffscreenReplay::OffscreenReplay(const ClientOptions& options, const Settings& settings)
    : options_(options), settings_(settings), viewer_(load(options.replay)), view_(kPictureWidth, kPictureHeight) {}

void OffscreenReplay::run() {
  viewer_.advance(options_.seconds.value_or(viewer_.player().replay().ticks()));
  drawReplay(viewer_, view_, settings_, 0);
  if (options_.screenshot.empty()) return;
  writePng(view_.read(), options_.screenshot);
  std::printf("screenshot: %s\n", options_.screenshot.c_str());
}

}  // namespace platon
