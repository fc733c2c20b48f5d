#include "client/play/title_screen.h"

#include <algorithm>
#include <array>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "client/menu/menu_layout.h"
#include "client/menu/pages/failure_page.h"
#include "client/menu/pages/levels_page.h"
#include "client/play/match_screen.h"
#include "client/play/replay_screen.h"

namespace platon {
namespace {

MatchChoice choiceOf(const ClientOptions& options) {
  MatchChoice choice{options.server, options.knowledge.password};
  if (!options.level.empty()) choice.own.levels = {options.level};
  choice.own.waitsForOne = !options.demo;
  return choice;
}

std::string failureTitle(const ProgramError& error, const MatchChoice& choice) {
  if (error.exitCode() == ProgramError::kInvalid) return "The level is invalid";
  return choice.server ? "The server cannot be joined" : "The game cannot be started";
}

}  // namespace

void TitleGame::show(const std::shared_ptr<const Level>& level) {
  if (game_ && game_->game().sharedLevel() == level) return;
  game_.emplace(level, std::vector<std::string>{""});
  begin();
}

// The ball lies on its floor already.
void TitleGame::begin() {
  constexpr int kSettleTicks = 60;
  game_->begin();
  for (int tick = 0; tick < kSettleTicks; ++tick) game_->advance(std::array{Input{Input::kPresent}});
  stroll_ = {};
}

void TitleGame::advance(double seconds) {
  due_ = std::min(due_ + seconds * kTicksPerSecond, double{kMaxTicks});
  for (; due_ >= 1; --due_) {
    if (game().over()) begin();
    game_->advance(std::array{stroll_.choose(game(), 0)});
  }
}

TitleScreen::TitleScreen(GameDesk& desk)
    : desk_(&desk),
      front_(desk.menu, desk.settings(), desk.recentServers,
             {[this](const MatchChoice& choice) { start(choice); }, [this] { next_ = Quit(); },
              [this](const std::filesystem::path& file) { watch(file); },
              [this](const std::filesystem::path& file, SolidKind solid) { edit(file, solid); }},
             {desk.options.listUrl, desk.options.name}) {
  if (!desk.options.replay.empty()) {
    watch(desk.options.replay);
  } else if (desk.named.pending) {
    start(choiceOf(desk.options));
  } else {
    front_.showTitle();
  }
}

Next TitleScreen::handle(const WindowEvent& event) {
  if (const auto* const key = std::get_if<KeyEvent>(&event)) handleKey(*key);
  if (const auto* const pointer = std::get_if<PointerEvent>(&event)) desk_->menu.handle(*pointer, desk_->view.font());
  if (const auto* const lost = std::get_if<GamepadLost>(&event)) desk_->interface.loseGamepad(lost->pad);
  if (const auto* const dropped = std::get_if<FilesDropped>(&event)) watch(dropped->paths.front());
  if (std::holds_alternative<CloseAsked>(event)) next_ = Quit();
  return std::exchange(next_, Stay());
}

void TitleScreen::handleKey(const KeyEvent& event) {
  desk_->handle(event, desk_->menu.isOpen());
  desk_->menu.handle(event, desk_->view.font());
}

Next TitleScreen::update(const Frame& frame) {
  if (const auto again = desk_->repeated(desk_->menu.isOpen(), frame)) handleKey(*again);
  desk_->update(frame);
  return std::exchange(next_, Stay());
}

Next TitleScreen::reveal(const Ending& ending) {
  if (const auto* const choice = std::get_if<MatchChoice>(&ending)) {
    start(*choice);
  } else if (const auto* const refused = std::get_if<MatchRefused>(&ending)) {
    refuse(*refused);
  } else if (const auto* const end = std::get_if<ReplayEnd>(&ending)) {
    stopWatching(*end);
  } else if (session_) {
    desk_->settings().fullscreen = session_->editor().fullscreen();
    session_.reset();
    front_.showEditor();
  } else {
    leaveMatch();
  }
  return std::exchange(next_, Stay());
}

void TitleScreen::start(const MatchChoice& choice) {
  choice_ = choice;
  choice_.name = desk_->settings().name;
  try {
    next_ = Push{std::make_unique<MatchScreen>(*desk_, choice_, medals())};
    desk_->menu.close();
  } catch (const ProgramError& error) {
    refuse({error});
  } catch (const std::runtime_error& error) {
    refuse({ProgramError(ProgramError::kFailed, error.what())});
  }
}

void TitleScreen::refuse(const MatchRefused& refused) {
  if (desk_->named.fail(refused.error)) {
    next_ = Quit{refused.error};
  } else if (refused.asksPassword) {
    front_.askPassword(*choice_.server, !choice_.password.empty());
  } else if (choice_.own.listens) {
    front_.refuseHost(refused.error.what());
  } else {
    desk_->menu.open([this, refused] {
      return failurePage(
          failureTitle(refused.error, choice_), refused.error.what(), [this] { start(MatchChoice(choice_)); },
          [this] { leaveMatch(); }, joinItem(refused.next, [this](const MatchChoice& choice) { start(choice); }));
    });
  }
}

void TitleScreen::leaveMatch() {
  desk_->named.pending = false;
  front_.showTitle();
}

MedalsOf TitleScreen::medals() {
  return [this](const std::shared_ptr<const Level>& level) { return front_.medalsOf(level); };
}

void TitleScreen::watch(const std::filesystem::path& file) {
  next_ = Push{std::make_unique<ReplayScreen>(*desk_, file, medals(), ReplayScreen::Behind::kTitle)};
  desk_->menu.close();
}

void TitleScreen::edit(const std::filesystem::path& file, SolidKind solid) {
  try {
    session_.emplace(file.string(), solid);
    next_ = Push{std::make_unique<EditorScreen>(*session_, desk_->window, desk_->settings(), "")};
    desk_->menu.close();
  } catch (const ProgramError& error) {
    front_.showEditor(error.what());
  }
}

void TitleScreen::stopWatching(const ReplayEnd& end) {
  if (end.fault.empty()) {
    desk_->named.pending = false;
    front_.showRun(end.file);
  } else if (const ProgramError error(ProgramError::kInvalid, end.fault); desk_->named.fail(error)) {
    next_ = Quit{error};
  } else {
    desk_->menu.open([this, end] {
      return unplayablePage(
          end, [this, end] { watch(end.file); }, [this, end] { stopWatching({end.file}); });
    });
  }
}

void TitleScreen::draw(const Frame& frame) {
  if (desk_->drawPreview(true, frame)) return;
  desk_->playMusic(frame);
  front_.update(frame.now);
  drawMenu(frame);
  desk_->present();
}

void TitleScreen::drawMenu(const Frame& frame) {
  GameView& view = desk_->view;
  const Settings& settings = desk_->settings();
  const std::shared_ptr<const Level> level = front_.shownLevel();
  if (level) game_.show(level);
  Overlay menu = desk_->menu.overlay(view.font(), false);
  if (!game_.shows()) return view.draw(nullptr, HudStatus(), settings, menu, frame.seconds);
  const double seconds = settings.comfort.reducedMotion ? 0 : frame.seconds;
  game_.advance(seconds);
  turntable_.show(game_.scene(settings.ball), seconds);
  const float width = view.screenWidth();
  const float scale = view.textScale(settings);
  // The notice stands where the card does.
  if (level && desk_->told().empty()) addLevelCard(menu, front_.entryOf(level), view.font(), width, scale);
  const bool beside = width > Turntable::kWide * Overlay::kHeight;
  const float left = beside ? scale * endOfLeftColumn(view.screen() / scale) : 0;
  view.drawBeside(turntable_.scene(), turntable_.camera(view.width(), view.height()), settings, menu, left);
}

}  // namespace platon
