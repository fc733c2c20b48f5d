#include "client/replay/level_ghosts.h"

#include <utility>
#include <variant>

#include "client/replay/replay_file.h"
#include "client/replay/same_level.h"
#include "client/replay/track_file.h"
#include "client/ui/player_rows.h"

namespace platon {
namespace {

// It may be among the others, or the best run.
void addRival(const OtherRunsSource& source, const Level& level, LevelGhosts& ghosts, const std::stop_token& stop) {
  const std::filesystem::path& file = source.rival;
  if (file.empty() || file == source.bestFile) return;
  const std::optional<RecordingHead> head = readRecordingHeadOf(file, stop);
  if (!head || !head->level || !isSameLevel(*head->level, level)) return;
  auto track = readTrack(file, &level, stop);
  if (auto* fault = std::get_if<std::string>(&track)) return ghosts.faults.push_back(std::move(*fault));
  Ghost rival = makeGhost(file, std::get<RunTrack>(std::move(track)));
  std::erase_if(ghosts.others, [&](const Ghost& other) { return other.name == rival.name; });
  ghosts.others.insert(ghosts.others.begin(), std::move(rival));
}

std::uint32_t ticksOf(const std::optional<Ghost>& ghost) { return ghost ? ghost->track->ticks : UINT32_MAX; }

}  // namespace

Ghost bestGhostOf(RunTrack track) {
  const std::string name = "best " + finishTextOf(track.ticks);
  return {name, std::make_shared<RunTrack>(std::move(track))};
}

LevelGhosts readBestGhost(const BestRunSource& source, const Level& level, const std::stop_token& stop) {
  LevelGhosts ghosts;
  if (const std::optional<StoredRun> stored = source.own.best(level)) ghosts.bestFile = stored->file;
  if (source.unsaved) {
    if (auto track = trackIn(source.unsaved->recording, stop)) ghosts.best = bestGhostOf(std::move(*track));
    return ghosts;
  }
  std::size_t played = 0;
  for (const StoredRun& run : source.own.runsOn(level)) {
    if (stop.stop_requested() || ticksOf(ghosts.best) <= run.ticks) break;
    if (played++ == kMaxPlayedInVain) {
      ghosts.faults.push_back(playedInVain(run.file.parent_path()));
      break;
    }
    auto track = readTrack(run.file, &level, stop);
    if (auto* fault = std::get_if<std::string>(&track)) {
      ghosts.faults.push_back(std::move(*fault));
    } else if (std::get<RunTrack>(track).ticks < ticksOf(ghosts.best)) {
      ghosts.best = bestGhostOf(std::get<RunTrack>(std::move(track)));
      ghosts.bestFile = run.file;
    }
  }
  return ghosts;
}

LevelGhosts readOtherGhosts(const OtherRunsSource& source, const Level& level, std::size_t maxOthers,
                            const std::stop_token& stop) {
  LevelGhosts ghosts;
  ghosts.others = ghostsIn(source.folder, level, maxOthers, ghosts.faults, stop);
  addRival(source, level, ghosts, stop);
  return ghosts;
}

}  // namespace platon
