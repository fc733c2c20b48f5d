#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <variant>

#include "client/replay/run_track.h"

namespace platon {

/// Reads the run of a recording from a file, and plays it once, or says in one sentence why it is none. `level`: hash
/// of the level that it must be on; nothing: any.
std::variant<RunTrack, std::string> readTrack(const std::filesystem::path& file,
                                              std::optional<std::uint64_t> level = std::nullopt);

}  // namespace platon
