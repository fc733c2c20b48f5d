#include "client/play/front_pages.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <memory>
#include <optional>
#include <stdexcept>
#include <utility>
#include <variant>

#include "client/files/user_folders.h"
#include "client/menu/pages/failure_page.h"
#include "client/menu/pages/several_players_page.h"
#include "client/replay/replay.h"
#include "protocol/files/bounded_folder.h"
#include "protocol/files/text_file.h"
#include "protocol/program_error.h"
#include "protocol/transport/udp_socket.h"

namespace platon {
namespace {

// For how long a list of servers is not read again.
constexpr Time kListLife = std::chrono::seconds(60);

std::optional<std::uint16_t> portOf(const std::string& text) {
  std::uint16_t port = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), port);
  if (error != std::errc() || end != text.data() + text.size() || port == 0) return std::nullopt;
  return port;
}

// The file of a level for the server in this program. A file of its own: another program may play another level. Never
// in a folder that others can write to: they could put a link in its place. Empty without a folder of the user.
std::filesystem::path racedLevelFile(const Level& level) {
  const std::filesystem::path folder = cacheFolder();
  return folder.empty() ? folder : folder / "raced" / (std::to_string(level.hash) + ".level");
}

// Returns why the level cannot be written to its file, or an empty text.
std::string writeRacedLevel(const Level& level, const std::filesystem::path& file) {
  constexpr std::size_t kMaxFiles = 16;
  if (file.empty()) return "there is no folder for its level; set HOME or XDG_CACHE_HOME";
  std::error_code ignored;
  std::filesystem::create_directories(file.parent_path(), ignored);
  // A file that is written again begins the round of another program that plays this level anew.
  const auto kept = readTextFile(file.string(), kMaxLevelBytes);
  const auto* const text = std::get_if<std::string>(&kept);
  const bool isKept = text != nullptr && *text == level.text;
  const std::string fault = isKept ? "" : replaceCachedFile(file.string(), level.text);
  const auto isLevel = [](const std::filesystem::path& path) { return path.extension() == ".level"; };
  removeOldest(newestFiles(file.parent_path(), Subfolders::kWithout, isLevel), kMaxFiles, kMaxFiles * kMaxLevelBytes);
  return fault.empty() ? "" : "its level cannot be written to " + file.string() + ": " + fault;
}

JoinForm::Found rowOf(const std::string& name, const std::string& address, const std::string& about) {
  return name.empty() ? JoinForm::Found{address, address, about}
                      : JoinForm::Found{name, address, address + ", " + about};
}

// None if the folder cannot be read; in alphabetical order.
std::vector<std::string> levelNamesIn(const std::filesystem::path& folder) {
  const auto isLevel = [](const std::filesystem::path& path) { return path.extension() == ".level"; };
  std::vector<std::string> names;
  for (const DatedFile& file : newestFiles(folder, Subfolders::kWithout, isLevel))
    names.push_back(file.path.filename().string());
  std::sort(names.begin(), names.end());
  return names;
}

// New servers come last, so that none moves from under the focus.
std::vector<JoinForm::Found> inOldOrder(const std::vector<JoinForm::Found>& old, std::vector<JoinForm::Found> found) {
  const auto placeOf = [&](const JoinForm::Found& server) {
    return std::find_if(old.begin(), old.end(),
                        [&](const JoinForm::Found& other) { return other.address == server.address; });
  };
  std::stable_sort(found.begin(), found.end(),
                   [&](const JoinForm::Found& a, const JoinForm::Found& b) { return placeOf(a) < placeOf(b); });
  return found;
}

}  // namespace

JoinPage::JoinPage(Menu& menu, Settings& settings, RecentServers recent, std::string listUrl, Start start,
                   ThreadStart startThread)
    : menu_(&menu),
      settings_(&settings),
      recent_(std::move(recent)),
      givenListUrl_(std::move(listUrl)),
      start_(std::move(start)),
      startThread_(std::move(startThread)) {
  form_.asksList = givenListUrl_.empty();
}

void JoinPage::show() {
  form_.fault.clear();
  form_.asksPassword = false;
  form_.recent.clear();
  form_.listFault.clear();
  listUrlFault_.clear();
  form_.listUrl.setText(settings_->listUrl);
  enteredListUrl_ = settings_->listUrl;
  for (const ServerAddress& server : recent_.list()) form_.recent.push_back(server.text());
  menu_->push([this] {
    shown_ = true;
    return joinPage(form_, [this] { join(); });
  });
}

