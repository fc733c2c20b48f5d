#include "client/play/replay_play.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include <GLFW/glfw3.h>

#include "client/time/steady_now.h"
#include "protocol/program_error.h"
#include "tests/client/gl/desktop.h"
#include "tests/client/play/window_steps.h"
#include "tests/support/files.h"
#include "tests/support/temporary_folder.h"

// Runs on a virtual display with a window manager (on_display.sh).
namespace platon {
namespace {

class ReplayPlayTest : public testing::Test {
 protected:
  ReplayPlayTest() {
    options_.replay = "tests/determinism/golden/hexahedron.recording";
    options_.seconds = 60;  // a test that does not end by itself fails
  }

  // Watches until the user leaves or all steps are done. Returns whether all steps were done.
  bool watch(std::vector<WindowStep> steps) {
    ReplayPlay play(options_, Settings(), steadyClock());
    play_ = &play;
    const Moment start = steadyClock().now();
    const bool allDone = runSteps(play, std::move(steps));
    timeIsUp_ = toSeconds(steadyClock().now() - start) >= *options_.seconds;
    return allDone;
  }

  const ReplayPlayer& player() const { return play_->viewer().player(); }

  const TemporaryFolder folder_;
  ClientOptions options_;
  const ReplayPlay* play_ = nullptr;
  bool timeIsUp_ = false;
};

TEST_F(ReplayPlayTest, PlaysPausesStepsAndIsClicked) {
  std::uint32_t at = 0;
  EXPECT_TRUE(watch({{[] {}, [&] { return player().tick() > 10; }},
                     {[] { xdotool("key space"); }, [&] { return player().paused(); }},
                     {[&] {
                        at = player().tick();
                        xdotool("key Right");
                      },
                      [&] { return player().tick() == at + 1; }},
                     {[&] { xdotool("key shift+Right"); }, [&] { return player().tick() == at + 301; }},
                     {[] { xdotool("mousemove --window $(xdotool getactivewindow) 640 666 click 1"); },
                      [&] { return std::abs(player().tick() - player().replay().ticks() / 2.0) < 10; }},
                     {[] { xdotool("key Tab"); }, [&] { return player().followed() != 0; }},
                     {[] { xdotool("key plus plus"); }, [&] { return player().speed() == 4; }}}));
}

TEST_F(ReplayPlayTest, EscapeLeaves) {
  watch({{[] { xdotool("key Escape"); }, [] { return false; }}});
  EXPECT_FALSE(timeIsUp_);
}

TEST_F(ReplayPlayTest, OffscreenTheMomentOfTheTimeLimitIsDrawn) {
  options_.offscreen = true;
  options_.seconds = 3;
  options_.screenshot = (folder_ / "picture.png").string();
  ReplayPlay play(options_, Settings(), steadyClock());
  play.run([] { return false; });
  EXPECT_EQ(play.viewer().player().tick(), 180U);
  EXPECT_GT(std::filesystem::file_size(options_.screenshot), 10000U);
}

TEST_F(ReplayPlayTest, WhatCannotBePlayedIsRefused) {
  options_.replay = (folder_ / "text").string();
  writeText(options_.replay, "no recording");
  try {
    const ReplayPlay play(options_, Settings(), steadyClock());
    ADD_FAILURE() << "accepted";
  } catch (const ProgramError& error) {
    EXPECT_EQ(error.exitCode(), ProgramError::kLevel);
    EXPECT_EQ(std::string(error.what()),
              options_.replay + ": cannot be played: byte 0: not a recording, or an unsupported version");
  }
}

}  // namespace
}  // namespace platon
