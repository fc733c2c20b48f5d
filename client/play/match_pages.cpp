#include "client/play/match_pages.h"

#include <utility>

#include "client/menu/pages/pause_page.h"

namespace platon {

MatchPages::MatchPages(Menu& menu, UserInterface& interface, Calls calls)
    : menu_(&menu), interface_(&interface), calls_(std::move(calls)) {}

void MatchPages::showPause(LiveMatch& match) { openPause(match, ""); }

void MatchPages::loseGamepad(LiveMatch& match) {
  constexpr const char* kLost = "Gamepad disconnected";
  if (match.alone() && !menu_->isOpen()) return openPause(match, kLost);
  calls_.tell(kLost);
}

void MatchPages::openPause(LiveMatch& match, const std::string& note) {
  skip_.takeBack();
  menu_->open([this, &match, note] { return pauseOver(match, note); });
}

// With others no run is offered: the replay would hide a game that goes on.
MenuPage MatchPages::pauseOver(LiveMatch& match, const std::string& note) {
  const bool alone = match.alone();
  PauseChoices choices;
  choices.notes = match.invitation();
  if (!note.empty()) choices.notes.insert(choices.notes.begin(), note);
  if (!alone) choices.notes.emplace_back("The game goes on while the menu is open.");
  choices.title = alone ? "Pause" : "Platon";
  choices.next = alone                ? (skip_.asked() ? "Skip this level?" : "Next level")
                 : match.wishesNext() ? "Take back the vote for the next level"
                                      : "Vote for the next level";
  choices.restartKey = interface_->keyHints().of(Control::kRestart);
  choices.nextKey = interface_->keyHints().of(Control::kVote);
  choices.sayKey = interface_->keyHints().of(Control::kSay);
  choices.onResume = [this] { menu_->close(); };
  choices.onRestart = [this] {
    interface_->restart();
    menu_->close();
  };
  choices.onNext = [this, &match] {
    if (match.alone() && !skip_.wish(match.losesNothing())) return;
    match.skipLevel();
    menu_->close();
  };
  choices.onHelp = [this] {
    interface_->showHelp();
    menu_->close();
  };
  choices.onSettings = calls_.showSettings;
  choices.onLeave = calls_.leave;
  if (!alone) choices.onSay = [this, &match] { showSay(match); };
  const std::filesystem::path& best = match.bestRun();
  if (alone && !best.empty()) choices.onWatch = [this, best] { calls_.watch(best); };
  return pausePage(choices);
}

void MatchPages::showSay(LiveMatch& match) {
  menu_->open([this, &match] {
    SayChoices choices;
    choices.say = [this, &match] { say(match, {text_.text(), 0}); };
    choices.emote = [this, &match](std::uint32_t emote) { say(match, {"", emote}); };
    choices.leave = [this] { menu_->close(); };
    choices.said = match.said(interface_->settings());
    for (std::size_t i = 0; i < choices.emoteKeys.size(); ++i)
      choices.emoteKeys[i] =
          interface_->keyHints().of(static_cast<Control>(static_cast<std::size_t>(Control::kEmote1) + i));
    return sayPage(text_, choices);
  });
}

// A text that cannot be said stays in the field.
void MatchPages::say(LiveMatch& match, const Chat& chat, std::uint32_t local) {
  menu_->close();
  if (!isChat(chat)) return;
  if (!match.say(chat, local)) return calls_.tell("too much at once: wait a moment");
  if (chat.emote == 0) text_.setText("");
}

}  // namespace platon
