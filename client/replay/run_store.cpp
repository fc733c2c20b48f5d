#include "client/replay/run_store.h"

#include <algorithm>
#include <charconv>
#include <system_error>
#include <utility>

#include "platon/game/game.h"
#include "protocol/files/bounded_folder.h"
#include "protocol/files/text_file.h"
#include "protocol/hash_text.h"

namespace platon {

namespace {

namespace fs = std::filesystem;

std::string nameOf(std::uint64_t level, std::uint32_t rules, std::uint32_t ticks) {
  return hashText(level) + '-' + std::to_string(rules) + '-' + std::to_string(ticks) + ".recording";
}

// Nothing if it is not the name of a run.
std::optional<StoredRun> runOf(const fs::path& file) {
  const std::string name = file.filename().string();
  StoredRun run;
  run.file = file;
  const char* const end = name.data() + name.size();
  auto read = std::from_chars(name.data(), end, run.level, 16);
  if (read.ptr != end) read = std::from_chars(read.ptr + 1, end, run.rules);
  if (read.ptr != end) read = std::from_chars(read.ptr + 1, end, run.ticks);
  return name == nameOf(run.level, run.rules, run.ticks) ? std::optional(run) : std::nullopt;
}

// Whether this is surely a recording on another level, perhaps one with the same hash.
bool isOnOtherLevel(const fs::path& file, const Level& level) {
  const std::optional<RecordingHead> head = readRecordingHeadOf(file);
  return head && head->level && !isSameLevel(*head->level, level);
}

}  // namespace

std::string RunStore::fileNameOf(std::uint64_t level, std::uint32_t ticks) {
  return nameOf(level, kRulesVersion, ticks);
}

bool hasNameOfRun(const fs::path& file) { return runOf(file).has_value(); }

std::vector<StoredRun> RunStore::all() const {
  std::vector<StoredRun> runs;
  if (folder_.empty()) return runs;
  for (const DatedFile& file : newestFiles(folder_, Subfolders::kWith, hasNameOfRun)) {
    runs.push_back(*runOf(file.path));
    runs.back().bytes = file.bytes;
    runs.back().date = file.date;
  }
  return runs;
}

// Those that may be the best run, the one with the least time first.
std::vector<StoredRun> RunStore::candidates(const Level& level) const {
  std::vector<StoredRun> runs;
  for (const StoredRun& run : all()) {
    const fs::path folder = run.file.parent_path();
    const bool seen = folder == folder_ || folder == keepFolder();
    if (seen && run.level == level.hash && run.rules == kRulesVersion) runs.push_back(run);
  }
  std::stable_sort(runs.begin(), runs.end(), [](const auto& a, const auto& b) { return a.ticks < b.ticks; });
  return runs;
}

std::optional<StoredRun> RunStore::bestByName(const Level& level) const {
  const std::vector<StoredRun> runs = candidates(level);
  return runs.empty() ? std::nullopt : std::optional(runs.front());
}

std::vector<StoredRun> RunStore::runsOn(const Level& level) const {
  std::vector<StoredRun> runs = candidates(level);
  std::erase_if(runs, [&](const StoredRun& run) { return isOnOtherLevel(run.file, level); });
  return runs;
}

std::optional<StoredRun> RunStore::best(const Level& level) const {
  const std::vector<StoredRun> runs = runsOn(level);
  return runs.empty() ? std::nullopt : std::optional(runs.front());
}

std::optional<StoredRun> RunStore::ownRunOf(const fs::path& file) const {
  std::optional<StoredRun> run = file.parent_path() == folder_ ? runOf(file) : std::nullopt;
  return run && run->rules == kRulesVersion ? run : std::nullopt;
}

fs::path RunStore::fileOf(const Run& run) const { return keepFolder() / fileNameOf(run.level->hash, run.ticks); }

// The new file is there before the old one goes, so at any time there is a best run.
std::string RunStore::keep(const Run& run) {
  if (folder_.empty()) return {};
  if (run.recording.size() > kMaxRunBytes) return "its recording is too large";
  std::error_code ignored;
  const fs::path folder = keepFolder();
  fs::create_directories(folder, ignored);  // writing reports the error
  const fs::path file = fileOf(run);
  const std::string fault =
      replaceTextFile(file.string(), {reinterpret_cast<const char*>(run.recording.data()), run.recording.size()});
  if (!fault.empty()) return file.string() + ": " + fault;
  for (const StoredRun& old : all()) {
    const bool replaced = old.level == run.level->hash && old.rules == kRulesVersion && old.ticks > run.ticks;
    if (!replaced || old.file.parent_path() != folder || isOnOtherLevel(old.file, *run.level)) continue;
    fs::remove(old.file, ignored);
  }
  limit();
  return {};
}

void RunStore::limit() const {
  removeOldest(newestFiles(folder_, Subfolders::kWithout, hasNameOfRun), kMaxRuns, kMaxBytes);
  if (server_.empty()) return;
  removeOldest(newestFiles(keepFolder(), Subfolders::kWithout, hasNameOfRun), kMaxServerRuns, kMaxServerBytes);
  limitServers();
}

// The servers come in the order of their newest runs.
void RunStore::limitServers() const {
  std::vector<fs::path> servers;
  std::error_code ignored;
  for (const DatedFile& run : newestFiles(serversFolder(), Subfolders::kWith, hasNameOfRun)) {
    const fs::path server = run.path.parent_path();
    if (std::find(servers.begin(), servers.end(), server) == servers.end()) servers.push_back(server);
  }
  for (std::size_t i = kMaxServers; i < servers.size(); ++i) fs::remove_all(servers[i], ignored);
}

void RunSaver::keep(Run run) {
  waiting_.push_back(std::make_shared<const Run>(std::move(run)));
  writing_.add(
      [store = store_, kept = waiting_.back()](const std::stop_token&) { return RunStore(store).keep(*kept); });
}

void RunSaver::takeWritten() {
  for (auto written = writing_.poll(); written; written = writing_.take()) {
    std::string fault = written->value ? std::move(*written->value) : std::move(written->fault);
    if (!fault.empty()) fault_ = std::move(fault);
    waiting_.pop_front();
  }
}

std::shared_ptr<const Run> RunSaver::unsavedOn(const Level& level) const {
  const auto last = std::find_if(waiting_.rbegin(), waiting_.rend(),
                                 [&](const auto& run) { return isSameLevel(*run->level, level); });
  return last == waiting_.rend() ? nullptr : *last;
}

std::optional<std::string> RunSaver::poll() {
  takeWritten();
  return fault_.empty() ? std::nullopt : std::optional(std::exchange(fault_, {}));
}

void RunSaver::finish() {
  writing_.finish();
  takeWritten();
}

}  // namespace platon
