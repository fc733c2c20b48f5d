#include "client/replay/run_list.h"

#include <algorithm>
#include <optional>
#include <system_error>
#include <utility>
#include <variant>

#include "client/replay/ghost_folder.h"
#include "client/replay/replay_file.h"
#include "client/replay/track_file.h"
#include "client/ui/player_rows.h"
#include "platon/game/game.h"
#include "protocol/files/bounded_folder.h"

namespace platon {
namespace {

namespace fs = std::filesystem;

// Friends give files names; the name that the game has given says nothing.
std::string ownerOf(const fs::path& file) {
  const std::string name = hasNameOfRun(file) ? std::string() : ghostNameOf(file);
  return name.empty() ? "a friend" : name;
}

// Of a long recording, the time is not worth the time to play it.
std::string timeOf(const fs::path& file) {
  std::error_code fault;
  if (fs::file_size(file, fault) > RunStore::kMaxRunBytes || fault) return {};
  const auto track = readTrack(file);
  const auto* const run = std::get_if<RunTrack>(&track);
  return run == nullptr ? std::string() : finishText(double{1} * run->ticks / kTicksPerSecond);
}

}  // namespace

ListedRun describeRecording(const fs::path& file) {
  ListedRun entry{file, {}, {}, {}, 0, "is not a recording"};
  entry.who = ownerOf(file);
  std::error_code fault;
  const fs::file_time_type date = fs::last_write_time(file, fault);
  if (!fault) entry.date = dateText(date);
  const std::optional<RecordingHead> head = readRecordingHeadOf(file);
  if (!head) return entry;
  entry.rules = head->rules;
  if (head->level) entry.title = head->level->title;
  entry.note = head->rules == kRulesVersion ? "" : otherRulesText(head->rules);
  if (entry.note.empty()) entry.time = timeOf(file);
  return entry;
}

std::vector<ListedRun> listRecordings(const RunStore& own, const fs::path& ghosts) {
  std::vector<ListedRun> entries = own.list();
  if (ghosts.empty()) return entries;
  std::vector<DatedFile> others = newestFiles(ghosts, Subfolders::kWithout, [](const fs::path&) { return true; });
  others.resize(std::min(others.size(), kMaxListedOthers));
  for (const DatedFile& file : others) entries.push_back(describeRecording(file.path));
  return entries;
}

}  // namespace platon
