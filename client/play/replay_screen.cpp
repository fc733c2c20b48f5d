#include "client/play/replay_screen.h"

#include <algorithm>
#include <array>
#include <utility>

#include "client/hud/hud.h"
#include "client/menu/pages/failure_page.h"
#include "client/replay/replay.h"
#include "client/ui/overlay.h"
#include "client/ui/replay_bar.h"

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
  shown.medals = context.medals;
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

bool ReplayPlay::handle(const KeyEvent& event) {
  if (viewer_) viewer_->handle(event);
  const bool leaves = event.key == Key::kEscape || event.key == Key::kPadB || event.key == Key::kPadStart;
  return leaves && event.kind == KeyEvent::Kind::kPress;
}

bool ReplayPlay::handle(PointerEvent event, const GameView& view, const Settings& settings) {
  const float scale = view.textScale(settings);
  event.place /= scale;
  if (viewer_) viewer_->handle(event, view.screen() / scale);
  return goesBack(event);
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

Next ReplayScreen::handle(const WindowEvent& event) {
  if (const auto* const key = std::get_if<KeyEvent>(&event)) return handleKey(*key);
  if (const auto* const pointer = std::get_if<PointerEvent>(&event)) {
    if (play_.handle(*pointer, desk_->view, desk_->settings())) return Close{ReplayEnd{play_.file()}};
    desk_->menu.handle(*pointer, desk_->view.font());  // closed during a replay: it notes where the pointer is
  }
  if (const auto* const lost = std::get_if<GamepadLost>(&event)) desk_->interface.loseGamepad(lost->pad);
  if (const auto* const dropped = std::get_if<FilesDropped>(&event)) return drop(dropped->paths.front());
  if (std::holds_alternative<CloseAsked>(event)) return Quit();
  return Stay();
}

Next ReplayScreen::handleKey(const KeyEvent& event) {
  desk_->handle(event, true);
  if (play_.handle(event)) return Close{ReplayEnd{play_.file()}};
  return Stay();
}

// A recording that is dropped on a game would end it.
Next ReplayScreen::drop(const std::filesystem::path& file) {
  if (behind_ == Behind::kTitle) return Replace{std::make_unique<ReplayScreen>(*desk_, file, medalsOf_, behind_)};
  desk_->tell(kDropRefused);
  return Stay();
}

Next ReplayScreen::update(const Frame& frame) {
  desk_->update(frame);
  if (const auto again = desk_->repeated(true, frame)) play_.handle(*again);
  play_.advance(frame.seconds);
  if (!play_.fault().empty()) return Close{ReplayEnd{play_.file(), play_.fault()}};
  if (viewer() != nullptr && desk_->named.pending) desk_->named.succeed();
  return Stay();
}

void ReplayScreen::draw(const Frame& frame) {
  desk_->playMusic(frame);
  GameView& view = desk_->view;
  view.setFlights(false);
  view.look({});
  if (viewer() != nullptr && !medals_) medals_ = medalsOf_(viewer()->player().replay().level());
  const ReplayContext context{desk_->interface.keyHints().gamepad(), medals_.value_or(std::nullopt)};
  play_.draw(view, desk_->settings(), frame.seconds, context);
  desk_->present();
}

MenuPage unplayablePage(const ReplayEnd& end, const std::function<void()>& retry, const std::function<void()>& back) {
  return failurePage("The recording cannot be played", end.fault, retry, back);
}

}  // namespace platon
