#include "client/play/window_play.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <stdexcept>
#include <utility>
#include <variant>

#include "client/gl/gl_loader.h"
#include "client/gl/image.h"
#include "client/menu/menu_layout.h"
#include "client/menu/pages/failure_page.h"
#include "client/menu/pages/level_card.h"
#include "client/play/play_window.h"

namespace platon {
namespace {

constexpr Moment kFaultTime = std::chrono::seconds(12);

bool namesMatch(const ClientOptions& options) { return options.server || !options.level.empty() || options.demo; }

MatchChoice choiceOf(const ClientOptions& options) {
  MatchChoice choice{options.server, options.knowledge.password};
  if (!options.level.empty()) choice.own.levels = {options.level};
  choice.own.waitsForOne = !options.demo;
  return choice;
}

std::filesystem::path recentServersFile() {
  const std::filesystem::path folder = stateFolder();
  return folder.empty() ? folder : folder / "recent_servers";
}

std::string titleOf(const ProgramError& error, const MatchChoice& choice) {
  if (error.exitCode() == ProgramError::kInvalid) return "The level is invalid";
  return choice.server ? "The server cannot be joined" : "The game cannot be started";
}

}  // namespace

WindowPlay::WindowPlay(const ClientOptions& options, const Clock& clock)
    : options_(options),
      clock_(clock),
      interface_(settingsFile_.load()),
      window_(openWindow("to play without one, use --offscreen")),
      view_(std::max(window_.pixelWidth(), 1u), std::max(window_.pixelHeight(), 1u)),
      front_(menu_, interface_.settings(), RecentServers(recentServersFile()),
             {[this](const MatchChoice& choice) { start(choice); }, [this] { leaving_ = true; },
              [this](const std::filesystem::path& file) { watch(file); }},
             options.listUrl),
      hints_(interface_.settings()),
      startedAt_(clock.now()),
      drawnAt_(startedAt_) {
  showLoading(window_, view_);
  if (!settingsFile_.fault().empty()) tell(settingsFile_.fault(), kFaultTime);
  menu_.setClipboard([this] { return window_.clipboard(); });
  named_ = namesMatch(options) || !options.replay.empty();
  if (!options.replay.empty()) {
    watch(options.replay);
  } else if (named_) {
    start(choiceOf(options));
  } else {
    front_.showTitle();
  }
}

void WindowPlay::run(const std::function<bool()>& stopRequested) {
  for (Moment now = clock_.now(); shouldContinue(now) && !stopRequested(); now = clock_.now()) {
    handleEvents();
    settingsFile_.update(interface_.settings(), now);
    updateMatch();
    updateReplay(toSeconds(now - drawnAt_));
    draw(now);
    clock_.sleepUntil(now + frameTimeOf(!window_.focused() || menu_.isOpen(), interface_.settings().frameCap));
  }
  if (!options_.screenshot.empty()) takeScreenshot();
  settingsFile_.save(interface_.settings());
  leaveMatch();
  if (failure_) throw ProgramError(*failure_);
}

bool WindowPlay::shouldContinue(Moment now) const {
  const bool timeLeft = !options_.seconds || toSeconds(now - startedAt_) < *options_.seconds;
  return timeLeft && !window_.closing() && !leaving_;
}

void WindowPlay::handleEvents() {
  window_.poll();
  view_.resize(window_.pixelWidth(), window_.pixelHeight());
  const Settings& settings = interface_.settings();
  menu_.resize(view_.screenWidth(), view_.textScale(settings));
  const auto handleEach = [this](const auto& event) { handle(event); };
  for (const WindowEvent& event : window_.takeEvents()) std::visit(handleEach, event);
  if (const auto again = padRepeat_.repeat(menu_.isOpen() || replay_, clock_.now())) handle(*again);
  if (menu_.isOpen() || replay_) mouseLook_.release();
  if (window_.takeLostGamepad() && interface_.loseGamepad() && match_ && !replay_) matchPages_.loseGamepad(*match_);
  takeDrops();
  if (interface_.takeGoOn() && match_ && match_->alone() && match_->play().roundOver()) match_->skipLevel();
  if (interface_.takeWatch()) spectator_.next();
  // After all events: the character of the key is not part of the text.
  if (interface_.takeSay() && match_) matchPages_.showSay(*match_);
  sound_.menu(menu_.takeDeed());
  window_.setFullscreen(settings.fullscreen);
  window_.setVsync(settings.vsync);
}

void WindowPlay::handle(const KeyEvent& event) {
  padRepeat_.observe(event, clock_.now());
  if (event.kind == KeyEvent::Kind::kPress) view_.skip();
  const bool inMenu = menu_.isOpen();
  interface_.handle(event, inMenu || replay_);
  if (replay_) return replay_->handle(event);
  menu_.handle(event, view_.font());
  if (interface_.takeVote())
    wishNext();
  else if (event.kind == KeyEvent::Kind::kPress)
    skip_.takeBack();
  if (interface_.takeMenu() && match_) matchPages_.showPause(*match_);
}

// The press that closes the menu does not look round.
void WindowPlay::handle(const PointerEvent& event) {
  if (event.kind == PointerEvent::Kind::kPress) view_.skip();
  const bool inGame = !menu_.isOpen() && !replay_;
  if (replay_) replay_->handle(event, view_, interface_.settings());
  menu_.handle(event, view_.font());  // closed during a replay: it notes where the pointer is
  if (inGame) mouseLook_.handle(event);
}

void WindowPlay::wishNext() {
  if (!match_) return;
  // Of a level for several players nobody who is alone has anything to lose.
  const std::shared_ptr<const Level> level = match_->play().level();
  const bool losesNothing = match_->play().roundOver() || (level && level->players > 1);
  if (!match_->alone() || skip_.wish(losesNothing)) match_->skipLevel();
}

void WindowPlay::tell(const std::string& text, Moment time) {
  told_ = text;
  toldUntil_ = drawnAt_ + time;
}

Input WindowPlay::choose(const Game& game, std::uint32_t slot) {
  if (options_.demo) return demo_.choose(game, slot);
  const HeldKeys held = interface_.takeHeld(menu_.isOpen() || replay_);
  if (held != HeldKeys()) view_.skip();
  hints_.observe(game, slot, interface_.settings());
  return steering_.input(held, view_.roll(), interface_.settings().controls);
}

void WindowPlay::start(const MatchChoice& choice) {
  leaveMatch();
  choice_ = choice;
  next_.reset();
  endingShown_ = remembered_ = false;
  meter_ = NetMeter();
  try {
    match_.emplace(options_, choice, clock_);
    menu_.close();
  } catch (const ProgramError& error) {
    fail(error);
  } catch (const std::runtime_error& error) {
    fail(ProgramError(ProgramError::kFailed, error.what()));
  }
}

void WindowPlay::updateMatch() {
  if (!match_) return;
  match_->setSpeed(interface_.settings().gameSpeed / 100);
  match_->update(menu_.isOpen() || replay_,
                 [this](const Game& game, std::uint32_t slot) { return choose(game, slot); });
  const NetworkClient& client = match_->play().client();
  if (client.welcomed() && !remembered_) {
    if (choice_.server) front_.recent().remember(*choice_.server);
    remembered_ = true;
    named_ = false;
    failure_.reset();
  }
  if (client.ending() && !endingShown_) checkEnding();
}

void WindowPlay::checkEnding() {
  endingShown_ = true;
  const NetworkClient& client = match_->play().client();
  const std::string reason = *client.ending();
  next_ = client.next();
  const bool asksPassword = client.asksPassword() && choice_.server;
  if (client.welcomed()) {
    std::fprintf(stderr, "platon-client: %s\n", reason.c_str());
    return failMatch("The game has ended", reason);
  }
  leaveMatch();
  fail(ProgramError(ProgramError::kFailed, reason));
  if (asksPassword) front_.askPassword(*choice_.server, !choice_.password.empty());
}

void WindowPlay::fail(const ProgramError& error) {
  if (named_) failure_ = error;
  if (named_ && options_.seconds) throw ProgramError(error);
  failMatch(titleOf(error, choice_), error.what());
}

void WindowPlay::failMatch(const std::string& title, const std::string& reason) {
  replay_.reset();
  menu_.open([this, title, reason] {
    return failurePage(
        title, reason, [this] { start(MatchChoice(choice_)); }, [this] { leaveToTitle(); }, goOn());
  });
}

// The player decides, because any server can name any other. It gets no password.
std::optional<MenuItem> WindowPlay::goOn() {
  if (!next_) return std::nullopt;
  return MenuItem{.name = "Join " + next_->text(), .choose = [this] { start(MatchChoice{ServerAddress(*next_)}); }};
}

// A recording that is dropped on a game would end it.
void WindowPlay::takeDrops() {
  const std::vector<std::string> files = window_.takeDroppedFiles();
  if (files.empty()) return;
  if (!match_) return watch(files.front());
  tell("leave the game to watch a recording");
}

void WindowPlay::watch(const std::filesystem::path& file) {
  replay_.emplace(file);
  medals_.reset();
  menu_.close();
}

void WindowPlay::updateReplay(double seconds) {
  if (!replay_) return;
  replay_->advance(seconds);
  if (!replay_->fault().empty()) return failReplay();
  if (replay_->viewer() != nullptr && std::exchange(named_, false)) failure_.reset();
  // Behind the replay, a game with others goes on.
  const bool isJoined = match_ && !match_->alone();
  if (isJoined) tell("somebody has joined the game");
  if (isJoined || replay_->leaving()) leaveReplay(std::filesystem::path(replay_->file()));
}

void WindowPlay::leaveReplay(const std::filesystem::path& file) {
  named_ = false;
  replay_.reset();
  medals_.reset();
  match_ ? matchPages_.showPause(*match_) : front_.showRun(file);
}

void WindowPlay::failReplay() {
  const ProgramError error(ProgramError::kInvalid, replay_->fault());
  const std::filesystem::path file = replay_->file();
  if (named_) failure_ = error;
  if (named_ && options_.seconds) throw ProgramError(error);
  replay_.reset();
  menu_.open([this, file, reason = std::string(error.what())] {
    return failurePage(
        "The recording cannot be played", reason, [this, file] { watch(std::filesystem::path(file)); },
        [this, file] { leaveReplay(std::filesystem::path(file)); });
  });
}

void WindowPlay::leaveToTitle() {
  leaveMatch();
  named_ = false;
  front_.showTitle();
}

void WindowPlay::leaveMatch() {
  if (match_) match_->leave();
  match_.reset();
}

void WindowPlay::draw(Moment now) {
  const double seconds = toSeconds(now - drawnAt_);
  drawnAt_ = now;
  if (window_.minimised()) return;
  view_.setQuality(trial_.quality(interface_.settings().quality));
  view_.setNotice(told());
  if (!showsPreview()) preview_.reset();
  if (replay_) {
    drawReplay(seconds);
  } else if (showsPreview()) {
    drawPreview(seconds);
  } else if (match_) {
    drawMatch(seconds);
  } else {
    drawFront(seconds);
    view_.present();
  }
  savePicture();
  window_.show();
}

void WindowPlay::savePicture() {
  if (interface_.takePicture()) pictures_.write(view_.read());
  if (const std::optional<std::string> report = pictures_.takeReport()) tell(*report);
}

// A game with others goes on, and shows itself what a setting does.
bool WindowPlay::showsPreview() const { return menu_.showsMotion() && (!match_ || match_->paused()); }

void WindowPlay::drawPreview(double seconds) {
  sound_.update(nullptr, nullptr, std::nullopt, interface_.settings(), seconds);
  if (!preview_) preview_.emplace();
  preview_->advance(interface_.settings(), seconds);
  const Overlay menu = menu_.overlay(view_.font(), false);
  preview_->draw(view_, interface_.settings(), interface_.keyHints(), menu, seconds);
  view_.present();
}

void WindowPlay::drawReplay(double seconds) {
  const ReplayViewer* const viewer = replay_->viewer();
  sound_.update(nullptr, nullptr, std::nullopt, interface_.settings(), seconds);
  view_.setFlights(false);
  view_.look({});
  if (viewer != nullptr && !medals_) medals_ = front_.medalsOf(viewer->player().replay().level());
  const ReplayContext context{interface_.keyHints().gamepad(), medals_.value_or(std::nullopt)};
  replay_->draw(view_, interface_.settings(), seconds, context);
  view_.present();
}

void WindowPlay::drawMatch(double seconds) {
  const Moment now = match_->now();
  match_->play().show(interface_.settings());
  std::optional<Scene> scene = match_->play().scene(now);
  if (scene) view_.netGraph().add(meter_.sample(match_->play().client(), drawnAt_));
  if (scene) spectator_.direct(*scene, interface_.keyHints());
  HudStatus status = match_->play().hudStatus(now, interface_.helpShown());
  status.run.speed = match_->leastSpeed();
  status.keys = interface_.keyHints();
  status.hint = hint(status.summary.has_value());
  if (scene && match_->leastSpeed() == 1) status.medal = medal(*scene);
  status.underMenu = menu_.isOpen() && !menu_.standsAside();
  view_.setFlights(!menu_.isOpen());
  view_.look(menu_.isOpen() ? LookInput() : mouseLook_.take(interface_.look()));
  Settings& settings = interface_.settings();
  const auto draw = [&] {
    view_.draw(scene ? &*scene : nullptr, status, settings, menu_.overlay(view_.font(), true), seconds);
    view_.present();  // a part of the time that the trial measures
  };
  scene ? trial_.draw(settings.quality, clock_.now, finishDrawing, draw) : draw();
  playSounds(scene ? &*scene : nullptr, status, seconds);
}

std::string WindowPlay::hint(bool roundOver) const {
  const KeyHints keys = interface_.keyHints();
  if (skip_.asked()) return keys.of(Control::kVote) + " again: next level, without this goal";
  if (roundOver) return match_->alone() ? keys.goOn() + ": next level" : "";
  if (!spectator_.hint().empty() || options_.demo) return spectator_.hint();
  return view_.flying() ? "" : hints_.hint(keys);  // the goal in the picture is not the ball
}

// Of the own time, while the player is at the goal.
std::string WindowPlay::medal(const Scene& scene) {
  const std::shared_ptr<const Level> level = match_->play().level();
  if (!level || !scene.attempt || !scene.attempt->arrived) return medals_.reset(), "";
  if (!medals_) medals_ = front_.medalsOf(level);
  return ownMedalText(scene, *medals_);
}

void WindowPlay::drawFront(double seconds) {
  sound_.update(nullptr, nullptr, std::nullopt, interface_.settings(), seconds);
  front_.update(clock_.now());
  const Settings& settings = interface_.settings();
  const std::shared_ptr<const Level> level = front_.shownLevel();
  if (level) turntable_.show(level);
  Overlay menu = menu_.overlay(view_.font(), false);
  if (!turntable_.shows()) return view_.draw(nullptr, {}, settings, menu, seconds);
  if (!settings.comfort.reducedMotion) turntable_.advance(seconds);
  const float width = view_.screenWidth();
  const float scale = view_.textScale(settings);
  // The notice stands where the card does.
  if (level && told().empty()) addLevelCard(menu, front_.entryOf(level), view_.font(), width, scale);
  const bool beside = width > Turntable::kWide * Overlay::kHeight;
  const float left = beside ? scale * endOfLeftColumn(view_.screen() / scale) : 0;
  view_.drawStill(turntable_.scene(), turntable_.camera(view_.width(), view_.height()), settings, menu, left);
}

// During an outage nothing is heard.
void WindowPlay::playSounds(const Scene* scene, const HudStatus& status, double seconds) {
  const NetworkClient& client = match_->play().client();
  const std::optional<double> next = status.summary ? std::optional(status.summary->secondsLeft) : std::nullopt;
  sound_.update(client.outage() ? nullptr : client.session(), scene, next, interface_.settings(), seconds);
}

void WindowPlay::takeScreenshot() {
  writePng(view_.read(), options_.screenshot);
  std::printf("screenshot: %s\n", options_.screenshot.c_str());
}

}  // namespace platon
