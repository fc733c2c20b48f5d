#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <variant>

#include "client/replay/recording_head.h"
#include "client/replay/replay.h"

namespace platon {

/// Reads a recording from a file, or says in one sentence why it cannot be played. Stops as Replay::read does.
std::variant<std::shared_ptr<const Replay>, std::string> readReplay(const std::filesystem::path& file,
                                                                    const std::stop_token& stop = {});

/// Reads the head of a recording from a file. Nothing if it cannot be read.
std::optional<RecordingHead> readRecordingHeadOf(const std::filesystem::path& file);

}  // namespace platon
