#include "client/play/front_pages.h"

#include <atomic>
#include <functional>
#include <future>
#include <optional>
#include <string>
#include <utility>

#include <gtest/gtest.h>

#include "client/files/user_folders.h"
#include "client/time/steady_now.h"
#include "protocol/program_error.h"
#include "tests/client/lobby/web_server.h"
#include "tests/client/replay/followed_game.h"
#include "tests/shared/game/played_game.h"
#include "tests/support/environment_variable.h"
#include "tests/support/files.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/wait_until.h"

namespace platon::front_pages_test {
namespace {

class FrontPagesTest : public testing::Test {
 protected:
  FrontPagesTest() { pages_.showTitle(); }

  void tap(Key key, int times = 1) {
    for (int i = 0; i < times; ++i) menu_.handle({key, KeyEvent::Kind::kPress}, font_);
  }
  void type(std::string_view text) {
    for (const char character : text) {
      KeyEvent event;
      event.kind = KeyEvent::Kind::kCharacter;
      event.character = static_cast<char32_t>(character);
      menu_.handle(event, font_);
    }
  }
  bool shows(const std::string& text) {
    for (const Overlay::Text& each : menu_.overlay(font_, false).texts) {
      if (each.content.find(text) != std::string::npos) return true;
    }
    return false;
  }

  // Draws pictures of the page until `done` or for long.
  bool drawUntil(const std::function<bool()>& done) {
    return waitUntil([&] {
      menu_.overlay(font_, false);
      pages_.update(steadyClock().now());
      return done();
    });
  }

  // Puts a recording where those of friends are.
  std::filesystem::path keepGhost(const std::string& recording) const {
    std::filesystem::create_directories(ghostsFolder());
    writeText(ghostsFolder() / "Anna.recording", recording);
    return ghostsFolder() / "Anna.recording";
  }
  // Shows the page of a run on a level that is not of the game, and returns the text of that level.
  std::string showRunOnAnotherLevel() {
    FollowedGame game(cubeLevel("0 0 -180 0", {"-240 -200 240 -200"}, "0 100 -190"));
    game.hold(30, 0);
    game.holdToGoal(300, Input::kRight);
    const std::vector<std::uint8_t>& bytes = game.run.value().recording;
    pages_.showRun(keepGhost({reinterpret_cast<const char*>(bytes.data()), bytes.size()}));
    EXPECT_TRUE(waitUntil([&] { return shows("Race"); }));
    return game.game.level().text;
  }

