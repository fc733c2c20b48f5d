#pragma once

#include <functional>

#include "client/menu/menu_page.h"
#include "client/menu/pages/levels_page.h"

namespace platon {

/// What is offered of a level that needs several players.
struct SeveralPlayersChoices {
  std::function<void()> host;
  std::function<void()> join;
};

/// The page of a level that cannot be played alone: why, and what the player can do instead.
MenuPage severalPlayersPage(const LevelEntry& level, const SeveralPlayersChoices& choices);

}  // namespace platon
