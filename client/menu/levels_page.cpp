#include "client/menu/levels_page.h"

#include "client/ui/player_rows.h"

namespace platon {
namespace {

bool beginsGroup(std::span<const LevelEntry> levels, std::size_t level) {
  return level == 0 || levels[level].solid != levels[level - 1].solid;
}

std::string factsOf(const LevelEntry& level) {
  std::string facts = level.players > 1 ? std::to_string(level.players) + " players" : "";
  if (level.bestSeconds) facts += (facts.empty() ? "★ " : "   ★ ") + finishText(*level.bestSeconds);
  return facts;
}

}  // namespace

MenuPage levelsPage(std::span<const LevelEntry> levels, const std::function<void(std::size_t)>& choose) {
  MenuPage page{"Levels"};
  page.place = MenuPage::Place::kLeft;
  for (std::size_t i = 0; i < levels.size(); ++i) {
    if (beginsGroup(levels, i)) page.items.push_back({MenuItem::Kind::kHeading, levels[i].solid});
    page.items.push_back({.name = levels[i].title, .value = factsOf(levels[i]), .choose = [choose, i] { choose(i); }});
  }
  return page;
}

std::size_t itemOfLevel(std::span<const LevelEntry> levels, std::size_t level) {
  std::size_t item = level;
  for (std::size_t i = 0; i <= level; ++i) item += beginsGroup(levels, i) ? 1 : 0;
  return item;
}

std::size_t levelOfItem(std::span<const LevelEntry> levels, std::size_t item) {
  std::size_t level = 0;
  while (level + 1 < levels.size() && itemOfLevel(levels, level) < item) ++level;
  return level;
}

}  // namespace platon