  const TemporaryFolder folder_;
  const EnvironmentVariable cache_{"XDG_CACHE_HOME", folder_.path().string()};
  const EnvironmentVariable data_{"XDG_DATA_HOME", folder_.path().string()};
  Font font_;
  Menu menu_;
  Settings settings_;
  std::optional<MatchChoice> started_;
  bool quit_ = false;
  std::pair<std::filesystem::path, SolidKind> edited_{{}, SolidKind::kTetrahedron};
  FrontPages pages_{menu_,
                    settings_,
                    RecentServers(folder_ / "recent"),
                    {[this](const MatchChoice& choice) { started_ = choice; },
                     [this] { quit_ = true; },
                     {},
                     [this](const std::filesystem::path& file, SolidKind solid) {
                       edited_ = {file, solid};
                     }}};
};

TEST_F(FrontPagesTest, PlayStartsTheFirstLevelAndTheOthersFollow) {
  EXPECT_TRUE(shows("Run and jump"));
  tap(Key::kEnter);
  ASSERT_TRUE(started_);
  EXPECT_FALSE(started_->server);
  EXPECT_FALSE(started_->own.listens);
  EXPECT_EQ(started_->own.levels.size(), loadShippedLevels().size());
  EXPECT_NE(started_->own.levels.front().find("01_run_and_jump"), std::string::npos);
}

TEST_F(FrontPagesTest, ANewLevelIsMadeInTheFolderOfThePlayer) {
  tap(Key::kArrowDown, 5);
  tap(Key::kEnter);
  tap(Key::kArrowDown, 2);
  tap(Key::kEnter);
  EXPECT_TRUE(shows("Enter a name"));
  EXPECT_TRUE(edited_.first.empty());
  tap(Key::kArrowUp, 2);
  type("My room");
  tap(Key::kArrowDown, 2);
  tap(Key::kEnter);
  EXPECT_EQ(edited_.first, ownLevelsFolder() / "My_room.level");
  EXPECT_EQ(edited_.second, SolidKind::kHexahedron);
  EXPECT_TRUE(std::filesystem::is_directory(ownLevelsFolder()));
}

TEST_F(FrontPagesTest, TheLevelsOfThePlayerAreListedAndNotMadeAgain) {
  std::filesystem::create_directories(ownLevelsFolder());
  for (const char* const name : {"b.level", "a.level", "notes.txt"}) writeText(ownLevelsFolder() / name, "");
  pages_.showEditor("it is broken");
  EXPECT_TRUE(shows("it is broken"));
  EXPECT_TRUE(shows("a.level") && shows("b.level"));
  EXPECT_FALSE(shows("notes.txt"));
  type("a");
  tap(Key::kArrowDown, 2);
  tap(Key::kEnter);
  EXPECT_TRUE(shows("There is a level of this name"));
  tap(Key::kArrowDown);
  tap(Key::kEnter);
  EXPECT_EQ(edited_.first, ownLevelsFolder() / "a.level");
}

TEST_F(FrontPagesTest, ThePlayerEntersItsNameWhichTheSettingsKeep) {
  tap(Key::kArrowDown, 6);
  type(" Ann  Lee");
  EXPECT_TRUE(shows("Ann  Lee"));
  EXPECT_EQ(settings_.name, "Ann Lee") << "as it is seen";
  type(std::string(40, 'x'));
  EXPECT_TRUE(shows("xx"));
  EXPECT_LE(settings_.name.size(), kMaxNameBytes);
  tap(Key::kBackspace, 40);
  EXPECT_FALSE(shows("Ann"));
  EXPECT_EQ(settings_.name, "");
}

TEST_F(FrontPagesTest, TheNameOfTheCommandLineIsShownInstead) {
  settings_.name = "Ann";
  Menu menu;
  FrontPages pages(menu, settings_, RecentServers(folder_ / "recent"), {[](const MatchChoice&) {}, [] {}},
                   {.name = "Ben"});
  pages.showTitle();
  const std::vector<Overlay::Text> texts = menu.overlay(font_, false).texts;
  const auto has = [&texts](const std::string& text) {
    return std::any_of(texts.begin(), texts.end(), [&text](const Overlay::Text& each) { return each.content == text; });
  };
  EXPECT_TRUE(has("Ben"));
  EXPECT_FALSE(has("Ann"));
  EXPECT_EQ(settings_.name, "Ann");
}

TEST_F(FrontPagesTest, WhoAlwaysPlaysSlowedAdvancesToTheNextLevel) {
  const std::vector<ShippedLevel> levels = loadShippedLevels();
  ReachedLevels(reachedLevelsFile()).add(levels[0].level->hash);
  pages_.showTitle();
  tap(Key::kEnter);
  ASSERT_TRUE(started_);
  EXPECT_EQ(started_->own.levels.front(), levels[1].file);
}

TEST_F(FrontPagesTest, ALevelWithTheHashOfOneOfTheGameHasNoMedals) {
  auto forged = std::make_shared<Level>(*loadShippedLevels().front().level);
  forged->text += "# another";
  EXPECT_FALSE(pages_.medalsOf(forged));
}

TEST_F(FrontPagesTest, LevelsStartsTheChosenOneAndShowsItBesideTheList) {
  tap(Key::kArrowDown);
  tap(Key::kEnter);
  tap(Key::kArrowDown);
  EXPECT_EQ(pages_.shownLevel()->title, loadShippedLevels()[1].level->title);
  tap(Key::kEnter);
  ASSERT_TRUE(started_);
  EXPECT_EQ(started_->own.levels.front(), loadShippedLevels()[1].file);
  EXPECT_EQ(started_->own.levels.back(), loadShippedLevels()[0].file);
}

// Before, it started another level without a word.
TEST_F(FrontPagesTest, ALevelForTwoIsHostedOrJoinedAndSaysWhy) {
  const std::vector<ShippedLevel> levels = loadShippedLevels();
  int seen = 0;
  for (const ShippedLevel& level : levels) {
    if (level.level->players < 2) continue;
    ++seen;
    const auto openLevel = [&] {
      pages_.showTitle();
      tap(Key::kArrowDown);
      tap(Key::kEnter);
      for (std::size_t i = 0; i < levels.size() && pages_.shownLevel()->hash != level.level->hash; ++i)
        tap(Key::kArrowUp);
      tap(Key::kEnter);
      EXPECT_TRUE(!started_ && shows("This level needs 2 players")) << level.file;
    };
    openLevel();
    tap(Key::kEnter);
    ASSERT_TRUE(started_) << level.file << ": together on this machine";
    EXPECT_EQ(std::exchange(started_, {})->own.levels.front(), level.file);
    openLevel();
    tap(Key::kArrowDown, 2);
    tap(Key::kEnter);
    EXPECT_TRUE(shows("Address")) << "the page to join a server";
    EXPECT_EQ(pages_.shownLevel(), nullptr) << "the server may play any level";
    tap(Key::kEscape);
    tap(Key::kArrowUp);
    tap(Key::kEnter);
    EXPECT_TRUE(shows("First level"));
    tap(Key::kEnter);
    ASSERT_TRUE(started_) << level.file << ": Enter starts it, the focus is on the last item";
    EXPECT_TRUE(started_->own.listens);
    EXPECT_EQ(started_->own.levels.front(), level.file);
    EXPECT_GE(started_->own.maxPlayers, 2U);
    started_.reset();
  }
  EXPECT_EQ(seen, 6);
}

// Before, Esc led to the title, and all that was entered had to be entered again.
TEST_F(FrontPagesTest, WhatCannotBeHostedIsToldOnThePageThatIsToBeChanged) {
  tap(Key::kArrowDown, 3);
  tap(Key::kEnter);
  tap(Key::kArrowRight);
  tap(Key::kArrowUp);
  tap(Key::kEnter);
  ASSERT_TRUE(started_);
  pages_.refuseHost("Another program uses UDP port 7777: choose another port.");
  EXPECT_TRUE(shows("choose another port"));
  tap(Key::kBackspace);
  type("8");
  tap(Key::kArrowDown, 2);
  tap(Key::kEnter);
  EXPECT_EQ(started_->own.port, 7778);
  EXPECT_EQ(started_->own.levels.front(), loadShippedLevels()[1].file);
  EXPECT_FALSE(shows("choose another port"));
  tap(Key::kEscape);
  EXPECT_TRUE(shows("Host a game")) << "the title";
}

TEST_F(FrontPagesTest, ALevelForTwoIsNotHostedForOne) {
  tap(Key::kArrowDown, 3);
  tap(Key::kEnter);
  for (int i = 0; i < 32 && !shows("Hold the door"); ++i) tap(Key::kArrowRight);
  tap(Key::kArrowDown, 2);
  tap(Key::kArrowLeft, 7);
  tap(Key::kArrowDown, 3);
  tap(Key::kEnter);
  EXPECT_FALSE(started_);
  EXPECT_TRUE(shows("Hold the door needs 2 players: allow at least that many"));
  tap(Key::kArrowUp, 3);
  tap(Key::kArrowRight);
  tap(Key::kArrowDown, 3);
  tap(Key::kEnter);
  ASSERT_TRUE(started_);
  EXPECT_EQ(started_->own.maxPlayers, 2U);
}

// Before, the next level to play was shown.
TEST_F(FrontPagesTest, HostShowsTheChosenLevel) {
  const std::vector<ShippedLevel> levels = loadShippedLevels();
  tap(Key::kArrowDown, 3);
  tap(Key::kEnter);
  EXPECT_EQ(pages_.shownLevel()->title, levels[0].level->title);
  tap(Key::kArrowRight, 2);
  EXPECT_EQ(pages_.shownLevel()->title, levels[2].level->title);
  tap(Key::kArrowDown);
  EXPECT_EQ(pages_.shownLevel()->title, levels[2].level->title) << "at every item";
  tap(Key::kEscape);
  EXPECT_EQ(pages_.shownLevel()->title, levels[0].level->title) << "the title shows the next level";
}

TEST_F(FrontPagesTest, OnlyLevelsOfTheGameHaveMedals) {
  EXPECT_TRUE(pages_.medalsOf(loadShippedLevels()[1].level));
  const auto other = loadLevel(readText("tests/determinism/golden/levels/hexahedron.level")).level;
  EXPECT_FALSE(pages_.medalsOf(other));
  EXPECT_EQ(pages_.entryOf(other).title, other->title);
}

TEST_F(FrontPagesTest, ARaceOnALevelOfTheGameStartsItAndTheOthersFollow) {
  const auto ghost = keepGhost(readText("levels/data/ways/02_over_the_edge.recording"));
  pages_.showRun(ghost);
  EXPECT_TRUE(waitUntil([&] { return shows("Race"); }));
  EXPECT_EQ(pages_.shownLevel()->title, "Over the edge");
  tap(Key::kArrowDown);
  tap(Key::kEnter);
  ASSERT_TRUE(started_);
  EXPECT_EQ(started_->rival, ghost);
  EXPECT_NE(started_->own.levels.front().find("02_over_the_edge"), std::string::npos);
  EXPECT_EQ(started_->own.levels.size(), loadShippedLevels().size());
}

TEST_F(FrontPagesTest, ARaceOnAnotherLevelTakesItFromTheRecording) {
  const std::string text = showRunOnAnotherLevel();
  tap(Key::kArrowDown);
  tap(Key::kEnter);
  ASSERT_TRUE(started_);
  ASSERT_EQ(started_->own.levels.size(), 1U);
  EXPECT_EQ(readText(started_->own.levels[0]), text);
}

// The level was written to the folder in which the program was started.
TEST_F(FrontPagesTest, WithoutAFolderOfTheUserARaceOnAnotherLevelSaysSoAndWritesNothing) {
  showRunOnAnotherLevel();
  const EnvironmentVariable home("HOME", std::nullopt);
  cache_.set(std::nullopt);
  tap(Key::kArrowDown);
  tap(Key::kEnter);
  EXPECT_FALSE(started_);
  EXPECT_TRUE(shows("The race cannot start"));
  EXPECT_TRUE(shows("XDG_CACHE_HOME"));
  EXPECT_FALSE(std::filesystem::exists("raced"));
  const std::string file = folder_ / "file";
  writeText(file, "");
  cache_.set(file);
  tap(Key::kEnter);
  EXPECT_FALSE(started_);
  EXPECT_TRUE(shows("its level cannot be written to"));
}

// Behind the page that said why it had not started, a level was shown that depended on the item with the focus.
TEST_F(FrontPagesTest, TheChosenLevelStaysBehindAPageThatSaysWhyItCannotBePlayed) {
  const auto fail = [this](const MatchChoice&) {
    menu_.open([] {
      MenuPage page{"It cannot be played"};
      page.items = {{.name = "Try again", .choose = [] {}}, {.name = "Back", .choose = [] {}}};
      return page;
    });
  };
  FrontPages pages(menu_, settings_, RecentServers(folder_ / "recent"), {fail, [] {}});
  pages.showTitle();
  tap(Key::kArrowDown);
  tap(Key::kEnter);
  tap(Key::kArrowDown, 3);
  const std::uint64_t chosen = pages.shownLevel()->hash;
  tap(Key::kEnter);
  ASSERT_TRUE(shows("It cannot be played"));
  for (int item = 0; item < 2; ++item, tap(Key::kArrowDown)) EXPECT_EQ(pages.shownLevel()->hash, chosen) << item;
}

// The key of the list is expected, whatever the client remembers for the address.
TEST_F(FrontPagesTest, JoinsAServerOfTheListUnderTheKeyOfTheList) {
  const ServerIdentity identity = ServerIdentity::random();
  const std::string list = serverListText({listedServer(identity, {"127.0.0.1", 1}, "Listed")});
  const WebServer web([&](std::string_view) { return WebServer::ok(list); });
  FrontPages pages(menu_, settings_, RecentServers(folder_ / "recent"),
                   {[this](const MatchChoice& choice) { started_ = choice; }, [] {}}, {.listUrl = web.url()});
  pages.showTitle();
  tap(Key::kArrowDown, 2);
  tap(Key::kEnter);
  type("127.0.0.1:1");
  EXPECT_TRUE(waitUntil([&] {
    menu_.overlay(font_, false);
    pages.update(steadyClock().now());
    tap(Key::kEnter);
    return started_ && started_->key;
  }));
  EXPECT_EQ(started_->key, identity.publicKey());
}

// Before, a list could be named at the command line only.
TEST_F(FrontPagesTest, AListThatIsEnteredIsKeptAndRead) {
  const ServerIdentity identity = ServerIdentity::random();
  const WebServer web([&](std::string_view request) {
    const bool wanted = request.starts_with("GET /list ");
    return WebServer::ok(wanted ? serverListText({listedServer(identity, {"127.0.0.1", 1}, "Listed")}) : "<html>");
  });
  tap(Key::kArrowDown, 2);
  tap(Key::kEnter);
  type("127.0.0.1:1");
  tap(Key::kArrowDown, 2);
  type("ftp://x");
  EXPECT_TRUE(drawUntil([] { return true; }));
  EXPECT_FALSE(shows("must be a URL")) << "it is still being typed";
  tap(Key::kArrowUp);
  EXPECT_TRUE(drawUntil([this] { return shows("must be a URL"); }));
  EXPECT_EQ(settings_.listUrl, "");
  tap(Key::kArrowDown);
  tap(Key::kBackspace, 7);
  type(web.url("/other"));
  tap(Key::kArrowUp);
  EXPECT_TRUE(drawUntil([this] { return shows("cannot read the list"); }));
  tap(Key::kArrowDown);
  tap(Key::kBackspace, 5);
  type("list");
  tap(Key::kArrowUp);
  EXPECT_TRUE(drawUntil([this] {
    tap(Key::kEnter);
    return started_ && started_->key;
  }));
  EXPECT_EQ(started_->key, identity.publicKey());
  EXPECT_EQ(settings_.listUrl, web.url("/list"));
}

// Before, a typing error took the list out of the settings.
TEST_F(FrontPagesTest, AListThatIsRefusedLeavesTheOneBefore) {
  const ServerIdentity identity = ServerIdentity::random();
  const std::string list = serverListText({listedServer(identity, {"127.0.0.1", 1}, "Listed")});
  std::atomic<int> read = 0;
  const WebServer web([&](std::string_view) {
    ++read;
    return WebServer::ok(list);
  });
  settings_.listUrl = web.url();
  tap(Key::kArrowDown, 2);
  tap(Key::kEnter);
  type("127.0.0.1:1");
  tap(Key::kArrowDown, 2);
  tap(Key::kBackspace, static_cast<int>(web.url().size()));
  type("htp://x");
  tap(Key::kArrowUp);
  EXPECT_TRUE(drawUntil([this] {
    tap(Key::kEnter);
    return started_ && started_->key;
  })) << "the servers of the list are still known";
  EXPECT_TRUE(shows("must be a URL"));
  EXPECT_EQ(settings_.listUrl, web.url());
  tap(Key::kArrowDown);
  tap(Key::kBackspace, 7);
  type(web.url());
  tap(Key::kArrowUp);
  EXPECT_TRUE(drawUntil([this] { return !shows("must be a URL"); }));
  EXPECT_EQ(settings_.listUrl, web.url());
  EXPECT_EQ(read, 1) << "the list is the one that was read";
}

// Whoever waited for the reading would wait for ever.
TEST_F(FrontPagesTest, AListThatIsStillReadHoldsUpNoPictureWhenAnotherIsEntered) {
  std::promise<void> open;
  int readings = 0;
  const ThreadStart startHeld = [&, gate = open.get_future().share()](std::function<void()> run) {
    ++readings;
    return startThread([gate, run = std::move(run)] {
      gate.wait();
      run();
    });
  };
  FrontPages pages(menu_, settings_, RecentServers(folder_ / "recent"),
                   {.start = [](const MatchChoice&) {}, .quit = [] {}, .startThread = startHeld});
  const auto enter = [&](const std::string& text) {
    tap(Key::kArrowDown);
    type(text);
    tap(Key::kArrowUp);
    menu_.overlay(font_, false);
    pages.update(steadyClock().now());
  };
  pages.showTitle();
  tap(Key::kArrowDown, 2);
  tap(Key::kEnter);
  tap(Key::kArrowDown);
  enter("http://127.0.0.1:1/");
  EXPECT_EQ(readings, 1);
  enter("x");
  EXPECT_EQ(readings, 2);
  EXPECT_EQ(settings_.listUrl, "http://127.0.0.1:1/x");
  open.set_value();
}

TEST_F(FrontPagesTest, AListThatIsEnteredIsKeptByWhoLeavesThePageAtOnce) {
  tap(Key::kArrowDown, 2);
  tap(Key::kEnter);
  tap(Key::kArrowDown, 2);
  type("http://127.0.0.1:1/");
  menu_.overlay(font_, false);
  tap(Key::kEscape);
  pages_.update(steadyClock().now());
  pages_.update(steadyClock().now());
  EXPECT_EQ(settings_.listUrl, "http://127.0.0.1:1/");
}

TEST_F(FrontPagesTest, AListThatIsGivenGoesBeforeThatOfTheSettings) {
  settings_.listUrl = "http://127.0.0.1:1/";
  const WebServer web([](std::string_view) { return WebServer::ok("<html>"); });
  FrontPages pages(menu_, settings_, RecentServers(folder_ / "recent"), {[](const MatchChoice&) {}, [] {}},
                   {.listUrl = web.url()});
  pages.showTitle();
  tap(Key::kArrowDown, 2);
  tap(Key::kEnter);
  EXPECT_FALSE(shows("List of servers"));
  EXPECT_TRUE(waitUntil([&] {
    menu_.overlay(font_, false);
    pages.update(steadyClock().now());
    return shows("cannot read the list of servers at " + web.url().substr(0, 15));
  }));
  EXPECT_EQ(settings_.listUrl, "http://127.0.0.1:1/");
}

TEST_F(FrontPagesTest, JoinTakesAnAddressAndRefusesWhatIsNone) {
  RecentServers(folder_ / "recent").remember({"before", 1});
  tap(Key::kArrowDown, 2);
  tap(Key::kEnter);
  EXPECT_TRUE(shows("before:1"));
  tap(Key::kEnter, 2);
  EXPECT_TRUE(shows("Enter the address"));
  tap(Key::kArrowUp);
  type("host:x");
  tap(Key::kEnter, 2);
  EXPECT_TRUE(shows("is not a server address"));
  EXPECT_FALSE(started_);
  tap(Key::kArrowUp);
  tap(Key::kBackspace);
  type("12");
  tap(Key::kEnter, 2);
  ASSERT_TRUE(started_ && started_->server);
  EXPECT_EQ(started_->server->text(), "host:12");
  EXPECT_TRUE(started_->password.empty());
}

TEST_F(FrontPagesTest, AskedForAPasswordThePlayerEntersIt) {
  pages_.askPassword({"host", 12}, false);
  EXPECT_TRUE(shows("needs a password"));
  type("secret");
  EXPECT_FALSE(shows("secret"));
  tap(Key::kEnter, 2);
  ASSERT_TRUE(started_);
  EXPECT_EQ(started_->server->text(), "host:12");
  EXPECT_FALSE(started_->password.empty());
  pages_.askPassword({"host", 12}, true);
  EXPECT_TRUE(shows("The password is wrong."));
}

TEST_F(FrontPagesTest, WhoHostsHasAllTheTimeItWantsWhileItIsAlone) {
  tap(Key::kArrowDown, 3);
  tap(Key::kEnter);
  tap(Key::kArrowDown, 5);
  tap(Key::kEnter);
  ASSERT_TRUE(started_);
  EXPECT_TRUE(started_->own.listens);
  EXPECT_TRUE(started_->own.waitsForOne);
}

TEST_F(FrontPagesTest, HostListensAtAPort) {
  tap(Key::kArrowDown, 3);
  tap(Key::kEnter);
  tap(Key::kArrowDown, 3);
  type("7");
  tap(Key::kArrowDown, 2);
  tap(Key::kEnter);
  EXPECT_TRUE(shows("from 1 to 65535"));
  EXPECT_FALSE(started_);
  tap(Key::kArrowUp, 2);
  tap(Key::kBackspace);
  tap(Key::kArrowDown, 2);
  tap(Key::kEnter);
  ASSERT_TRUE(started_);
  EXPECT_TRUE(started_->own.listens);
  EXPECT_EQ(started_->own.port, 7777);
  EXPECT_EQ(started_->own.maxPlayers, 8U);
  EXPECT_FALSE(started_->server);
}

TEST_F(FrontPagesTest, WithoutTheLevelsOfTheGameItSaysWhyAndTriesAgain) {
  bool missing = true;
  FrontPages pages(menu_, settings_, RecentServers(folder_ / "recent"),
                   {.start = [this](const MatchChoice& choice) { started_ = choice; },
                    .quit = [this] { quit_ = true; },
                    .loadLevels =
                        [&] {
                          if (missing) throw ProgramError(ProgramError::kUsage, "cannot find the levels");
                          return loadShippedLevels();
                        }});
  EXPECT_FALSE(pages.showTitle());
  EXPECT_TRUE(shows("cannot find the levels"));
  EXPECT_EQ(pages.shownLevel(), nullptr);
  pages.askPassword({"host", 12}, false);
  pages.showRun(folder_ / "no.recording");
  tap(Key::kEscape);
  tap(Key::kEnter);
  EXPECT_TRUE(shows("cannot find the levels"));
  tap(Key::kArrowDown);
  tap(Key::kEnter);
  EXPECT_TRUE(quit_);
  missing = false;
  tap(Key::kArrowUp);
  tap(Key::kEnter);
  EXPECT_TRUE(shows("Run and jump"));
}

TEST_F(FrontPagesTest, TheLastItemQuitsAndEscapeLeadsBackToTheTitle) {
  tap(Key::kArrowUp);
  tap(Key::kEnter);
  EXPECT_TRUE(quit_);
  tap(Key::kArrowUp);
  tap(Key::kEnter);
  EXPECT_TRUE(shows("Full screen"));
  tap(Key::kEscape, 3);
  EXPECT_TRUE(shows("Quit"));
}

}  // namespace
}  // namespace platon::front_pages_test
