#include "client/replay/level_ghosts.h"

#include <utility>
#include <variant>

#include "client/replay/replay_file.h"
#include "client/replay/same_level.h"
#include "client/replay/track_file.h"
#include "client/ui/player_rows.h"

namespace platon {
namespace {

void readBest(const GhostSources& sources, const Level& level, LevelGhosts& ghosts, const std::stop_token& stop) {
  if (const std::optional<StoredRun> stored = sources.own.best(level)) ghosts.bestFile = stored->file;
  if (sources.unsaved) {
    if (auto track = trackIn(sources.unsaved->recording, stop)) ghosts.best = bestGhostOf(std::move(*track));
    return;
  }
  if (ghosts.bestFile.empty()) return;
  auto track = readTrack(ghosts.bestFile, &level, stop);
  if (auto* run = std::get_if<RunTrack>(&track)) {
    ghosts.best = bestGhostOf(std::move(*run));
  } else {
    ghosts.faults.push_back(std::get<std::string>(std::move(track)));
  }
}

// It may be among the others, or the best run.
void addRival(const std::filesystem::path& file, const Level& level, LevelGhosts& ghosts, const std::stop_token& stop) {
  if (file.empty() || file == ghosts.bestFile) return;
  const std::optional<RecordingHead> head = readRecordingHeadOf(file, stop);
  if (!head || !head->level || !isSameLevel(*head->level, level)) return;
  auto track = readTrack(file, &level, stop);
  if (auto* fault = std::get_if<std::string>(&track)) return ghosts.faults.push_back(std::move(*fault));
  Ghost rival = makeGhost(file, std::get<RunTrack>(std::move(track)));
  std::erase_if(ghosts.others, [&](const Ghost& other) { return other.name == rival.name; });
  ghosts.others.insert(ghosts.others.begin(), std::move(rival));
}

}  // namespace

Ghost bestGhostOf(RunTrack track) {
  const std::string name = "best " + finishTextOf(track.ticks);
  return {name, std::make_shared<RunTrack>(std::move(track))};
}

LevelGhosts readLevelGhosts(const GhostSources& sources, const Level& level, std::size_t maxOthers,
                            const std::stop_token& stop) {
  LevelGhosts ghosts;
  readBest(sources, level, ghosts, stop);
  ghosts.others = ghostsIn(sources.folder, level, maxOthers, ghosts.faults, stop);
  addRival(sources.rival, level, ghosts, stop);
  return ghosts;
}

}  // namespace platon
