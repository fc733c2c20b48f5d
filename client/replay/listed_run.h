#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "platon/game/level.h"

namespace platon {

/// A recording as a list shows it.
struct ListedRun {
  std::filesystem::path file;
  std::shared_ptr<const Level> level{};  ///< null if it is not known
  std::optional<std::uint32_t> ticks{};  ///< its time; nothing: it is no run, or the time is not known
  std::string date{};                    ///< in UTC, `2026-12-01`; empty: unknown
  std::string note{};                    ///< why it cannot be played; empty: it can, as far as is known
  std::string noRun{};                   ///< why it shows no run; empty: it does, or that is not known
  std::string who{};                     ///< whose it is; empty: the player's own
  bool isBest = false;                   ///< the shortest one of own games on a level by the present rules
  bool isRead = false;                   ///< nothing more becomes known
};

/// The date of a file as ListedRun shows it.
std::string dateText(std::filesystem::file_time_type date);

}  // namespace platon
