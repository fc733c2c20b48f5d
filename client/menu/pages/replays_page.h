#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string>

#include "client/menu/menu_page.h"
#include "client/ui/medal.h"

namespace platon {

/// What the pages of replays show of a recording.
struct ReplayEntry {
  std::string title;   ///< of the level
  std::string time{};  ///< to the goal; empty: unknown, or it is no run
  std::string date{};
  std::string who{};             ///< whose run it is; empty: the player's own
  bool isBest = false;           ///< of the player's own runs on this level
  std::string note{};            ///< why it cannot be played, the end of a sentence; empty: it can
  std::string noRun{};           ///< why it shows no run, likewise; empty: it does
  std::optional<Medal> medal{};  ///< of its time; nothing: not known, or the level has none
};

/// The time with the stars of its medal; empty if it is unknown.
std::string timeText(const ReplayEntry& entry);

/// The list of recordings: the player's own runs, then those of others, in this order in `entries`. An empty list says
/// how recordings get there. `choose` gets the index of an entry.
MenuPage replaysPage(std::span<const ReplayEntry> entries, const std::function<void(std::size_t)>& choose,
                     const std::function<void()>& back);

/// Item of that page which stands for an entry.
std::size_t itemOfReplay(std::span<const ReplayEntry> entries, std::size_t entry);
/// The entry that an item of that page stands for; for a heading, the one below it. There is at least one entry.
std::size_t replayOfItem(std::span<const ReplayEntry> entries, std::size_t item);

/// What the player can do with a recording. What is not set is not offered; the way back is an item if nothing else is.
struct RunChoices {
  std::function<void()> watch{};
  std::function<void()> race{};  ///< plays its level with it as a ghost
  std::function<void()> keep{};  ///< copies its file to the folder of ghosts
  std::function<void()> back{};
};

/// The page of one recording, with the name of its file, and how to share it. `fault`: what went wrong when it was
/// kept; empty: nothing.
MenuPage runPage(const ReplayEntry& entry, const std::string& file, const std::string& fault,
                 const RunChoices& choices);

}  // namespace platon
