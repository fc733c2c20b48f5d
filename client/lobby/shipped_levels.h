#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "client/lobby/remembered.h"
#include "client/menu/pages/levels_page.h"
#include "levels/solve/solution.h"
#include "platon/game/level.h"

namespace platon {

/// A level of the game, and what its list shows of it.
struct ShippedLevel {
  std::string file;
  std::shared_ptr<const Level> level;
  std::uint32_t wayTicks = 0;  ///< of the recorded easy way to its goal; 0: unknown
};

/// Files of the levels that come with the game, in order. Throws ProgramError, which says what a player can do, if they
/// are missing.
std::vector<std::string> gameLevelFiles();

/// The levels that come with the game, by solid, and on each solid in their order. Throws ProgramError.
std::vector<ShippedLevel> loadShippedLevels();

/// The ticks of the recorded easy ways to the goals, from the text of `levels/data/way_times`: lines with the name of a
/// level file, without its extension, and a number. Other lines are left out.
std::map<std::string, std::uint32_t> parseWayTimes(const std::string& text);

/// The recorded easy way to the goal of a level that comes with the game; nothing for another level, or if it is
/// missing or is one of other rules.
std::optional<Solution> shippedWay(const Level& level);

/// What the list of levels shows of a level, without a time.
LevelEntry entryOf(const ShippedLevel& level);

/// What the list of levels shows of these levels, with the times of a file of best times, and with the levels whose
/// goal was reached. A file that cannot be read has none.
std::vector<LevelEntry> entriesOf(const std::vector<ShippedLevel>& levels, const std::string& bestTimes,
                                  const ReachedLevels& reached);

}  // namespace platon