void JoinPage::update(Time now) {
  const bool shown = std::exchange(shown_, false);
  // While the player types, the URL is not complete.
  const bool types = shown && menu_->isOpen() && menu_->focus() == itemOfList(form_);
  if (form_.asksList && !types) takeListUrl();
  std::erase_if(stopped_, [](const auto& list) { return list->hasStopped(); });
  if (!shown) {
    near_.reset();
    form_.found.clear();
    return;
  }
  try {
    readList(now);
    if (!near_) near_.emplace(searchNearby());
    near_->update(now);
  } catch (const SocketError&) {
    near_.reset();  // joining says why
  }
  form_.found = inOldOrder(form_.found, foundServers());
}

const std::string& JoinPage::listUrl() const { return givenListUrl_.empty() ? settings_->listUrl : givenListUrl_; }

// A URL that is refused changes nothing: the one before is kept.
void JoinPage::takeListUrl() {
  const std::string& text = form_.listUrl.text();
  if (text == enteredListUrl_) return;
  enteredListUrl_ = text;
  const bool valid = text.empty() || isListUrl(text);
  listUrlFault_ = valid ? "" : std::string("The list of servers must be ") + kListUrlForm + ".";
  if (!valid || text == settings_->listUrl) return;
  settings_->listUrl = text;
  listReadAt_.reset();
  if (!listed_) return;
  listed_->stop();
  stopped_.push_back(std::move(listed_));
}

// The list is kept while other pages are shown.
void JoinPage::readList(Time now) {
  form_.listFault = listUrlFault_;
  form_.hasList = !listUrl().empty();
  if (!form_.hasList) return;
  const bool pageIsNew = !near_;
  if (!listReadAt_ || (pageIsNew && now - *listReadAt_ >= kListLife)) {
    listed_ = std::make_unique<ListedServers>(listUrl(), NameLookup::firstAddressOf, startThread_);
    listReadAt_ = now;
  }
  listed_->update(now);
  if (listUrlFault_.empty() && !listed_->faults().empty()) form_.listFault = listed_->faults().front();
}

std::vector<JoinForm::Found> JoinPage::foundServers() const {
  std::vector<JoinForm::Found> found;
  if (listed_) {
    for (const FoundServer& server : listed_->list())
      found.push_back(rowOf(server.listed.name, server.listed.address.text(), describe(server.answer)));
  }
  if (!near_) return found;
  for (const NearServer& server : near_->list()) {
    const std::string address = ServerAddress{server.address.ip.text(), server.address.port}.text();
    found.push_back(rowOf(server.info.name, address, describe(server)));
  }
  return found;
}

void JoinPage::askPassword(const ServerAddress& server, bool wrong) {
  show();
  form_.address.setText(server.text());
  form_.password.setText("");
  form_.asksPassword = true;
  form_.fault = wrong ? "The password is wrong." : "The server needs a password.";
  menu_->setFocus(1);
}

void JoinPage::join() {
  MatchChoice choice;
  try {
    choice.server = parseServerAddress(form_.address.text());
  } catch (const std::invalid_argument& error) {
    form_.fault = form_.address.text().empty() ? "Enter the address of the server." : error.what();
    return;
  }
  if (listed_) choice.key = listed_->keyOf(*choice.server);
  if (form_.asksPassword) choice.password = Password(form_.password.text());
  start_(choice);
}

FrontPages::FrontPages(Menu& menu, Settings& settings, RecentServers recent, Calls calls, Given given)
    : menu_(&menu),
      settings_(&settings),
      givenName_(std::move(given.name)),
      settingsPages_(menu, settings),
      calls_(std::move(calls)),
      replays_(menu, runsFolder(), ghostsFolder(),
               {[this](const std::filesystem::path& file) { calls_.watch(file); },
                [this](const std::shared_ptr<const Level>& level, const std::filesystem::path& file) {
                  return race(level, file);
                },
                [this](const std::shared_ptr<const Level>& level) { return entryOf(level).medals; }}),
      joinPage_(menu, settings, std::move(recent), std::move(given.listUrl), calls_.start, calls_.startThread) {
  name_.setText(settings.name);
}

void FrontPages::load() {
  if (levels_.empty()) levels_ = calls_.loadLevels();
  entries_ = entriesOf(levels_, bestTimesFile().string(), ReachedLevels(reachedLevelsFile()));
}

