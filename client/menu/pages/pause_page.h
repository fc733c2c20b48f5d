#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "client/menu/menu_page.h"
#include "client/menu/text_field.h"
#include "client/ui/chat_feed.h"

namespace platon {

/// What the page over a game shows and calls.
struct PauseChoices {
  std::string title;
  std::vector<std::string> notes;  ///< paragraphs
  std::string restartKey;          ///< that returns to the start
  std::string next;                ///< name of the item that leads to the next level
  std::string nextKey;             ///< that leads there, too
  std::function<void()> onResume;
  std::function<void()> onRestart;
  std::function<void()> onNext;
  std::function<void()> onHelp;  ///< shows all keys
  std::function<void()> onSettings;
  std::function<void()> onLeave;
  std::function<void()> onWatch{};  ///< shows the player's best run on the level; empty: there is none
  std::function<void()> onSay{};    ///< to say something to the others; empty: there are none
  std::string sayKey{};             ///< that does so, too
};

/// The page that Esc shows over a game.
MenuPage pausePage(const PauseChoices& choices);

/// What the page to talk calls back.
struct SayChoices {
  std::function<void()> say{};                 ///< the text of the field
  std::function<void(std::uint32_t)> emote{};  ///< the number of an emote, from 1 on
  std::function<void()> leave{};               ///< without a word
  std::vector<std::string> said{};             ///< what players have said lately, newest first: long notes are cut
  std::array<std::string, kEmoteTexts.size()> emoteKeys{};  ///< that say the emotes, too
};

/// The page on which the player says a text or an emote to the others. `text` outlives the page.
MenuPage sayPage(TextField& text, const SayChoices& choices);

}  // namespace platon
