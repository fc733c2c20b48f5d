#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <variant>

#include "client/replay/run_track.h"

namespace platon {

/// Reads the run of a recording from a file, and plays it once, or says in one sentence why it is none, or longer than
/// RunCutter::kMaxTicks, which bounds the memory for its places. `level`: that it must be on; null: any. Stops as
/// readReplay and trackOf do.
std::variant<RunTrack, std::string> readTrack(const std::filesystem::path& file, const Level* level = nullptr,
                                              const std::stop_token& stop = {});

/// The run of a recording that this program has made. Nothing if it is none, or was stopped.
std::optional<RunTrack> trackIn(std::span<const std::uint8_t> recording, const std::stop_token& stop = {});

}  // namespace platon
