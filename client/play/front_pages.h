#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "client/lobby/listed_servers.h"
#include "client/lobby/near_servers.h"
#include "client/lobby/remembered.h"
#include "client/lobby/shipped_levels.h"
#include "client/menu/menu.h"
#include "client/menu/pages/editor_page.h"
#include "client/menu/pages/levels_page.h"
#include "client/menu/pages/settings_pages.h"
#include "client/menu/pages/several_players_page.h"
#include "client/menu/text_field.h"
#include "client/play/match/live_match.h"
#include "client/play/replay_pages.h"
#include "client/ui/settings.h"
#include "protocol/limits.h"

namespace platon {

/// The page to join a server. While it is shown, it finds servers nearby and those of a list on a web server.
class JoinPage {
 public:
  using Start = std::function<void(const MatchChoice&)>;

  /// `menu` and `settings` outlive the page. `listUrl`: as FrontPages::Given has it. `start` joins what the player has
  /// chosen, `startThread` reads lists.
  JoinPage(Menu& menu, Settings& settings, RecentServers recent, std::string listUrl, Start start,
           ThreadStart startThread);

  /// Shows the page above the present one.
  void show();
  /// Shows it to ask for the password of a server, after it has refused another one if `wrong`.
  void askPassword(const ServerAddress& server, bool wrong);
  /// Finds servers while the page is shown. Call in each frame.
  void update(Time now);

 private:
  const std::string& listUrl() const;
  void takeListUrl();
  void readList(Time now);
  std::vector<JoinForm::Found> foundServers() const;
  void join();

  Menu* menu_;
  Settings* settings_;
  RecentServers recent_;
  std::string givenListUrl_;
  Start start_;
  ThreadStart startThread_;
  JoinForm form_;
  std::optional<NearServers> near_;        // since the page was shown
  std::string enteredListUrl_;             // that was looked at last
  std::string listUrlFault_;               // why it is refused; empty: it is not
  std::unique_ptr<ListedServers> listed_;  // since the page was shown first, of the present URL; null: none
  std::vector<std::unique_ptr<ListedServers>> stopped_;  // of other URLs, until they need not be waited for
  std::optional<Time> listReadAt_;
  bool shown_ = false;  // since the last update
};

/// The pages before a match: title, levels, joining, hosting and replays.
class FrontPages {
 public:
  struct Calls {
    std::function<void(const MatchChoice&)> start;  ///< what the player has chosen
    std::function<void()> quit;
    std::function<void(const std::filesystem::path&)> watch{};  ///< a recording
    /// A level file; `solid`: of a new one.
    std::function<void(const std::filesystem::path& file, SolidKind solid)> edit{};
    /// The levels of the game; throws ProgramError if they cannot be read.
    std::function<std::vector<ShippedLevel>()> loadLevels = loadShippedLevels;
    ThreadStart startThread = &platon::startThread;  ///< for the reading of a list of servers
  };

  /// What takes the place of settings, which the player may change otherwise; empty: nothing.
  struct Given {
    std::string listUrl{};  ///< a list of servers on a web server
    std::string name{};     ///< of the player
  };

  /// `menu` and `settings` outlive the pages.
  FrontPages(Menu& menu, Settings& settings, RecentServers recent, Calls calls, Given given);
  FrontPages(Menu& menu, Settings& settings, RecentServers recent, Calls calls)
      : FrontPages(menu, settings, std::move(recent), std::move(calls), Given()) {}

  /// Shows the title and nothing else. If the levels of the game cannot be read, shows why instead and returns false.
  bool showTitle();
  /// Asks for the password of a server, after it has refused another one if `wrong`.
  void askPassword(const ServerAddress& server, bool wrong);
  /// Shows the page to host a game again, with the reason why it cannot be hosted like that.
  void refuseHost(const std::string& reason);
  /// As JoinPage::update.
  void update(Time now) { joinPage_.update(now); }
  /// The level to see behind the pages; null before the title was shown, and behind the page to join a server, which
  /// may play any.
  std::shared_ptr<const Level> shownLevel();
  /// What is known of a level. One that did not come with the game has no medals.
  LevelEntry entryOf(const std::shared_ptr<const Level>& level) const;
  /// The medals of a level, also before the title was shown; reads files.
  std::optional<MedalTimes> medalsOf(const std::shared_ptr<const Level>& level);
  /// Shows the title, and above it the page that leads to the editor, with the reason why a level cannot be edited;
  /// empty: it can.
  void showEditor(const std::string& fault = {});
  /// Shows the title and, if there is one, above it the page of a recording.
  void showRun(const std::filesystem::path& file);

 private:
  MenuPage titlePage();
  MenuItem nameItem();
  MenuPage failedTitle(const std::string& reason);
  void showLevels();
  void choose(std::size_t level);
  void showSeveralPlayers(std::size_t level);
  void hostLevel(std::size_t level);
  void showHost();
  void pushEditor();
  void createLevel();
  void showJoin();
  void playFrom(std::size_t level);
  std::string race(const std::shared_ptr<const Level>& level, const std::filesystem::path& rival);
  std::string hostFault() const;
  void host();
  void load();
  std::size_t nextLevel() const;
  /// Where a level stands in levels_; nothing if it did not come with the game.
  std::optional<std::size_t> shippedIndexOf(const Level& level) const;
  std::vector<std::string> filesFrom(std::size_t level) const;

  Menu* menu_;
  Settings* settings_;
  std::string givenName_;
  TextField name_{kMaxNameBytes};
  SettingsPages settingsPages_;
  Calls calls_;
  std::vector<ShippedLevel> levels_;
  std::vector<LevelEntry> entries_;  // of levels_
  // The level to see behind the page that was shown last, if any.
  std::function<std::optional<std::size_t>()> beside_;
  ReplayPages replays_;
  JoinPage joinPage_;
  HostForm hostForm_;
  EditForm editForm_;
};

}  // namespace platon
