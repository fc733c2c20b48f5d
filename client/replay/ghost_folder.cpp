#include "client/replay/ghost_folder.h"

#include <algorithm>
#include <system_error>
#include <utility>
#include <variant>

#include "client/replay/replay_file.h"
#include "client/replay/run_store.h"
#include "client/replay/same_level.h"
#include "client/replay/track_file.h"
#include "client/ui/player_rows.h"
#include "platon/game/game.h"
#include "protocol/label.h"
#include "protocol/limits.h"

namespace platon {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> filesOf(const fs::path& folder) {
  std::vector<fs::path> files;
  std::error_code fault;
  for (fs::directory_iterator entry(folder, fault), end; !fault && entry != end; entry.increment(fault)) {
    std::error_code ignored;
    if (entry->is_regular_file(ignored)) files.push_back(entry->path());
  }
  std::sort(files.begin(), files.end());
  if (files.size() > kMaxGhostFiles) files.resize(kMaxGhostFiles);
  return files;
}

}  // namespace

std::string playedInVain(const fs::path& folder) {
  return folder.string() + ": " + std::to_string(kMaxPlayedInVain) +
         " recordings on this level are not the runs that their names tell, so the others are not read; remove them";
}

std::string ghostNameOf(const fs::path& file) {
  const std::string name = file.stem().string();
  return isLabel(name, kMaxNameBytes) ? visibleLabel(name) : std::string();
}

Ghost makeGhost(const fs::path& file, RunTrack track) {
  const std::string name = hasNameOfRun(file) ? finishTextOf(track.ticks) : ghostNameOf(file);
  return {name, std::make_shared<RunTrack>(std::move(track))};
}

std::vector<Ghost> ghostsIn(const fs::path& folder, const Level& level, std::size_t count,
                            std::vector<std::string>& faults, const std::stop_token& stop) {
  std::vector<Ghost> ghosts;
  if (folder.empty()) return ghosts;
  std::size_t inVain = 0;
  for (const fs::path& file : filesOf(folder)) {
    if (ghosts.size() == count || stop.stop_requested()) break;
    const std::optional<RecordingHead> head = readRecordingHeadOf(file, stop);
    if (!head || !head->level || !isSameLevel(*head->level, level)) continue;
    if (inVain == kMaxPlayedInVain) return faults.push_back(playedInVain(folder)), ghosts;
    auto track = readTrack(file, nullptr, stop);
    if (auto* fault = std::get_if<std::string>(&track)) {
      if (head->rules == kRulesVersion) ++inVain;  // others are not played
      faults.push_back(std::move(*fault));
    } else {
      ghosts.push_back(makeGhost(file, std::get<RunTrack>(std::move(track))));
    }
  }
  return ghosts;
}

}  // namespace platon
