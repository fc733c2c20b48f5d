// A golden picture for each page of the menu, on a plain ground.

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "client/gl/gl_context.h"
#include "client/menu/pages/failure_page.h"
#include "client/menu/pages/levels_page.h"
#include "client/menu/pages/pause_page.h"
#include "client/menu/pages/replays_page.h"
#include "client/menu/pages/several_players_page.h"
#include "client/play/front_pages.h"
#include "client/replay/replay.h"
#include "client/ui/overlay.h"
#include "tests/client/gl/flat_picture.h"
#include "tests/client/gl/golden_picture.h"
#include "tests/support/environment_variable.h"
#include "tests/support/temporary_folder.h"

namespace platon::menu_pictures_test {
namespace {

class MenuPicturesTest : public testing::Test {
 protected:
  // Draws the present page, with the focus on this item.
  void expectPage(const std::string& name, std::size_t focus = 0) {
    if (menu_.layout(font_).rows.size() > focus) menu_.setFocus(focus);
    expectOverlay(menu_.overlay(font_, true), name);
  }
  void expectOverlay(Overlay overlay, const std::string& name) {
    if (settings_.highContrast) raiseContrast(overlay);
    expectGolden(flatPicture(width_, height_, font_, std::span(&overlay, 1)), "menu/" + name);
  }
  void expectPage(const std::string& name, MenuPage page, std::size_t focus = 0) {
    menu_.open([&page] { return page; });
    expectPage(name, focus);
  }
  // As above for a page from which one goes back to another.
  void expectPageAbove(const std::string& name, MenuPage page, std::size_t focus = 0) {
    menu_.open([&page] { return page; });
    menu_.push([&page] { return page; });
    expectPage(name, focus);
  }
  // In a picture of this size.
  void resize(std::uint32_t width, std::uint32_t height) {
    width_ = width;
    height_ = height;
    menu_.resize(Overlay::widthFor(width, height), textScale(settings_.uiScale, height));
  }
  void choose(int item) {
    for (int i = 0; i < item; ++i) menu_.handle({Key::kArrowDown, KeyEvent::Kind::kPress}, font_);
    menu_.handle({Key::kEnter, KeyEvent::Kind::kPress}, font_);
  }
  void showTitle() {
    front_.showTitle();
    resize(960, 540);
  }

