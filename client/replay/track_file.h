#pragma once

#include <filesystem>
#include <string>
#include <variant>

#include "client/replay/run_track.h"

namespace platon {

/// Reads the run of a recording from a file, and plays it once, or says in one sentence why it is none. `level`: that
/// it must be on; null: any.
std::variant<RunTrack, std::string> readTrack(const std::filesystem::path& file, const Level* level = nullptr);

}  // namespace platon
