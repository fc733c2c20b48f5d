#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <variant>

#include "client/replay/recording_head.h"
#include "client/replay/replay.h"

namespace platon {

/// The content of a file that may be a recording, or why there is none, as the end of a sentence that begins with the
/// name of the file: it cannot be read, is too large, or is no file but a folder or a pipe, which might never end.
/// Reads a MiB at a time, and ends with the present one when it is asked to stop.
struct RecordingBytes {
  std::string content{};
  std::string fault{};  ///< empty: there is content

  std::span<const std::uint8_t> bytes() const;
};
RecordingBytes readRecordingBytes(const std::filesystem::path& file, const std::stop_token& stop = {});

/// Reads a recording from a file, or says in one sentence why it cannot be played. Stops as
/// readRecordingBytes and Replay::read do, and tells its progress as the latter.
std::variant<std::shared_ptr<const Replay>, std::string> readReplay(const std::filesystem::path& file,
                                                                    const std::stop_token& stop = {},
                                                                    ReplayProgress* progress = nullptr);

/// Reads the head of a recording from a file. Nothing if it cannot be read, or was stopped.
std::optional<RecordingHead> readRecordingHeadOf(const std::filesystem::path& file, const std::stop_token& stop = {});

}  // namespace platon
