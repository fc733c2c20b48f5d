#include "client/menu/pages/several_players_page.h"

namespace platon {

MenuPage severalPlayersPage(const LevelEntry& level, const SeveralPlayersChoices& choices) {
  MenuPage page{level.title};
  page.place = MenuPage::Place::kLeft;
  page.notes = {"This level needs " + std::to_string(level.players) +
                " players: host it so that others can join you, or join somebody who hosts it."};
  page.items = {{.name = "Host it", .choose = choices.host}, {.name = "Join", .choose = choices.join}};
  return page;
}

}  // namespace platon
