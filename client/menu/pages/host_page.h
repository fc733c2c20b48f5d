#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string>

#include "client/menu/menu_page.h"
#include "client/menu/pages/levels_page.h"
#include "client/menu/text_field.h"

namespace platon {

/// What the player enters to host a game.
struct HostForm {
  HostForm();

  std::size_t level = 0;   ///< the first level that is played, an index into the levels
  bool onlyLevel = false;  ///< no other is played
  double players = 8;      ///< at most so many, 1 … 64
  TextField port{5};
  TextField password{128};
  std::string fault{};  ///< what is wrong with the form; empty: nothing
};

/// Items of the page that the program may give the focus to.
inline constexpr std::size_t kHostPortItem = 3;
inline constexpr std::size_t kHostStartItem = 5;

/// The page on which the player sets up a game for others. `host` is called with the present form. `form` and `levels`
/// outlive the page.
MenuPage hostPage(HostForm& form, std::span<const LevelEntry> levels, const std::function<void()>& host);

}  // namespace platon
