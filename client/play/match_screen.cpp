#include "client/play/match_screen.h"

#include <algorithm>
#include <cstdio>
#include <utility>

#include "client/gl/gl_context.h"
#include "client/menu/pages/failure_page.h"
#include "client/play/replay_screen.h"

namespace platon {

MatchScreen::MatchScreen(GameDesk& desk, const MatchChoice& choice, MedalsOf medalsOf)
    : desk_(&desk),
      choice_(choice),
      medalsOf_(std::move(medalsOf)),
      match_(desk.options, choice, desk.clock),
      settingsPages_(desk.menu, desk.settings(), [this] { return match_.alone(); }),
      pages_(desk.menu, desk.interface,
             {[this] { settingsPages_.show(MenuPage::Place::kMiddle); }, [this] { next_ = Close(); },
              [this](const std::filesystem::path& file) { watch(file); },
              [this](const std::string& text) { desk_->tell(text); }}) {}

Next MatchScreen::handle(const WindowEvent& event) {
  if (const auto* const key = std::get_if<KeyEvent>(&event)) handleKey(*key);
  if (const auto* const pointer = std::get_if<PointerEvent>(&event)) handlePointer(*pointer);
  const auto* const lost = std::get_if<GamepadLost>(&event);
  if (lost != nullptr && desk_->interface.loseGamepad(lost->pad)) pages_.loseGamepad(match_);
  if (std::holds_alternative<FilesDropped>(event)) desk_->tell(kDropRefused);
  if (std::holds_alternative<CloseAsked>(event)) next_ = Quit();
  return std::exchange(next_, Stay());
}

void MatchScreen::handleKey(const KeyEvent& event) {
  const std::optional<Action> action = desk_->handle(event, desk_->menu.isOpen());
  desk_->menu.handle(event, desk_->view.font());
  if (event.kind == KeyEvent::Kind::kPress && action != Action::kToggleVote) skip_.takeBack();
  if (action) perform(*action, event);
}

// The press that closes the menu does not look round.
void MatchScreen::handlePointer(const PointerEvent& event) {
  if (event.kind == PointerEvent::Kind::kPress) desk_->view.skip();
  const bool inGame = !desk_->menu.isOpen();
  desk_->menu.handle(event, desk_->view.font());
  if (inGame) mouseLook_.handle(event);
}

void MatchScreen::perform(Action action, const KeyEvent& event) {
  switch (action) {
    case Action::kOpenMenu:
      return pages_.showPause(match_);
    case Action::kToggleVote:
      return wishNext();
    case Action::kJoin:
      return tellJoin(event.key);
    case Action::kGoOn:
      return match_.alone() && match_.roundOver() ? match_.skipLevel() : void();
    case Action::kWatchNext:
      return spectator_.next();
    case Action::kSay:
      sayAsked_ = true;
      return;
    case Action::kEmote1:
    case Action::kEmote2:
    case Action::kEmote3:
    case Action::kEmote4:
      return pages_.say(match_,
                        {"", 1 + static_cast<std::uint32_t>(action) - static_cast<std::uint32_t>(Action::kEmote1)},
                        desk_->interface.devices().ownerOf(event, desk_->settings().secondKeys));
    default:
      return;
  }
}

void MatchScreen::wishNext() {
  if (!match_.alone() || skip_.wish(match_.losesNothing())) match_.skipLevel();
}

void MatchScreen::tellJoin(Key key) {
  const std::string again = std::string(shownNameOf(key)) + ": it leaves";
  switch (desk_->interface.deviceChange()) {
    case DeviceChange::kJoined:
      return desk_->tell((isOfGamepad(key) ? "Another player has this gamepad. " : secondKeysText()) + again);
    case DeviceChange::kReturned:
      return desk_->tell("The player whose gamepad was lost plays on. " + again);
    case DeviceChange::kLeft:
      return desk_->tell("A player has left");
    case DeviceChange::kNone:
      return desk_->tell("No more than four players fit on one machine");
  }
}

std::string MatchScreen::secondKeysText() const {
  const KeyHints keys(desk_->settings().secondKeys);
  return "Another player has " + keys.run() + " and " + keys.of(Control::kUp) + ". ";
}

// Who joins with a device is to play, and whom the server does not let play has none. A name is told once it is
// entered.
void MatchScreen::followDevices() {
  for (std::uint32_t local = 1; local < kMaxLocalPlayers; ++local) {
    const bool has = desk_->interface.devices().has(local);
    const std::string& name = desk_->settings().companion(local).name;
    if (joined_[local] && has && !match_.client().companions()[local])
      desk_->interface.removeCompanion(local);
    else if (has != joined_[local] || (has && !desk_->menu.isOpen()))
      match_.setCompanion(local, has ? std::optional(name) : std::nullopt);
    joined_[local] = desk_->interface.devices().has(local);
  }
}

void MatchScreen::watch(const std::filesystem::path& file) {
  next_ = Push{std::make_unique<ReplayScreen>(*desk_, file, medalsOf_, ReplayScreen::Behind::kMatch)};
  desk_->menu.close();
}

Next MatchScreen::reveal(const Ending& ending) {
  const auto* const end = std::get_if<ReplayEnd>(&ending);
  end == nullptr ? pages_.showPause(match_) : stopWatching(*end);
  return Stay();
}

void MatchScreen::stopWatching(const ReplayEnd& end) {
  if (end.fault.empty()) return pages_.showPause(match_);
  desk_->menu.open([this, end] {
    return unplayablePage(
        end, [this, end] { watch(end.file); }, [this] { pages_.showPause(match_); });
  });
}

Next MatchScreen::update(const Frame& frame) {
  if (const auto again = desk_->repeated(desk_->menu.isOpen(), frame)) handleKey(*again);
  // After all events: the character of the key is not part of the text.
  if (std::exchange(sayAsked_, false)) pages_.showSay(match_);
  desk_->update(frame);
  advance(desk_->menu.isOpen());
  if (match_.client().ending() && phase_ != Phase::kEnded) checkEnding();
  return std::exchange(next_, Stay());
}

bool MatchScreen::updateBehind(const Frame& /*frame*/) {
  advance(true);
  if (!match_.alone()) desk_->tell("somebody has joined the game");
  return !match_.alone() || match_.client().ending();
}

// `away`: the player does not look at the game.
void MatchScreen::advance(bool away) {
  if (away) mouseLook_.release();
  followDevices();
  match_.update(
      away, [this, away](const Game& game, std::uint32_t slot) { return choose(game, slot, away); },
      desk_->settings().gameSpeed / 100);
  if (phase_ != Phase::kJoining || !match_.client().welcomed()) return;
  phase_ = Phase::kPlaying;
  if (choice_.server) desk_->recentServers.remember(*choice_.server);
  desk_->named.succeed();
}

Input MatchScreen::choose(const Game& game, std::uint32_t slot, bool away) {
  const SlotsByLocal slots = match_.slots();
  if (desk_->options.demo) return slot == slots[0] ? demo_.choose(game, slot) : Input{Input::kPresent};
  const auto local = static_cast<std::uint32_t>(std::find(slots.begin(), slots.end(), slot) - slots.begin());
  HeldKeys held = desk_->interface.takeHeld(away, local);
  if (local == 0) againTogether_ = held.restart && match_.alone() && match_.roundOver();
  held.restart = held.restart || againTogether_;
  if (held != HeldKeys()) desk_->view.skip();
  if (local == 0) desk_->hints.observe(game, slot, looks_, desk_->settings());
  const auto before = std::count_if(slots.begin(), slots.begin() + local, [](const auto& each) { return each; });
  const double roll = desk_->view.roll(static_cast<std::size_t>(before));
  return steering_[local].input(held, roll, desk_->settings().controls);
}

void MatchScreen::checkEnding() {
  const NetworkClient& client = match_.client();
  const std::string reason = *client.ending();
  if (phase_ == Phase::kJoining) {
    const bool asksPassword = client.asksPassword() && choice_.server;
    next_ = Close{MatchRefused{ProgramError(ProgramError::kFailed, reason), asksPassword, client.next()}};
    return;
  }
  phase_ = Phase::kEnded;
  std::fprintf(stderr, "platon-client: %s\n", reason.c_str());
  desk_->menu.open([this, reason] {
    const auto start = [this](const MatchChoice& choice) { next_ = Close{choice}; };
    return failurePage(
        "The game has ended", reason, [this, start] { start(choice_); }, [this] { next_ = Close(); },
        joinItem(match_.client().next(), start));
  });
}

void MatchScreen::draw(const Frame& frame) {
  if (desk_->drawPreview(match_.paused(), frame)) return;
  GameView& view = desk_->view;
  Settings& settings = desk_->settings();
  const bool inMenu = desk_->menu.isOpen();
  std::vector<Scene> seen = scenes();
  Scene* const scene = seen.empty() ? nullptr : &seen.front();
  if (scene != nullptr) view.netGraph().add(meter_.sample(match_.client(), frame.now));
  if (seen.size() == 1) spectator_.direct(*scene, desk_->interface.keyHints());
  if (seen.size() > 1) spectator_.reset();
  const HudStatus status = hudStatus(seen);
  view.setFlights(!inMenu);
  const LookInput look = inMenu ? LookInput() : mouseLook_.take(desk_->interface.look());
  looks_ = look.held && (look.direction != glm::dvec2(0) || look.turn != glm::dvec2(0));
  view.look(look);
  const auto draw = [&] {
    const Overlay menu = desk_->menu.overlay(view.font(), true);
    if (seen.size() > 1)
      view.drawShared(seen, status, settings, menu, frame.seconds);
    else
      view.draw(scene, status, settings, menu, frame.seconds);
    desk_->present();  // a part of the time that the trial measures
  };
  const bool measures = scene != nullptr && desk_->window.onScreen();
  measures ? desk_->trial.draw(settings.quality, desk_->clock.now, finishDrawing, draw) : draw();
  playSounds(scene, status, frame.seconds);
}

// As each local player sees it, the first one's first.
std::vector<Scene> MatchScreen::scenes() {
  std::vector<Scene> all;
  for (std::size_t local = 0; local < kMaxLocalPlayers; ++local)
    if (std::optional<Scene> scene = match_.scene(desk_->settings(), local)) all.push_back(std::move(*scene));
  return all;
}

// A race between players of this machine gives no medals: its times are not kept.
HudStatus MatchScreen::hudStatus(std::span<const Scene> seen) {
  HudStatus status = match_.hudStatus(desk_->settings(), desk_->interface.helpShown());
  status.keys = desk_->interface.keyHints();
  status.hint = hint(status.summary.has_value());
  const bool counts = seen.size() == 1 || (!seen.empty() && seen.front().isTeam);
  if (counts && match_.leastSpeed() == 1) status.medals = medals(seen.front());
  const SlotsByLocal slots = match_.slots();
  for (std::uint32_t local = 1; local < kMaxLocalPlayers; ++local)
    if (slots[local]) status.companionKeys.push_back(desk_->interface.companionKeyHints(local));
  status.underMenu = desk_->menu.isOpen() && !desk_->menu.standsAside();
  return status;
}

std::string MatchScreen::hint(bool roundOver) const {
  const KeyHints keys = desk_->interface.keyHints();
  if (skip_.asked()) return keys.of(Control::kVote) + " again: skip this level";
  if (roundOver) return match_.alone() ? keys.goOn() + ": next level" : "";
  if (!spectator_.hint().empty() || desk_->options.demo) return spectator_.hint();
  return desk_->view.flying() ? "" : desk_->hints.hint(keys);  // the goal in the picture is not the ball
}

// While the player is at the goal.
std::optional<MedalTimes> MatchScreen::medals(const Scene& scene) {
  const std::shared_ptr<const Level> level = match_.level();
  if (!level || !arrivalTicksOf(scene)) {
    medals_.reset();
    return std::nullopt;
  }
  if (!medals_) medals_ = medalsOf_(level);
  return *medals_;
}

// During an outage nothing is heard.
void MatchScreen::playSounds(const Scene* scene, const HudStatus& status, double seconds) {
  const NetworkClient& client = match_.client();
  const std::optional<double> next = status.summary ? std::optional(status.summary->secondsLeft) : std::nullopt;
  desk_->sound.update(client.outage() ? nullptr : client.session(), scene, next, desk_->settings(), seconds);
}

std::optional<MenuItem> joinItem(const std::optional<ServerAddress>& next,
                                 const std::function<void(const MatchChoice&)>& start) {
  if (!next) return std::nullopt;
  return MenuItem{.name = "Join " + next->text(),
                  .choose = [server = *next, start] { start(MatchChoice{.server = server}); }};
}

}  // namespace platon