bool FrontPages::showTitle() {
  try {
    load();
  } catch (const ProgramError& error) {
    menu_->open([this, reason = std::string(error.what())] { return failedTitle(reason); });
    return false;
  }
  replays_.leave();
  menu_->open([this] { return titlePage(); });
  return true;
}

// Nothing is behind it: going back leads nowhere.
MenuPage FrontPages::failedTitle(const std::string& reason) {
  MenuPage page = failurePage(
      "The levels of the game cannot be read", reason, [this] { showTitle(); }, calls_.quit);
  page.items.back().name = "Quit";
  page.back = {};
  return page;
}

MenuPage FrontPages::titlePage() {
  beside_ = [this] { return nextLevel(); };
  replays_.leave();
  MenuPage page{"Platon"};
  page.large = true;
  page.place = MenuPage::Place::kLeft;
  page.items = {{.name = "Play", .value = entries_[nextLevel()].title, .choose = [this] { playFrom(nextLevel()); }},
                {.name = "Levels", .choose = [this] { showLevels(); }},
                {.name = "Join a server", .choose = [this] { showJoin(); }},
                {.name = "Host a game", .choose = [this] { showHost(); }},
                {.name = "Replays", .choose = [this] { replays_.showList(); }},
                {.name = "Level editor", .choose = [this] { pushEditor(); }},
                nameItem(),
                {.name = "Settings", .choose = [this] { settingsPages_.show(MenuPage::Place::kLeft); }},
                {.name = "Quit", .choose = calls_.quit}};
  return page;
}

MenuItem FrontPages::nameItem() {
  if (!givenName_.empty()) return {.name = "Your name", .value = givenName_, .choose = [] {}};
  takeName(name_.text(), settings_->name);
  MenuItem item{MenuItem::Kind::kText, "Your name", "type it here"};
  item.field = &name_;
  return item;
}

// The first level for one player whose goal the player has not reached yet; else the first one.
std::size_t FrontPages::nextLevel() const {
  const auto open = std::find_if(entries_.begin(), entries_.end(),
                                 [](const LevelEntry& entry) { return entry.players == 1 && !entry.reached; });
  return open == entries_.end() ? 0 : static_cast<std::size_t>(open - entries_.begin());
}

std::shared_ptr<const Level> FrontPages::shownLevel() {
  if (levels_.empty()) return nullptr;
  if (std::shared_ptr<const Level> level = replays_.shownLevel()) return level;
  const std::optional<std::size_t> level = beside_ && menu_->isOpen() ? beside_() : nextLevel();
  return level ? levels_[*level].level : nullptr;
}

std::optional<std::size_t> FrontPages::shippedIndexOf(const Level& level) const {
  const auto shipped = std::find_if(levels_.begin(), levels_.end(),
                                    [&](const ShippedLevel& each) { return isSameLevel(*each.level, level); });
  if (shipped == levels_.end()) return std::nullopt;
  return static_cast<std::size_t>(shipped - levels_.begin());
}

LevelEntry FrontPages::entryOf(const std::shared_ptr<const Level>& level) const {
  const std::optional<std::size_t> shipped = shippedIndexOf(*level);
  return shipped ? entries_[*shipped] : platon::entryOf({"", level});
}

// Without the levels of the game a match goes on without medals.
std::optional<MedalTimes> FrontPages::medalsOf(const std::shared_ptr<const Level>& level) {
  try {
    load();
  } catch (const ProgramError&) {
    return std::nullopt;
  }
  return entryOf(level).medals;
}

void FrontPages::showLevels() {
  menu_->push([this] {
    beside_ = [this] { return levelOfItem(entries_, menu_->focus()); };
    return levelsPage(entries_, [this](std::size_t level) { choose(level); });
  });
  menu_->setFocus(itemOfLevel(entries_, nextLevel()));
}

// Alone, nobody finishes a level for several players.
void FrontPages::choose(std::size_t level) {
  entries_[level].players > 1 ? showSeveralPlayers(level) : playFrom(level);
}

void FrontPages::showSeveralPlayers(std::size_t level) {
  menu_->push([this, level] {
    beside_ = [level] { return level; };
    return severalPlayersPage(entries_[level], {[this, level] { playFrom(level); }, [this, level] { hostLevel(level); },
                                                [this] { showJoin(); }});
  });
}

void FrontPages::hostLevel(std::size_t level) {
  hostForm_.level = level;
  hostForm_.players = std::max<double>(hostForm_.players, entries_[level].players);
  showHost();
  menu_->setFocus(kHostStartItem);  // all is set already
}

