#include "client/play/game_desk.h"

#include <algorithm>
#include <utility>

namespace platon {
namespace {

constexpr double kFaultSeconds = 12;

std::filesystem::path recentServersFile() {
  const std::filesystem::path folder = stateFolder();
  return folder.empty() ? folder : folder / "recent_servers";
}

bool namesSomething(const ClientOptions& options) {
  return options.server || !options.level.empty() || options.demo || !options.replay.empty();
}

}  // namespace

GameDesk::GameDesk(const ClientOptions& given, const Clock& goesBy, Window& shownIn, Audio::Open openSound)
    : options(given),
      clock(goesBy),
      recentServers(recentServersFile()),
      interface(settingsFile.load()),
      window(shownIn),
      view(std::max(window.pixelWidth(), 1u), std::max(window.pixelHeight(), 1u)),
      sound(std::move(openSound)),
      hints(interface.settings()),
      named{options.seconds.has_value(), namesSomething(options)} {
  view.draw(nullptr, {.message = "Loading …"}, Settings(), Overlay(), 0);
  if (window.onScreen()) view.present();
  window.show();
  menu.setClipboard([this] { return window.clipboard(); });
  if (!settingsFile.fault().empty()) tell(settingsFile.fault(), kFaultSeconds);
  fit();
}

std::optional<Action> GameDesk::handle(const KeyEvent& event, bool inMenu) {
  padRepeat_.observe(event, clock.now());
  if (event.kind == KeyEvent::Kind::kPress) view.skip();
  const std::optional<Action> action = interface.handle(event, inMenu);
  if (action == Action::kTakePicture) pictureAsked_ = true;
  return action;
}

void GameDesk::update(const Frame& frame) {
  fit();
  window.setFullscreen(settings().fullscreen);
  window.setVsync(settings().vsync);
  sound.menu(menu.takeFeedback());
  settingsFile.update(settings(), frame.now);
  view.setQuality(trial.quality(settings().quality));
  toldSeconds_ -= frame.seconds;
  if (toldSeconds_ <= 0) tell("");
  if (const std::optional<std::string> report = pictures_.takeReport()) tell(*report);
}

void GameDesk::fit() {
  view.resize(window.pixelWidth(), window.pixelHeight());
  menu.resize(view.screenWidth(), view.textScale(settings()));
}

bool GameDesk::drawPreview(bool still, const Frame& frame) {
  if (!still || !menu.showsMotion()) {
    preview_.reset();
    return false;
  }
  playMusic(frame);
  if (!preview_) preview_ = std::make_unique<SettingsPreview>();
  preview_->advance(settings(), frame.seconds);
  preview_->draw(view, settings(), interface.keyHints(), menu.overlay(view.font(), false), frame.seconds);
  present();
  return true;
}

void GameDesk::present() {
  if (!view.painted()) return;
  if (window.onScreen()) view.present();
  if (std::exchange(pictureAsked_, false)) pictures_.write(view.read());
}

void GameDesk::finish() {
  if (!options.screenshot.empty()) writeScreenshot(view.read(), options.screenshot);
  settingsFile.save(settings());
}

void GameDesk::tell(const std::string& text, double seconds) {
  told_ = text;
  toldSeconds_ = seconds;
  view.setNotice(text);
}

}  // namespace platon
