#pragma once

#include <functional>
#include <string>

#include "client/menu/menu_page.h"
#include "client/menu/pages/replays_page.h"

namespace platon {

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
