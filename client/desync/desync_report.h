#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "client/desync/desync_detector.h"

namespace platon {

/// A desync as people read it.
struct DesyncReport {
  std::string summary;                  ///< one sentence without its end: tick, field, both values
  std::string text;                     ///< all there is to say but the recording; lines
  std::vector<std::uint8_t> recording;  ///< of the client's game
};

DesyncReport reportOf(Desync desync);

}  // namespace platon
