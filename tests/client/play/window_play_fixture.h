#pragma once

#include <cmath>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "client/play/game_desk.h"
#include "client/play/match_screen.h"
#include "client/play/replay_screen.h"
#include "client/play/screen.h"
#include "client/play/title_screen.h"
#include "client/time/steady_now.h"
#include "tests/client/gl/desktop.h"
#include "tests/client/gl/fake_gamepad.h"
#include "tests/client/play/window_steps.h"
#include "tests/support/environment_variable.h"
#include "tests/support/files.h"
#include "tests/support/temporary_folder.h"

namespace platon {

inline constexpr const char* kRecording = "tests/determinism/golden/hexahedron.recording";

/// Plays in a real window on a virtual display with a window manager (on_display.sh), with the files of the user in a
/// folder of its own.
class WindowPlayTest : public testing::Test {
 protected:
  WindowPlayTest() {
    options_.level = "tests/determinism/golden/levels/hexahedron.level";
    options_.seconds = kLimit;  // a test that does not end by itself fails
  }
  ~WindowPlayTest() override { fakeGamepad.reset(); }

  // Plays until the player leaves or all steps are done.
  void play(std::vector<WindowStep> steps) {
    const Time start = steadyClock().now();  // before the time limit of the options begins
    DesktopWindow window = openWindow("");
    GameDesk desk(options_, steadyClock(), window);
    ScreenStack screens(std::make_unique<TitleScreen>(desk));
    desk_ = &desk;
    screens_ = &screens;
    const double limit = options_.seconds.value_or(kLimit);
    stepsDone_ = runSteps(screens, window, limit, std::move(steps));
    timeIsUp_ = toSeconds(steadyClock().now() - start) >= limit;
    if (desk.named.failure) throw ProgramError(*desk.named.failure);
  }

  std::string savedSettings() const { return readText(folder_ / "platon/settings"); }

  // Clicks on an item of the menu, which is in a window of 1280 × 720.
  void click(std::size_t item) const {
    for (const MenuRow& row : menu().layout(font_).rows) {
      if (row.item == item) clickOn(row.box);
    }
  }
  // Clicks on the middle of a box of the menu.
  static void clickOn(const MenuBox& box) {
    const glm::vec2 middle = (box.low + box.high) / 2.0F;
    xdotool("mousemove --window $(xdotool getactivewindow) " + std::to_string(std::lround(middle.x)) + " " +
            std::to_string(std::lround(middle.y)) + " click 1");
  }
  // Clicks on the item with this name.
  void clickOn(const std::string& name) const {
    for (const MenuRow& row : menu().layout(font_).rows) {
      if (row.name.text == name) return click(row.item);
    }
  }
  bool shows(const std::string& name) const {
    if (!menu().isOpen()) return false;
    for (const MenuRow& row : menu().layout(font_).rows) {
      if (row.name.text == name) return true;
    }
    return false;
  }
  // Whether the menu shows a paragraph that begins with this text.
  bool notes(const std::string& start) const {
    if (!menu().isOpen()) return false;
    for (const MenuLine& note : menu().layout(font_).notes) {
      if (note.text.starts_with(start)) return true;
    }
    return false;
  }
  // Whether the own ball stands on something. Nothing before the first round.
  std::optional<bool> isOnGround() const {
    const Session* const session = match() ? match()->client().session() : nullptr;
    if (session == nullptr || session->round() == nullptr) return std::nullopt;
    const Prediction& prediction = session->round()->prediction();
    const Game& game = prediction.predicted();
    if (prediction.slot() >= game.slots()) return std::nullopt;
    return game.player(prediction.slot()).ground != Point();
  }
  // Ticks of the round that the server has confirmed; 0 before the first round.
  std::uint32_t confirmedTicks() const {
    const Session* const session = match() ? match()->client().session() : nullptr;
    return session && session->round() ? session->round()->prediction().confirmedTicks() : 0;
  }
  // Puts a recording where those of friends are.
  void keepRecording(const std::string& name, const char* recording = kRecording) const {
    std::filesystem::create_directories(folder_ / "platon/ghosts");
    writeText(folder_ / "platon/ghosts" / name, readText(recording));
  }
  // From the title to the replay of a recording that was kept, and from there to a game.
  std::vector<WindowStep> toReplay() const {
    return {{[] { xdotool("key Down Down Down Down Return"); }, [this] { return shows("Hexahedron"); }},
            {[] { xdotool("key Return"); }, [this] { return shows("Watch"); }},
            {[] { xdotool("key Return"); }, [this] { return viewer() != nullptr; }}};
  }
  std::vector<WindowStep> fromReplayToGame() const {
    return {{[] { xdotool("key Escape"); }, [this] { return shows("Watch"); }},
            {[] { xdotool("key Escape"); }, [this] { return shows("Hexahedron"); }},
            {[] { xdotool("key Escape"); }, [this] { return shows("Quit"); }},
            {[this] { clickOn("Play"); }, [this] { return isOnGround() == std::optional(true); }}};
  }
  const Menu& menu() const { return desk_->menu; }
  // The present match; null if there is none.
  const LiveMatch* match() const {
    const auto* const screen = screens_->find<MatchScreen>();
    return screen == nullptr ? nullptr : &screen->match();
  }
  // The recording that is shown; null if there is none.
  const ReplayScreen* replay() const { return screens_->find<ReplayScreen>(); }
  const ReplayViewer* viewer() const { return replay() == nullptr ? nullptr : replay()->viewer(); }
  const ReplayPlayer& player() const { return viewer()->player(); }
  bool inGame() const { return match() != nullptr && !menu().isOpen(); }

  static constexpr double kLimit = 300;  // s
  const Font font_{};
  ClientOptions options_;
  const GameDesk* desk_ = nullptr;
  const ScreenStack* screens_ = nullptr;
  const TemporaryFolder folder_;
  const EnvironmentVariable config_{"XDG_CONFIG_HOME", folder_.path()};
  const EnvironmentVariable data_{"XDG_DATA_HOME", folder_.path()};
  const EnvironmentVariable cache_{"XDG_CACHE_HOME", folder_ / "cache"};
  const EnvironmentVariable state_{"XDG_STATE_HOME", folder_.path()};
  const EnvironmentVariable pictures_{"XDG_PICTURES_DIR", folder_.path()};
  testing::AssertionResult stepsDone_ = testing::AssertionFailure();
  bool timeIsUp_ = false;
};

}  // namespace platon
