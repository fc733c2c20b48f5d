#pragma once

#include <memory>
#include <string>
#include <vector>

#include "client/menu/levels_page.h"
#include "platon/game/level.h"

namespace platon {

/// A level of the game, and what its list shows of it.
struct ShippedLevel {
  std::string file;
  std::shared_ptr<const Level> level;
};

/// The levels that come with the game, by solid, and on each solid in their order. Throws ProgramError.
std::vector<ShippedLevel> loadShippedLevels();

/// What the list of levels shows of these levels, with the times of a file of best times. A file that cannot be read
/// has none.
std::vector<LevelEntry> entriesOf(const std::vector<ShippedLevel>& levels, const std::string& bestTimes);

}  // namespace platon
