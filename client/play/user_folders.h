#pragma once

#include <filesystem>

namespace platon {

/// `platon` in XDG_CONFIG_HOME, by default in ~/.config: the player's settings. Empty without a home folder.
std::filesystem::path configFolder();
/// `platon` in XDG_DATA_HOME, by default in ~/.local/share: session tokens and desync reports. Empty without a home
/// folder.
std::filesystem::path dataFolder();

}  // namespace platon
