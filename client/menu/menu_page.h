#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <glm/vec4.hpp>

#include "client/menu/text_field.h"

namespace platon {

/// A line of a menu page. It calls back what the player does with it.
struct MenuItem {
  enum class Kind : std::uint8_t { kHeading, kAction, kChoice, kSlider, kToggle, kText };

  Kind kind = Kind::kAction;
  std::string name;
  std::string value{};              ///< shown at the right; of a kToggle also in its form, of a kText while it is empty
  double part = 0;                  ///< of a kSlider: 0 … 1 of its range; of a kToggle: 1 is on
  std::function<void()> choose{};   ///< of a kAction
  std::function<void(int)> step{};  ///< of a kChoice, kSlider or kToggle: to the next value (1) or the one before (-1)
  std::function<void(double)> set{};       ///< of a kSlider: to this part of its range
  std::optional<glm::vec4> valueColour{};  ///< of a kAction; nothing: that of the name
  TextField* field = nullptr;              ///< of a kText
  bool secret = false;                     ///< of a kText: its characters are shown as dots
  std::string about{};                     ///< a sentence for the player, shown while it has the focus
  bool inMotion = false;                   ///< its value can be judged only on a game that runs
  bool flips = false;                      ///< of a kChoice: it has two values, and each step leads to the other one

  bool canHaveFocus() const { return kind != Kind::kHeading; }
  /// Whether a key that is held changes the value more than once.
  bool repeats() const { return kind != Kind::kToggle && !flips; }
};

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
