#include "client/replay/facts_reader.h"

#include <algorithm>
#include <system_error>

#include "client/replay/same_level.h"

namespace platon {
namespace {

namespace fs = std::filesystem;

bool isSame(const DatedFile& a, const DatedFile& b) { return a.bytes == b.bytes && a.date == b.date; }

}  // namespace

bool FactsReader::knows(const DatedFile& file) const {
  const auto known = known_.find(file.path);
  return known != known_.end() && isSame(known->second.file, file);
}

void FactsReader::read(const std::vector<DatedFile>& files) {
  poll();
  std::map<fs::path, Known> kept;
  waiting_.clear();
  std::vector<DatedFile> unknown;
  for (const DatedFile& file : files) {
    if (knows(file)) {
      kept.insert(known_.extract(file.path));
    } else {
      unknown.push_back(file);
    }
  }
  known_ = std::move(kept);
  job_ = {};  // before its results are dropped
  found_ = std::make_shared<Found>();
  if (!unknown.empty()) start(std::move(unknown));
}

void FactsReader::start(std::vector<DatedFile> files) {
  reading_ = std::move(files);
  job_ = Job<bool>(
      [files = reading_, found = found_](const std::stop_token& stop) { return readAll(files, *found, stop); }, start_);
}

bool FactsReader::readAll(const std::vector<DatedFile>& files, Found& found, const std::stop_token& stop) {
  if (files.size() > 1 && !stop.stop_possible()) return false;
  for (const DatedFile& file : files) {
    Known known = readOne(file, stop);
    if (stop.stop_requested()) break;
    const std::lock_guard lock(found.mutex);
    found.facts.push_back(std::move(known));
  }
  return true;
}

// A file that another program is writing would only seem to be cut off.
FactsReader::Known FactsReader::readOne(const DatedFile& file, const std::stop_token& stop) {
  Known known{file, readRecordingFacts(file.path, stop)};
  std::error_code fault;
  DatedFile now{file.path, fs::file_size(file.path, fault), {}};
  if (!fault) now.date = fs::last_write_time(file.path, fault);
  if (!fault && !isSame(now, file)) known.facts = {.note = "is still being written; open this page again later"};
  return known;
}

std::optional<JobResult<bool>> FactsReader::pollJob() {
  auto ended = job_.poll();
  if (ended && ended->value == false) waiting_.assign(reading_.begin(), reading_.end());
  if (job_.isPending() || waiting_.empty()) return ended;
  start({waiting_.front()});
  waiting_.pop_front();
  return job_.poll();
}

bool FactsReader::poll() {
  std::vector<Known> facts;
  const auto ended = pollJob();  // before what it has found
  {
    const std::lock_guard lock(found_->mutex);
    facts.swap(found_->facts);
  }
  const bool failed = ended && !ended->fault.empty();
  for (Known& known : facts) remember(std::move(known));
  if (!failed) return !facts.empty();
  for (const DatedFile& file : reading_) {
    if (!knows(file)) remember({file, {.note = "cannot be read: " + ended->fault}});
  }
  return true;
}

// Recordings on the same level share it, since it may be large.
void FactsReader::remember(Known known) {
  std::shared_ptr<const Level>& level = known.facts.level;
  const auto same = std::find_if(known_.begin(), known_.end(), [&](const auto& each) {
    return level && each.second.facts.level && isSameLevel(*each.second.facts.level, *level);
  });
  if (same != known_.end()) level = same->second.facts.level;
  const fs::path path = known.file.path;
  known_.insert_or_assign(path, std::move(known));
}

const RecordingFacts* FactsReader::find(const fs::path& file) const {
  const auto known = known_.find(file);
  return known == known_.end() ? nullptr : &known->second.facts;
}

}  // namespace platon
