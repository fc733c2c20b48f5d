#include "client/play/replay_pages.h"

#include <cstdlib>
#include <string_view>
#include <system_error>
#include <utility>

#include "client/menu/pages/replays_page.h"
#include "client/ui/player_rows.h"

namespace platon {
namespace {

namespace fs = std::filesystem;

std::string titleOf(const ListedRun& run) {
  if (run.level && !run.level->title.empty()) return run.level->title;
  if (!run.note.empty()) return run.file.filename().string();
  return run.isRead ? "Level without a title" : "…";
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
    : menu_(&menu), list_(RunStore(std::move(runs)), ghosts), ghosts_(std::move(ghosts)), calls_(std::move(calls)) {}

void ReplayPages::load() {
  list_.load();
  refresh();
  chosen_.reset();
  fault_.clear();
}

// Until the recording has been read, its level is not known, and so neither is its medal. By other rules it has none.
ReplayEntry ReplayPages::entryOf(const ListedRun& run) const {
  const std::string time = run.ticks ? finishTextOf(*run.ticks) : "";
  ReplayEntry entry{titleOf(run), time, run.date, run.who, run.isBest && run.isRead, run.note, run.noRun};
  if (!run.level || !run.ticks || !run.note.empty()) return entry;
  if (const std::optional<MedalTimes> times = calls_.medalsOf(run.level)) entry.medal = medalFor(*times, *run.ticks);
  return entry;
}

void ReplayPages::refresh() {
  entries_.clear();
  for (const ListedRun& run : list_.runs()) entries_.push_back(entryOf(run));
}

// The pages are made anew for each picture.
void ReplayPages::poll() {
  if (list_.poll()) refresh();
}

void ReplayPages::showList() {
  load();
  menu_->push([this] { return listPage(); });
}

void ReplayPages::showRun(const File& file) {
  showList();
  const std::size_t index = list_.indexOf(file);
  refresh();
  if (index < list_.listed()) menu_->setFocus(itemOfReplay(entries_, index));
  choose(index);
}

MenuPage ReplayPages::listPage() {
  poll();
  inList_ = true;
  chosen_.reset();
  return replaysPage(
      std::span(entries_).first(list_.listed()), [this](std::size_t index) { choose(index); },
      [this] { menu_->back(); });
}

void ReplayPages::choose(std::size_t index) {
  fault_.clear();
  menu_->push([this, index] { return pageOf(index); });
}

MenuPage ReplayPages::pageOf(std::size_t index) {
  poll();
  chosen_ = index;
  RunChoices choices;
  if (entries_[index].note.empty()) choices.watch = [this, index] { calls_.watch(File(fileOf(index))); };
  if (canRace(index)) choices.race = [this, index] { race(index); };
  if (canKeep(index)) choices.keep = [this, index] { keep(index); };
  choices.back = [this] { menu_->back(); };
  return runPage(entries_[index], shownPath(fileOf(index)), fault_, choices);
}

// One player is alone in the race.
bool ReplayPages::canRace(std::size_t index) const {
  if (entries_[index].time.empty() || !entries_[index].note.empty()) return false;
  const std::shared_ptr<const Level> level = levelOf(index);
  return level && level->players <= 1;
}

void ReplayPages::race(std::size_t index) {
  const std::string fault = calls_.race(levelOf(index), File(fileOf(index)));
  fault_ = fault.empty() ? "" : "The race cannot start: " + fault + ".";
}

bool ReplayPages::canKeep(std::size_t index) const {
  return index >= list_.listed() && !ghosts_.empty() && !entries_[index].time.empty() && entries_[index].note.empty();
}

void ReplayPages::keep(std::size_t index) {
  const File copy = freePath(ghosts_, fileOf(index).filename());
  std::error_code error;
  fs::create_directories(ghosts_, error);
  if (!error) fs::copy_file(fileOf(index), copy, error);
  if (error) {
    fault_ = "It cannot be kept: " + error.message() + ".";
    std::error_code ignored;
    if (error != std::errc::file_exists) fs::remove(copy, ignored);  // a part of it
    return;
  }
  menu_->back();
  menu_->back();
  showRun(copy);
}

std::shared_ptr<const Level> ReplayPages::shownLevel() const {
  if (!menu_->isOpen()) return nullptr;
  if (chosen_) return levelOf(*chosen_);
  if (!inList_ || list_.listed() == 0) return nullptr;
  return levelOf(replayOfItem(std::span(entries_).first(list_.listed()), menu_->focus()));
}

}  // namespace platon
