#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <stop_token>
#include <string>
#include <vector>

#include "client/replay/run_track.h"

namespace platon {

/// A run that is shown beside the own attempt.
struct Ghost {
  std::string name;
  std::shared_ptr<const RunTrack> track;
};

/// Most files that are looked at in a folder of ghosts.
inline constexpr std::size_t kMaxGhostFiles = 64;

/// Most recordings on a level that are played although they turn out to be no ghosts. Each of them may cost as much as
/// any recording.
inline constexpr std::size_t kMaxPlayedInVain = 8;

/// Says that files in this folder are not read because so many others were played in vain.
std::string playedInVain(const std::filesystem::path& folder);

/// What can be shown of the name of a ghost's file; empty if that is not valid text.
std::string ghostNameOf(const std::filesystem::path& file);

/// The ghost of a run that was read from this file. A file that has the name of a kept run is called by its time.
Ghost makeGhost(const std::filesystem::path& file, RunTrack track);

/// The runs on this level in a folder, of the first `count` files by name; the ghost has the name of its file. Adds to
/// `faults` a sentence for each recording on this level that cannot be a ghost, and ends after kMaxPlayedInVain of
/// them. Ends early when it is asked to stop; then neither is to be used.
std::vector<Ghost> ghostsIn(const std::filesystem::path& folder, const Level& level, std::size_t count,
                            std::vector<std::string>& faults, const std::stop_token& stop = {});

}  // namespace platon
