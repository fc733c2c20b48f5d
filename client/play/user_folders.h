#pragma once

#include <filesystem>

namespace platon {

/// The game's folder for what the user chose; empty when the user has no such place.
std::filesystem::path configFolder();
/// The game's folder for what it keeps for the user; likewise.
std::filesystem::path dataFolder();

}  // namespace platon
