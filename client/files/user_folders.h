#pragma once

#include <filesystem>
#include <string>

#include "protocol/transport/server_address.h"

namespace platon {

/// `platon` in XDG_CONFIG_HOME, by default in ~/.config: the player's settings. Empty without a home folder.
std::filesystem::path configFolder();
/// `platon` in XDG_DATA_HOME, by default in ~/.local/share: session tokens, desync reports and best times. Empty
/// without a home folder.
std::filesystem::path dataFolder();

/// The best times of games on this machine, a file in the data folder. Empty without it.
std::filesystem::path bestTimesFile();
/// The levels whose goal the player has reached alone, a file in the data folder. Empty without it.
std::filesystem::path reachedLevelsFile();

/// The local player's best runs, and those of others that are shown as ghosts, in the data folder. Empty without it.
std::filesystem::path runsFolder();
std::filesystem::path ghostsFolder();
/// The levels that the user has made in the game.
std::filesystem::path ownLevelsFolder();

/// `platon` in XDG_STATE_HOME, by default in ~/.local/state: recent servers. Empty without a home folder.
std::filesystem::path stateFolder();

/// The user's folder for pictures: $XDG_PICTURES_DIR, the one that the file `user-dirs.dirs` in the folder of the
/// configuration names, or ~/Pictures. Empty without a home folder.
std::filesystem::path picturesFolder();

/// `platon` in XDG_CACHE_HOME, by default in ~/.cache: levels of servers. Empty without a home folder.
std::filesystem::path cacheFolder();

/// Name of a file or folder for a server: HOST_PORT. The host is user input: characters that could form a path are
/// percent-encoded.
std::string serverFileName(const ServerAddress& server);

}  // namespace platon
