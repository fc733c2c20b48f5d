#pragma once

#include <cstdint>
#include <string>

namespace platon {

/// Something that happened to the file of a recording, for the log of the server.
struct RecordingEvent {
  enum class Kind {
    kFinished,  ///< the recording of a round is complete
    kStopped,   ///< the rest of a round is not recorded, for `reason`
    kRemoved,   ///< an old recording made room for new ones
  };

  Kind kind = Kind::kFinished;
  std::string file;         ///< path; empty if it is not known
  std::uint64_t ticks = 0;  ///< of kFinished: length of the recording
  std::uint64_t bytes = 0;  ///< of kFinished and kRemoved: size of the file
  std::string reason;       ///< of kStopped

  friend bool operator==(const RecordingEvent&, const RecordingEvent&) = default;
};

}  // namespace platon
