#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "platon/game/recording_reader.h"

namespace platon {

/// Why a reader of this recording has stopped, as the end of a sentence that begins with the name of the file; empty at
/// the end of a complete recording.
std::string recordingFault(const RecordingReader& reader, std::span<const std::uint8_t> recording);

/// Says what is wrong with a recording, as the end of such a sentence.
std::string damagedText(const std::string& fault);

}  // namespace platon