  const TemporaryFolder folder_;
  const EnvironmentVariable data_{"XDG_DATA_HOME", folder_.path().string()};
  const Offscreen context_;
  const Font font_;
  Menu menu_;
  Settings settings_;
  std::uint32_t width_ = 960;
  std::uint32_t height_ = 540;
  FrontPages front_{menu_, settings_, RecentServers(folder_ / "recent"), {[](const MatchChoice&) {}, [] {}}};
};

LevelEntry entry(const std::string& title, const std::string& solid, std::uint32_t players = 1) {
  LevelEntry level{title, solid, players};
  level.medals = medalTimesOf(600);
  return level;
}

std::vector<LevelEntry> entries() {
  std::vector<LevelEntry> levels{entry("Run and jump", "Cube · earth"), entry("Over the edge", "Cube · earth"),
                                 entry("A wall becomes a floor", "Cube · earth"),
                                 entry("Half turn", "Tetrahedron · fire"), entry("After you", "Octahedron · air", 2)};
  levels[0].bestTicks = 640;
  levels[1].bestTicks = 1000;
  return levels;
}

TEST_F(MenuPicturesTest, Title) {
  showTitle();
  const auto draw = [&](const std::string& name) {
    Overlay overlay = menu_.overlay(font_, false);
    const float width = Overlay::widthFor(width_, height_);
    addLevelCard(overlay, entries()[0], font_, width, textScale(settings_.uiScale, height_));
    expectOverlay(overlay, name);
  };
  draw("title");
  resize(640, 360);
  draw("title_640x360");
}

TEST_F(MenuPicturesTest, Levels) {
  resize(960, 540);
  const std::vector<LevelEntry> levels = entries();
  MenuPage page = levelsPage(levels, [](std::size_t) {});
  expectPageAbove("levels", page, 2);
}

TEST_F(MenuPicturesTest, SeveralPlayers) {
  resize(960, 540);
  expectPageAbove("several_players", severalPlayersPage(entries()[4], {[] {}, [] {}, [] {}}));
}

TEST_F(MenuPicturesTest, Join) {
  resize(960, 540);
  JoinForm form;
  form.address.setText("play.example.org:7777");
  form.listUrl.setText("https://play.example.org/servers.json");
  form.hasList = true;
  form.recent = {"192.0.2.7:7777", "[2001:db8::7]:7777"};
  form.found = {{"Ann's server", "192.0.2.9:7777", "192.0.2.9:7777, 3 of 8 players, 12 ms"}};
  expectPageAbove("join", joinPage(form, [] {}), 1);
  form.asksPassword = true;
  form.password.setText("secret");
  form.fault = "The password is wrong.";
  expectPageAbove("join_password", joinPage(form, [] {}), 1);
}

TEST_F(MenuPicturesTest, Host) {
  resize(960, 540);
  HostForm form;
  const std::vector<LevelEntry> levels = entries();
  expectPageAbove("host", hostPage(form, levels, [] {}), 2);
}

TEST_F(MenuPicturesTest, Replays) {
  resize(960, 540);
  std::vector<ReplayEntry> runs{{"Run and jump", "10.67 s", "2026-11-23", "", true},
                                {"Run and jump", "12.02 s", "2026-11-22"},
                                {"Over the edge", "16.67 s", "2026-11-20", "Ann"},
                                {"Half turn", "", "2026-10-01", "Ben", false, otherRulesText(1)}};
  runs[0].medal = Medal::kGold;
  runs[1].medal = Medal::kSilver;
  runs[2].medal = Medal::kBronze;
  expectPageAbove("replays",
                  replaysPage(
                      runs, [](std::size_t) {}, [] {}),
                  1);
  expectPageAbove("replays_none", replaysPage(
                                      {}, [](std::size_t) {}, [] {}));
  const RunChoices choices{[] {}, [] {}, [] {}, [] {}};
  expectPageAbove("run", runPage(runs[2], "/data/ann/.local/share/platon/ghosts/Ann.recording", "", choices));
}

TEST_F(MenuPicturesTest, Settings) {
  SettingsPages pages(menu_, settings_);
  resize(960, 540);
  menu_.open([] { return MenuPage{"", {}, false, {{.name = ""}}}; });
  pages.show(MenuPage::Place::kMiddle);
  expectPage("settings", 4);
  menu_.setFocus(34);
  expectOverlay(menu_.overlay(font_, true), "settings_end");
  resize(640, 360);
  menu_.setFocus(9);
  expectOverlay(menu_.overlay(font_, true), "settings_640x360");
  menu_.handle({Key::kArrowRight, KeyEvent::Kind::kPress}, font_);
  resize(960, 540);
  expectOverlay(menu_.overlay(font_, true), "settings_aside");
}

TEST_F(MenuPicturesTest, Keys) {
  resize(960, 540);
  Bindings bindings;
  ControlsForm form;
  expectPageAbove("keys", controlsPage(bindings, form), 3);
  form.waiting = Control::kJump;
  expectPageAbove("keys_waiting", controlsPage(bindings, form), 4);
}

TEST_F(MenuPicturesTest, Pause) {
  resize(960, 540);
  PauseChoices choices;
  choices.title = "Pause";
  choices.restartKey = "R";
  choices.nextKey = "V";
  choices.next = "Next level";
  choices.onResume = choices.onRestart = choices.onNext = choices.onSettings = choices.onLeave = [] {};
  choices.onWatch = [] {};
  expectPage("pause", pausePage(choices));
  settings_.highContrast = true;
  expectPage("pause_high_contrast", pausePage(choices), 1);
  settings_.highContrast = false;
  choices.title = "Platon";
  choices.next = "Vote for the next level";
  choices.notes = {"Others join at 192.0.2.9:7777.", "The game goes on while the menu is open."};
  choices.onWatch = {};
  choices.onSay = [] {};
  choices.sayKey = "T";
  expectPage("pause_with_others", pausePage(choices), 2);
}

TEST_F(MenuPicturesTest, Say) {
  resize(960, 540);
  TextField text(200);
  text.setText("wait for me");
  expectPage("say", sayPage(text, {[] {}, [](std::uint32_t) {}, [] {}, {"Ann: where are you?", "Zoë waves"}}));
}

TEST_F(MenuPicturesTest, Failure) {
  resize(960, 540);
  const std::string reason = "no answer from play.example.org:7777 within 5 s: is platon-server running there?";
  expectPage("failure", failurePage(
                            "The server cannot be joined", reason, [] {}, [] {}));
}

}  // namespace
}  // namespace platon::menu_pictures_test
