#include "client/play/play_window.h"

#include <algorithm>
#include <chrono>
#include <optional>
#include <string>

#include <gtest/gtest.h>

#include "protocol/program_error.h"
#include "tests/support/environment_variable.h"

// Runs on a virtual display with a window manager (on_display.sh).
namespace platon::play_window_test {
namespace {

TEST(PlayWindow, AFrameTakesAsLongAsTheCapSaysAndLongerInACalmWindow) {
  using std::chrono::microseconds;
  EXPECT_EQ(frameTimeOf(false, 0), kMinFrameTime) << "no cap";
  EXPECT_EQ(frameTimeOf(false, 0.5), kMinFrameTime);
  EXPECT_EQ(frameTimeOf(false, 50), microseconds(20'000));
  EXPECT_EQ(frameTimeOf(false, 1), microseconds(1'000'000));
  EXPECT_EQ(frameTimeOf(false, 1000), kMinFrameTime) << "a cap above what a driver may draw";
  EXPECT_EQ(frameTimeOf(true, 0), microseconds(33'333));
  EXPECT_EQ(frameTimeOf(true, 1000), microseconds(33'333));
}

// The window manager may take room for a frame.
TEST(PlayWindow, IsAtMostOfTheSizeOfThePicture) {
  const Window window = openWindow("");
  EXPECT_GT(window.pixelWidth(), kPictureWidth / 2);
  EXPECT_LE(window.pixelWidth(), kPictureWidth);
  EXPECT_LE(window.pixelHeight(), kPictureHeight);
}

// The name of the game and the message are brighter than the sky behind them.
TEST(PlayWindow, SaysThatItLoads) {
  Window window = openWindow("");
  GameView view(window.pixelWidth(), window.pixelHeight());
  showLoading(window, view);
  const Image picture = view.read();
  EXPECT_GT(*std::max_element(picture.pixels.begin(), picture.pixels.end()), 240);
}

TEST(PlayWindow, WithoutADisplayItSaysWhatCanBeDone) {
  const EnvironmentVariable noDisplay("DISPLAY", std::nullopt);
  try {
    openWindow("use --offscreen");
    FAIL() << "opened";
  } catch (const ProgramError& error) {
    EXPECT_EQ(error.exitCode(), ProgramError::kUsage);
    const std::string text = error.what();
    EXPECT_EQ(text.substr(0, 22), "cannot open a window: ");
    EXPECT_TRUE(text.ends_with("; use --offscreen")) << text;
  }
}

}  // namespace
}  // namespace platon::play_window_test
