#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "client/replay/run_store.h"
#include "client/replay/run_track.h"

namespace platon {

/// A run that is shown beside the own attempt.
struct Ghost {
  std::string name;
  std::shared_ptr<const RunTrack> track;
};

/// Most recordings on a level that are played although they turn out to be no ghosts. Each of them may cost as much as
/// any recording.
inline constexpr std::size_t kMaxPlayedInVain = 8;

/// Says that files in this folder are not read because so many others were played in vain.
std::string playedInVain(const std::filesystem::path& folder);

/// What can be shown of the name of a ghost's file; empty if that is not valid text.
std::string ghostNameOf(const std::filesystem::path& file);

/// The runs on this level in a folder, of the first `count` files by name; the ghost has the name of its file. Adds to
/// `faults` a sentence for each recording on this level that cannot be a ghost, and ends after kMaxPlayedInVain of
/// them. Ends early when it is asked to stop; then neither is to be used.
std::vector<Ghost> ghostsIn(const std::filesystem::path& folder, const Level& level, std::size_t count,
                            std::vector<std::string>& faults, const std::stop_token& stop = {});

/// The ghosts of a level, read from files.
struct LevelGhosts {
  std::optional<Ghost> best{};        ///< nothing: there is no best run, or it cannot be played
  std::filesystem::path bestFile{};   ///< of the best run that is kept; if none can be played, of the first
  std::vector<Ghost> others{};        ///< the rival first
  std::vector<std::string> faults{};  ///< a sentence for each recording on the level that cannot be a ghost
};

/// Where the best run is.
struct BestRunSource {
  RunStore own;
  std::shared_ptr<const Run> unsaved;  ///< the best run, while its file is not written; null: the store has it
};

/// Where the runs of others are. Empty paths: there are none.
struct OtherRunsSource {
  std::filesystem::path folder;
  std::filesystem::path rival;     ///< a recording that is a ghost on its level besides those
  std::filesystem::path bestFile;  ///< of the best run, which is no rival
};

/// The ghost of a best run.
Ghost bestGhostOf(RunTrack track);

/// Reads the best run on a level and plays it once. A file that is no run, or a slower one than its name tells, leaves
/// its place to the one with the next least time, as do at most kMaxPlayedInVain files. Ends early when it is asked to
/// stop; then the result is not to be used.
LevelGhosts readBestGhost(const BestRunSource& source, const Level& level, const std::stop_token& stop = {});
/// As readBestGhost, for the runs of others: at most `maxOthers` from the folder. These files may be many and long.
LevelGhosts readOtherGhosts(const OtherRunsSource& source, const Level& level, std::size_t maxOthers,
                            const std::stop_token& stop = {});

}  // namespace platon
