#include "client/replay/level_ghosts.h"

#include <algorithm>
#include <system_error>
#include <utility>
#include <variant>

#include "client/replay/replay.h"
#include "client/ui/player_rows.h"
#include "platon/game/game.h"
#include "protocol/label.h"
#include "protocol/limits.h"

namespace platon {

namespace {

namespace fs = std::filesystem;

// Most files that are looked at in a folder of ghosts.
constexpr std::size_t kMaxGhostFiles = 64;

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

// A file that has the name of a kept run is called by its time.
Ghost makeGhost(const fs::path& file, RunTrack track) {
  const std::string name = hasNameOfRun(file) ? finishTextOf(track.ticks) : ghostNameOf(file);
  return {name, std::make_shared<RunTrack>(std::move(track))};
}

}  // namespace

std::string playedInVain(const fs::path& folder) {
  return folder.string() + ": " + std::to_string(kMaxPlayedInVain) +
         " recordings on this level are invalid or misnamed, so the others are not read; remove the bad ones";
}

std::string ghostNameOf(const fs::path& file) {
  const std::string name = file.stem().string();
  return isLabel(name, kMaxNameBytes) ? visibleLabel(name) : std::string();
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