std::vector<std::string> FrontPages::filesFrom(std::size_t level) const {
  std::vector<std::string> files;
  for (std::size_t i = 0; i < levels_.size(); ++i) files.push_back(levels_[(level + i) % levels_.size()].file);
  return files;
}

void FrontPages::playFrom(std::size_t level) {
  beside_ = [level] { return level; };  // also behind a page that says why it cannot be played
  MatchChoice choice;
  choice.own.levels = filesFrom(level);
  choice.own.waitsForOne = true;
  calls_.start(choice);
}

// A level that did not come with the game is in the recording alone. Returns why it cannot be played, or an empty text.
std::string FrontPages::race(const std::shared_ptr<const Level>& level, const std::filesystem::path& rival) {
  MatchChoice choice;
  choice.rival = rival;
  choice.own.waitsForOne = true;
  if (const std::optional<std::size_t> shipped = shippedIndexOf(*level)) {
    choice.own.levels = filesFrom(*shipped);
  } else {
    const std::filesystem::path file = racedLevelFile(*level);
    if (std::string fault = writeRacedLevel(*level, file); !fault.empty()) return fault;
    choice.own.levels = {file.string()};
  }
  calls_.start(choice);
  return {};
}

void FrontPages::showRun(const std::filesystem::path& file) {
  if (showTitle()) replays_.showRun(file);
}

void FrontPages::askPassword(const ServerAddress& server, bool wrong) {
  if (!showTitle()) return;
  beside_ = [] { return std::nullopt; };
  joinPage_.askPassword(server, wrong);
}

void FrontPages::refuseHost(const std::string& reason) {
  if (!showTitle()) return;
  showHost();
  hostForm_.fault = reason;
  menu_->setFocus(kHostPortItem);
}

void FrontPages::showEditor(const std::string& fault) {
  if (!showTitle()) return;
  pushEditor();
  editForm_.fault = fault;
}

// The list is read when the page is opened: who makes a level comes back to a new one.
void FrontPages::pushEditor() {
  const std::filesystem::path folder = ownLevelsFolder();
  editForm_.fault = folder.empty() ? "There is no folder for levels; set HOME or XDG_DATA_HOME." : "";
  editForm_.folder = folder.string();
  editForm_.files = levelNamesIn(folder);
  menu_->push([this] {
    beside_ = [] { return std::nullopt; };
    return editorPage(
        editForm_, [this] { createLevel(); },
        [this](const std::string& file) { calls_.edit(ownLevelsFolder() / file, editForm_.solid); });
  });
}

void FrontPages::createLevel() {
  const std::filesystem::path folder = ownLevelsFolder();
  if (folder.empty()) return;
  const std::string file = levelFileNameOf(editForm_.name.text());
  std::error_code fault;
  std::filesystem::create_directories(folder, fault);
  editForm_.fault = file.empty()                             ? "Enter a name for the level, with letters or digits."
                    : fault                                  ? folder.string() + " cannot be made: " + fault.message()
                    : std::filesystem::exists(folder / file) ? "There is a level of this name: choose it below."
                                                             : "";
  if (editForm_.fault.empty()) calls_.edit(folder / file, editForm_.solid);
}

void FrontPages::showJoin() {
  beside_ = [] { return std::nullopt; };
  joinPage_.show();
}

void FrontPages::showHost() {
  hostForm_.fault.clear();
  menu_->push([this] {
    beside_ = [this] { return hostForm_.level; };
    return hostPage(hostForm_, entries_, [this] { host(); });
  });
}

// Why the form is refused; empty: it is not.
std::string FrontPages::hostFault() const {
  if (!portOf(hostForm_.port.text())) return "The port must be a number from 1 to 65535.";
  const LevelEntry& first = entries_[hostForm_.level];
  if (hostForm_.players >= first.players) return "";
  return first.title + " needs " + std::to_string(first.players) +
         " players: allow at least that many, or choose another first level.";
}

void FrontPages::host() {
  hostForm_.fault = hostFault();
  if (!hostForm_.fault.empty()) return;
  MatchChoice choice;
  choice.own.levels = filesFrom(hostForm_.level);
  if (hostForm_.onlyLevel) choice.own.levels.resize(1);
  choice.own.listens = true;
  choice.own.waitsForOne = true;
  choice.own.port = *portOf(hostForm_.port.text());
  choice.own.password = hostForm_.password.text();
  choice.own.maxPlayers = static_cast<std::uint32_t>(std::lround(hostForm_.players));
  calls_.start(choice);
}

}  // namespace platon
