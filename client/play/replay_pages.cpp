#include "client/play/replay_pages.h"

#include <algorithm>
#include <cstdlib>
#include <optional>
#include <string_view>
#include <system_error>
#include <utility>

#include "client/menu/pages/run_page.h"
#include "client/replay/replay_file.h"
#include "client/replay/run_list.h"

namespace platon {
namespace {

namespace fs = std::filesystem;

ReplayEntry entryOf(const ListedRun& run) {
  const std::string title = run.title.empty() ? "Level without a title" : run.title;
  return {title, run.time, run.date, run.who, run.isBest, run.note};
}

// As people write it: below the home folder with a tilde.
std::string shownPath(const fs::path& file) {
  const char* const home = std::getenv("HOME");
  const std::string path = file.string();
  const std::string_view base = home == nullptr ? "" : home;
  return base.size() > 1 && path.starts_with(std::string(base) + '/') ? "~" + path.substr(base.size()) : path;
}

// A path in `folder` at which there is no file yet.
fs::path freePath(const fs::path& folder, const fs::path& name) {
  fs::path path = folder / name;
  std::error_code ignored;
  for (int copy = 2; fs::exists(path, ignored); ++copy) {
    path = folder / (name.stem().string() + " " + std::to_string(copy) + name.extension().string());
  }
  return path;
}

}  // namespace

ReplayPages::ReplayPages(Menu& menu, File runs, File ghosts, Calls calls)
    : menu_(&menu), store_(std::move(runs)), ghosts_(std::move(ghosts)), calls_(std::move(calls)) {}

void ReplayPages::load() {
  entries_.clear();
  files_.clear();
  for (const ListedRun& run : listRecordings(store_, ghosts_)) {
    entries_.push_back(entryOf(run));
    files_.push_back(run.file);
  }
  listed_ = files_.size();
  levelFile_.clear();
  fault_.clear();
}

void ReplayPages::showList() {
  load();
  menu_->push([this] { return listPage(); });
}

void ReplayPages::showRun(const File& file) {
  showList();
  const std::size_t index = indexOf(file);
  if (index < listed_) menu_->setFocus(itemOfReplay(entries_, index));
  choose(index);
}

std::size_t ReplayPages::indexOf(const File& file) {
  const auto found = std::find(files_.begin(), files_.end(), file);
  if (found != files_.end()) return static_cast<std::size_t>(found - files_.begin());
  entries_.push_back(entryOf(describeRecording(file)));
  files_.push_back(file);
  return files_.size() - 1;
}

MenuPage ReplayPages::listPage() {
  inList_ = true;
  chosen_.clear();
  return replaysPage(
      std::span(entries_).first(listed_), [this](std::size_t index) { choose(index); }, [this] { menu_->back(); });
}

void ReplayPages::choose(std::size_t index) {
  fault_.clear();
  menu_->push([this, index] { return pageOf(index); });
}

MenuPage ReplayPages::pageOf(std::size_t index) {
  chosen_ = files_[index];
  RunChoices choices;
  if (entries_[index].note.empty()) choices.watch = [this, index] { calls_.watch(File(files_[index])); };
  if (canRace(index)) choices.race = [this, index] { calls_.race(levelOf(files_[index]), File(files_[index])); };
  if (canKeep(index)) choices.keep = [this, index] { keep(index); };
  choices.back = [this] { menu_->back(); };
  return runPage(entries_[index], shownPath(files_[index]), fault_, choices);
}

// One player is alone in the race.
bool ReplayPages::canRace(std::size_t index) {
  if (entries_[index].time.empty() || !entries_[index].note.empty()) return false;
  const std::shared_ptr<const Level>& level = levelOf(files_[index]);
  return level && level->players <= 1;
}

bool ReplayPages::canKeep(std::size_t index) const {
  return index >= listed_ && !ghosts_.empty() && !entries_[index].time.empty() && entries_[index].note.empty();
}

void ReplayPages::keep(std::size_t index) {
  const File copy = freePath(ghosts_, files_[index].filename());
  std::error_code error;
  fs::create_directories(ghosts_, error);
  if (!error) fs::copy_file(files_[index], copy, error);
  if (error) {
    fault_ = "It cannot be kept: " + error.message() + ".";
    return;
  }
  menu_->back();
  menu_->back();
  showRun(copy);
}

const std::shared_ptr<const Level>& ReplayPages::levelOf(const File& file) {
  if (file == levelFile_) return level_;
  const std::optional<RecordingHead> head = readRecordingHeadOf(file);
  levelFile_ = file;
  level_ = head ? head->level : nullptr;
  return level_;
}

std::shared_ptr<const Level> ReplayPages::shownLevel() {
  if (!menu_->isOpen()) return nullptr;
  if (!chosen_.empty()) return levelOf(chosen_);
  if (!inList_ || listed_ == 0) return nullptr;
  return levelOf(files_[replayOfItem(std::span(entries_).first(listed_), menu_->focus())]);
}

}  // namespace platon
