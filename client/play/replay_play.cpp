#include "client/play/replay_play.h"

#include <algorithm>
#include <array>
#include <utility>

#include "client/hud/hud.h"
#include "client/replay/replay_file.h"
#include "client/ui/replay_bar.h"
#include "client/ui/text_scale.h"

namespace platon {

void drawReplay(const ReplayViewer& viewer, GameView& view, Settings settings, double seconds,
                const ReplayContext& context) {
  settings.netGraph = false;
  const Scene scene = viewer.scene();
  const float scale = view.textScale(settings);
  ReplayStatus status = viewer.status();
  status.gamepad = context.gamepad;
  const Overlay unscaled = makeReplayBar(status, view.font(), view.screen() / scale);
  const std::array bar{scaledBy(unscaled, scale)};
  HudStatus shown;
  shown.medal = ownMedalText(scene, context.medals);
  view.draw(&scene, shown, settings, Overlay(), seconds, bar);
}

ReplayPlay::ReplayPlay(std::filesystem::path file) : file_(std::move(file)) {
  reading_.add([read = file_, progress = progress_](const std::stop_token& stop) {
    return readReplay(read, stop, progress.get());
  });
}

void ReplayPlay::advance(double seconds) {
  if (auto read = reading_.poll()) return take(std::move(*read));
  if (viewer_) viewer_->advance(std::min(seconds, kMaxSeconds));
}

void ReplayPlay::take(JobResult<Read> read) {
  if (!read.value) {
    fault_ = file_.string() + ": cannot be read: " + read.fault;
  } else if (auto* fault = std::get_if<std::string>(&*read.value)) {
    fault_ = std::move(*fault);
  } else {
    viewer_.emplace(std::get<std::shared_ptr<const Replay>>(std::move(*read.value)));
  }
}

void ReplayPlay::handle(const KeyEvent& event) {
  const bool leaves = event.key == Key::kEscape || event.key == Key::kPadB || event.key == Key::kPadStart;
  if (leaves && event.kind == KeyEvent::Kind::kPress) leaving_ = true;
  if (viewer_) viewer_->handle(event);
}

void ReplayPlay::handle(PointerEvent event, const GameView& view, const Settings& settings) {
  if (goesBack(event)) leaving_ = true;
  const float scale = view.textScale(settings);
  event.place /= scale;
  if (viewer_) viewer_->handle(event, view.screen() / scale);
}

std::string ReplayPlay::readingText() const {
  return "reading " + file_.filename().string() + " … " + std::to_string(progress_->load()) + " %";
}

void ReplayPlay::draw(GameView& view, const Settings& settings, double seconds, const ReplayContext& context) const {
  if (viewer_) return drawReplay(*viewer_, view, settings, seconds, context);
  HudStatus status;
  status.message = readingText();
  view.draw(nullptr, status, settings, Overlay(), seconds);
}

}  // namespace platon
