#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "client/menu/menu_item.h"

namespace platon {

/// What a menu shows at a time. At least one item can have the focus.
struct MenuPage {
  /// kMiddle: on a panel in the middle of the picture. kLeft: at the left, beside something to see.
  enum class Place : std::uint8_t { kMiddle, kLeft };

  std::string title;
  std::vector<std::string> notes{};  ///< paragraphs below the title
  bool warning = false;              ///< the notes report an error
  std::vector<MenuItem> items{};
  Place place = Place::kMiddle;
  bool large = false;                              ///< the title is the name of the game
  bool standsAside = false;                        ///< while a value is being changed, only its item is shown
  std::function<void(const KeyEvent&)> takeKey{};  ///< if set, gets every key; a press of the mouse is Esc to it
  std::function<void()> back{};  ///< called by Esc, B and the mouse; nothing: the page before is shown, if there is one
  /// Whether a mark beside the title goes back, too. A menu shows none on a page from which nothing leads back.
  bool backMark = true;
};

}  // namespace platon
