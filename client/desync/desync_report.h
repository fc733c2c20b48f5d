#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "client/desync/desync_detector.h"

namespace platon {

/// Human-readable report of a desync.
struct DesyncReport {
  std::string summary;                  ///< one line without a full stop: ticks, field and both values
  std::string text;                     ///< everything except the recording, several lines
  std::vector<std::uint8_t> recording;  ///< of the client's game
};

DesyncReport reportOf(Desync desync);

}  // namespace platon
