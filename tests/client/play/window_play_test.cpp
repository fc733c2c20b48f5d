#include "client/play/window_play.h"

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include <GLFW/glfw3.h>
#include <gtest/gtest.h>

#include "client/play/embedded_server.h"
#include "client/time/steady_now.h"
#include "tests/client/gl/desktop.h"
#include "tests/client/gl/fake_gamepad.h"
#include "tests/client/play/window_steps.h"
#include "tests/support/environment_variable.h"
#include "tests/support/files.h"
#include "tests/support/temporary_folder.h"

// Runs on a virtual display with a window manager (on_display.sh).
namespace platon {
namespace {

constexpr int kFullscreenItem = 6;  // below Resume

std::string keys(const std::string& key, int times) {
  std::string command = "key";
  for (int i = 0; i < times; ++i) command += " " + key;
  return command;
}

class WindowPlayTest : public testing::Test {
 protected:
  WindowPlayTest() {
    options_.level = "tests/determinism/golden/levels/hexahedron.level";
    options_.seconds = 60;  // a test that does not end by itself fails
  }
  ~WindowPlayTest() override { fakeGamepad.reset(); }

  // Plays until the player leaves or all steps are done.
  void play(std::vector<WindowStep> steps) {
    const EmbeddedServer server(options_.level);
    WindowPlay play(options_, server.address(), steadyClock());
    const Moment start = steadyClock().now();
    stepsDone_ = runSteps(play, std::move(steps));
    timeIsUp_ = toSeconds(steadyClock().now() - start) >= *options_.seconds;
  }

  static bool isFullscreen() {
    int width = 0;
    int height = 0;
    glfwGetWindowSize(glfwGetCurrentContext(), &width, &height);
    return glfwGetWindowMonitor(glfwGetCurrentContext()) != nullptr && width == 1280 && height == 1024;
  }

  std::string savedSettings() const { return readText(folder_ / "platon/settings"); }

  ClientOptions options_;
  const TemporaryFolder folder_;
  const EnvironmentVariable config_{"XDG_CONFIG_HOME", folder_.path()};
  const EnvironmentVariable data_{"XDG_DATA_HOME", folder_.path()};
  bool stepsDone_ = false;
  bool timeIsUp_ = false;
};

TEST_F(WindowPlayTest, TheRightArrowInTheMenuTurnsFullScreenOn) {
  play({{[] { xdotool("key Escape " + keys("Down", kFullscreenItem).substr(4) + " Right"); }, isFullscreen},
        {[] { xdotool("key Left"); }, [] { return !isFullscreen(); }},
        {[] { xdotool("key Right"); }, isFullscreen}});
  EXPECT_TRUE(stepsDone_);
  Settings expected;
  expected.fullscreen = true;
  EXPECT_EQ(savedSettings(), expected.text());
}

TEST_F(WindowPlayTest, AKeyTurnsFullScreenOnAndOff) {
  play({{[] { xdotool("key F11"); }, isFullscreen},
        {[] { xdotool("key alt+Return"); }, [] { return !isFullscreen(); }}});
  EXPECT_TRUE(stepsDone_);
  EXPECT_EQ(savedSettings(), Settings().text());
}

TEST_F(WindowPlayTest, StartsInFullScreenIfTheSettingsSaySo) {
  std::filesystem::create_directories(folder_ / "platon");
  writeText(folder_ / "platon/settings", "fullscreen on\n");
  play({{[] {}, isFullscreen}});
  EXPECT_TRUE(stepsDone_);
}

TEST_F(WindowPlayTest, TheMenuLeavesTheGame) {
  play({{[] { xdotool("key Escape Up Return"); }, [] { return false; }}});
  EXPECT_FALSE(timeIsUp_);
  EXPECT_EQ(savedSettings(), Settings().text());
}

TEST_F(WindowPlayTest, AGamepadMovesThroughTheMenu) {
  const auto push = [](int button) { fakeGamepad.emplace().buttons[button] = GLFW_PRESS; };
  // Each state of the gamepad lasts one frame.
  std::vector<WindowStep> steps;
  const auto tap = [&](int button) {
    steps.push_back({[=] { push(button); }, [] { return true; }});
    steps.push_back({[] { fakeGamepad.emplace(); }, [] { return true; }});
  };
  tap(GLFW_GAMEPAD_BUTTON_START);
  for (int i = 0; i < kFullscreenItem; ++i) tap(GLFW_GAMEPAD_BUTTON_DPAD_DOWN);
  tap(GLFW_GAMEPAD_BUTTON_A);
  steps.push_back({[] {}, isFullscreen});
  play(std::move(steps));
  EXPECT_TRUE(stepsDone_);
}

TEST_F(WindowPlayTest, ClosingTheWindowLeavesTheGame) {
  play({{[] { xdotool("key alt+F4"); }, [] { return false; }}});
  EXPECT_FALSE(timeIsUp_);
}

}  // namespace
}  // namespace platon
