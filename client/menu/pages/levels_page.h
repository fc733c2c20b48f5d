#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>

#include "client/menu/menu_page.h"
#include "client/ui/medal.h"

namespace platon {

/// What the list of levels shows of a level.
struct LevelEntry {
  std::string title;
  std::string solid;                          ///< its name; levels of the same solid follow each other
  std::uint32_t players = 1;                  ///< that it needs
  std::optional<std::uint32_t> bestTicks{};   ///< nothing: no time of this player's own games
  std::optional<MedalTimes> medals{};         ///< nothing: the level has none
  bool reached = false;                       ///< this player has reached its goal alone, with a time or slowed
  std::optional<std::uint32_t> olderTicks{};  ///< best time by the last rules before the present ones that have one
};

/// The list of the levels for one player, by solid, and below them those for several. `choose` gets the index of a
/// level.
MenuPage levelsPage(std::span<const LevelEntry> levels, const std::function<void(std::size_t)>& choose);

/// Item of that page which stands for a level.
std::size_t itemOfLevel(std::span<const LevelEntry> levels, std::size_t level);
/// The level that an item of that page stands for; for a heading, the level below it. `levels` is not empty.
std::size_t levelOfItem(std::span<const LevelEntry> levels, std::size_t item);

}  // namespace platon
