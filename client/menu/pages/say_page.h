#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "client/menu/menu_page.h"
#include "client/menu/text_field.h"

namespace platon {

/// What the page to talk calls back.
struct SayChoices {
  std::function<void()> say{};                 ///< the text of the field
  std::function<void(std::uint32_t)> emote{};  ///< the number of an emote, from 1 on
  std::function<void()> leave{};               ///< without a word
  std::vector<std::string> said{};             ///< what players have said lately, newest first: long notes are cut
};

/// The page on which the player says a text or an emote to the others. `text` outlives the page.
MenuPage sayPage(TextField& text, const SayChoices& choices);

}  // namespace platon
