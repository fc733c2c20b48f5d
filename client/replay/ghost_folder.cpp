#include "client/replay/ghost_folder.h"

#include <algorithm>
#include <system_error>
#include <utility>
#include <variant>

#include "client/replay/replay_file.h"
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

// What can be shown of the name of a file.
std::string nameOf(const fs::path& file) {
  const std::string name = file.stem().string();
  return isLabel(name, kMaxNameBytes) ? visibleLabel(name) : std::string();
}

std::variant<RunTrack, std::string> readTrack(const fs::path& file) {
  const auto replay = readReplay(file);
  if (const auto* fault = std::get_if<std::string>(&replay)) return *fault;
  std::optional<RunTrack> track = trackOf(*std::get<std::shared_ptr<const Replay>>(replay));
  if (!track) return file.string() + ": is no run: it does not end with a player at the goal";
  return std::move(*track);
}

}  // namespace

std::vector<Ghost> ghostsIn(const fs::path& folder, std::uint64_t level, std::size_t count,
                            std::vector<std::string>& faults) {
  std::vector<Ghost> ghosts;
  if (folder.empty()) return ghosts;
  for (const fs::path& file : filesOf(folder)) {
    if (ghosts.size() == count) break;
    const std::optional<RecordingHead> head = readRecordingHeadOf(file);
    if (!head || !head->level || head->level->hash != level) continue;
    auto track = readTrack(file);
    if (auto* fault = std::get_if<std::string>(&track)) {
      faults.push_back(std::move(*fault));
    } else {
      ghosts.push_back({nameOf(file), std::make_shared<RunTrack>(std::get<RunTrack>(std::move(track)))});
    }
  }
  return ghosts;
}

}  // namespace platon
