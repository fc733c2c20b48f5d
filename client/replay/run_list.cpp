#include "client/replay/run_list.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <system_error>
#include <variant>

#include "client/replay/level_ghosts.h"
#include "client/replay/replay.h"
#include "platon/game/game.h"
#include "platon/game/recording_reader.h"

namespace platon {

namespace {

constexpr const char* kDamagedEnd = "is a damaged recording: playing its end does not lead to the recorded state";

// The end of a recording: its last block with ticks, and the state after it.
struct Ending {
  RecordedBlock block;
  std::vector<std::uint8_t> state;
  std::optional<RecordedRun> run;  // with the inputs of the whole recording; nothing: there is no tick
};

// Reads to the end. Notes why that is impossible.
Ending readEnding(RecordingReader& reader, std::string& note, const std::stop_token& stop) {
  Ending ending;
  std::optional<RecordedBlock> block = reader.next();
  if (!block) return ending;
  const std::optional<Game> start = gameBefore(*block, reader.level());
  if (!start) return note = Replay::kNoStart, ending;
  PlayCost cost(*start);
  for (; block && note.empty() && !stop.stop_requested(); block = reader.next()) {
    if (!cost.add(block->ticks(), block->slots)) note = Replay::kTooLong;
    if (block->ticks() != 0 && !ending.run) ending.run.emplace(*start);
    for (std::uint32_t tick = 0; tick < block->ticks(); ++tick) ending.run->add(block->inputsOf(tick));
    ending.state = block->state;
    if (block->ticks() != 0) ending.block = std::move(*block);
  }
  return ending;
}

// Plays the last block. Gives the time of the run, if it is one.
void playEnding(const std::shared_ptr<const Level>& level, const Ending& ending, RecordingFacts& facts,
                const std::stop_token& stop) {
  if (!ending.run) return;
  Game game(level);
  bool agrees = game.restore(ending.block.state) && game.tick() == ending.block.firstTick;
  const std::uint32_t last = ending.block.ticks() - 1;
  for (std::uint32_t tick = 0; agrees && tick < last; ++tick) {
    if (stop.stop_requested()) return;
    game.advance(ending.block.inputsOf(tick));
  }
  const Game before = game;
  if (agrees) game.advance(ending.block.inputsOf(last));
  agrees = agrees && game.save() == ending.state;
  if (!agrees) facts.note = kDamagedEnd;
  if (!agrees) return;
  const auto run = ending.run->finish(before, game);
  if (const auto* const finish = std::get_if<RunFinish>(&run)) {
    facts.ticks = finish->ticks;
  } else {
    facts.noRun = std::get<std::string>(run);
  }
}

}  // namespace

RecordingFacts readRecordingFacts(const std::filesystem::path& file, const std::stop_token& stop) {
  RecordingFacts facts;
  const RecordingBytes read = readRecordingBytes(file, stop);
  facts.note = read.fault;
  if (!facts.note.empty()) return facts;
  const auto bytes = read.bytes();
  RecordingReader reader(bytes);
  const std::optional<RecordingHead> head = readRecordingHead(bytes);
  if (!head) {
    const bool isCut = reader.state() == RecordingReader::State::kTruncated;
    facts.note = isCut ? recordingFault(reader, bytes) : "is not a recording";
    return facts;
  }
  facts.rules = head->rules;
  facts.level = head->level;
  const Ending ending = readEnding(reader, facts.note, stop);
  if (stop.stop_requested()) return facts;
  if (facts.note.empty()) facts.note = recordingFault(reader, bytes);
  if (facts.note.empty()) playEnding(head->level, ending, facts, stop);
  return facts;
}

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

std::string dateText(std::filesystem::file_time_type date) {
  using namespace std::chrono;
  const year_month_day day(floor<days>(file_clock::to_sys(date)));
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%04d-%02u-%02u", static_cast<int>(day.year()),
                static_cast<unsigned>(day.month()), static_cast<unsigned>(day.day()));
  return text.data();
}

namespace {

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
