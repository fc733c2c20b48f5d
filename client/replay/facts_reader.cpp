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
  reading_.drop();
  files_.clear();
  for (const DatedFile& file : files) {
    if (knows(file)) {
      kept.insert(known_.extract(file.path));
    } else {
      files_.push_back(file);
      reading_.add([file](const std::stop_token& stop) { return read(file, stop); });
    }
  }
  known_ = std::move(kept);
}

// A file that another program is writing would only seem to be cut off.
RecordingFacts FactsReader::read(const DatedFile& file, const std::stop_token& stop) {
  RecordingFacts facts = readRecordingFacts(file.path, stop);
  std::error_code fault;
  DatedFile now{file.path, fs::file_size(file.path, fault), {}};
  if (!fault) now.date = fs::last_write_time(file.path, fault);
  if (!fault && !isSame(now, file)) facts = {.note = "is still being written; open this page again later"};
  return facts;
}

bool FactsReader::poll() {
  const std::size_t before = files_.size();
  for (auto facts = reading_.poll(); facts; facts = reading_.take()) {
    if (!facts->value) facts->value = RecordingFacts{.note = "cannot be read: " + facts->fault};
    remember({std::move(files_.front()), std::move(*facts->value)});
    files_.pop_front();
  }
  return files_.size() != before;
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
