#include "client/replay/run_list.h"

#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <system_error>
#include <utility>

#include "client/replay/ghost_folder.h"

namespace platon {
namespace {

namespace fs = std::filesystem;

// Friends give files names; the name that the game has given says nothing.
std::string ownerOf(const fs::path& file) {
  const std::string name = hasNameOfRun(file) ? std::string() : ghostNameOf(file);
  return name.empty() ? "a friend" : name;
}

}  // namespace

RunList::RunList(RunStore own, fs::path ghosts, ThreadStart start)
    : own_(std::move(own)), ghosts_(std::move(ghosts)), reader_(std::move(start)) {}

void RunList::load() {
  files_.clear();
  runs_.clear();
  for (const StoredRun& run : own_.all()) {
    if (runs_.size() == kMaxOwn) break;
    add({run.file, run.bytes, run.date}, {.file = run.file, .ticks = run.ticks});
  }
  std::vector<DatedFile> others;
  if (!ghosts_.empty()) others = newestFiles(ghosts_, Subfolders::kWithout, [](const fs::path&) { return true; });
  others.resize(std::min(others.size(), kMaxOthers));
  for (const DatedFile& file : others) add(file, {.file = file.path, .who = ownerOf(file.path)});
  listed_ = runs_.size();
  reader_.read(files_);
  fill();
}

void RunList::add(const DatedFile& file, ListedRun run) {
  if (file.date != fs::file_time_type()) run.date = dateText(file.date);
  files_.push_back(file);
  runs_.push_back(std::move(run));
}

std::size_t RunList::indexOf(const fs::path& file) {
  const auto found = std::find_if(runs_.begin(), runs_.end(), [&](const ListedRun& run) { return run.file == file; });
  const auto index = static_cast<std::size_t>(found - runs_.begin());
  if (found != runs_.end()) return index;
  std::error_code fault;
  DatedFile dated{file, fs::file_size(file, fault), {}};
  if (!fault) dated.date = fs::last_write_time(file, fault);
  add(dated, {.file = file, .who = ownerOf(file)});
  reader_.read(files_);
  fill();
  return index;
}

bool RunList::poll() {
  const bool found = reader_.poll();
  if (found) fill();
  return found;
}

// The name of an own run tells its time, as long as its recording does not tell more.
void RunList::fill() {
  for (ListedRun& run : runs_) {
    const RecordingFacts* const facts = reader_.find(run.file);
    if (facts == nullptr) continue;
    run.level = facts->level;
    run.note = facts->note;
    run.noRun = facts->noRun;
    run.isRead = true;
    if (!run.who.empty() || run.note.empty()) run.ticks = facts->ticks;
  }
  markBest();
}

// Somebody may have renamed a file.
void RunList::markBest() {
  std::map<std::uint64_t, std::pair<std::uint32_t, std::size_t>> best;  // by level: ticks and index
  for (std::size_t i = 0; i < runs_.size() && runs_[i].who.empty(); ++i) {
    runs_[i].isBest = false;
    const std::optional<StoredRun> run = own_.ownRunOf(runs_[i].file);
    if (!run || !runs_[i].note.empty() || !runs_[i].ticks) continue;
    const RecordingFacts* const facts = reader_.find(runs_[i].file);
    if (facts != nullptr && facts->level && facts->level->hash != run->level) continue;
    const auto place = std::pair(*runs_[i].ticks, i);
    const auto known = best.try_emplace(run->level, place).first;
    known->second = std::min(known->second, place);
  }
  for (const auto& [level, place] : best) runs_[place.second].isBest = true;
}

}  // namespace platon
