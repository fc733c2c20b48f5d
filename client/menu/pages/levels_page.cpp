#include "client/menu/pages/levels_page.h"

#include <algorithm>
#include <optional>
#include <vector>

#include "client/ui/player_rows.h"

namespace platon {
namespace {

// A row of the page: a level, or the heading of those that follow.
struct Row {
  std::string heading;
  std::size_t level = 0;  // for a heading, the level below it
};

std::string groupOf(const LevelEntry& level) {
  return level.players == 1 ? level.solid : "For " + std::to_string(level.players) + " players";
}

void addRow(std::vector<Row>& rows, std::string& group, std::span<const LevelEntry> levels, std::size_t level) {
  if (groupOf(levels[level]) != group) {
    group = groupOf(levels[level]);
    rows.push_back({group, level});
  }
  rows.push_back({"", level});
}

// By solid those for one player, then those for several.
std::vector<Row> rowsOf(std::span<const LevelEntry> levels) {
  std::vector<Row> rows;
  std::string group;
  for (const bool several : {false, true}) {
    for (std::size_t i = 0; i < levels.size(); ++i) {
      if ((levels[i].players > 1) == several) addRow(rows, group, levels, i);
    }
  }
  return rows;
}

// Nothing: without a time, and on a level without medals.
std::optional<Medal> medalOf(const LevelEntry& level) {
  if (!level.medals || !level.bestTicks) return std::nullopt;
  return medalFor(*level.medals, *level.bestTicks);
}

// What the player has reached; a time of older rules gives no medal.
std::string reachedText(const LevelEntry& level) {
  if (level.bestTicks) return starsOf(medalOf(level)) + " " + finishTextOf(*level.bestTicks);
  const std::string reached = level.reached ? "✓" : "";
  if (!level.olderTicks) return reached;
  return reached + (level.reached ? " " : "") + finishTextOf(*level.olderTicks) + ", older rules";
}

std::string factsOf(const LevelEntry& level) {
  const std::string solid = level.players > 1 ? level.solid : "";
  const std::string reached = reachedText(level);
  return solid + (solid.empty() || reached.empty() ? "" : " · ") + reached;
}

MenuItem itemOf(const LevelEntry& level) {
  MenuItem item{.name = level.title, .value = factsOf(level)};
  if (const std::optional<Medal> medal = medalOf(level)) item.valueColour = colourOf(*medal);
  return item;
}

}  // namespace

MenuPage levelsPage(std::span<const LevelEntry> levels, const std::function<void(std::size_t)>& choose) {
  MenuPage page{"Levels"};
  page.place = MenuPage::Place::kLeft;
  for (const auto& [heading, i] : rowsOf(levels)) {
    if (!heading.empty()) {
      page.items.push_back({MenuItem::Kind::kHeading, heading});
    } else {
      page.items.push_back(itemOf(levels[i]));
      page.items.back().choose = [choose, i = i] { choose(i); };
    }
  }
  return page;
}

std::size_t itemOfLevel(std::span<const LevelEntry> levels, std::size_t level) {
  const std::vector<Row> rows = rowsOf(levels);
  const auto found = std::find_if(rows.begin(), rows.end(),
                                  [level](const Row& row) { return row.heading.empty() && row.level == level; });
  return static_cast<std::size_t>(found - rows.begin());
}

std::size_t levelOfItem(std::span<const LevelEntry> levels, std::size_t item) {
  const std::vector<Row> rows = rowsOf(levels);
  return rows[std::min(item, rows.size() - 1)].level;
}

}  // namespace platon
