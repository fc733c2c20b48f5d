#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "platon/game/game.h"
#include "protocol/program_error.h"

namespace platon::sim {

/// Longest recording that is read: weeks of play by eight players.
inline constexpr std::size_t kMaxRecordingBytes = std::size_t{1} << 30;
inline constexpr unsigned kMaxJobs = 256;

/// What came out of the recordings of a server, or of a fleet.
struct VerifySummary {
  std::uint64_t recordings = 0;  ///< replayed or refused; the sum of the next three
  std::uint64_t agree = 0;
  std::uint64_t differ = 0;   ///< with a divergence
  std::uint64_t invalid = 0;  ///< damaged, cut off or of other rules
  std::uint64_t skipped = 0;  ///< a server is still writing it, or it was removed meanwhile
  std::uint64_t ticks = 0;    ///< replayed
  double seconds = 0;         ///< of this run, from the first recording to the last
  unsigned jobs = 1;          ///< threads

  /// Seconds of play that a thread replays in a second.
  double timesRealTime() const { return static_cast<double>(ticks) / (kTicksPerSecond * seconds * jobs); }
  /// Recordings that a thread replays in an hour.
  double recordingsPerHour() const { return static_cast<double>(recordings) * 3600 / (seconds * jobs); }
  /// 1 if a recording differs, else 3 if one is invalid, else 0.
  int exitCode() const { return differ != 0 ? ProgramError::kFailed : invalid != 0 ? ProgramError::kInvalid : 0; }
};

bool isFolder(const std::string& path);

/// The recordings among `paths`, in order: a file is one, a folder stands for all files in it and its folders whose
/// names end with ".recording", by name. Throws UsageError for a path that does not exist, cannot be read or holds no
/// recording.
std::vector<std::string> recordingsAmong(const std::vector<std::string>& paths);

/// Replays the recordings with `jobs` threads, 1 … kMaxJobs. Gives `fault` the sentences on each that is not right, in
/// the order of the recordings and as early as this order allows, and `counted` how many of the recordings are done;
/// both from one thread at a time.
VerifySummary verifyMany(const std::vector<std::string>& recordings, unsigned jobs,
                         const std::function<void(const std::string&)>& fault,
                         const std::function<void(std::size_t)>& counted);

}  // namespace platon::sim
