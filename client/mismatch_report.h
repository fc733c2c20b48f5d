#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "client/mismatch_watch.h"

namespace platon {

/// A mismatch as people read it.
struct MismatchReport {
  std::string summary;                   ///< one sentence without its end: tick, field, both values
  std::string text;                      ///< all there is to say but the recording; lines
  std::vector<std::uint8_t> recording;   ///< of the client's game
};

MismatchReport reportOf(Mismatch mismatch);

}  // namespace platon
