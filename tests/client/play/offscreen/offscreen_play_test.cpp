#include "client/play/offscreen/offscreen_play.h"

#include <filesystem>
#include <memory>
#include <string>

#include <gtest/gtest.h>

#include "client/time/steady_now.h"
#include "protocol/program_error.h"
#include "tests/support/files.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/wait_until.h"

namespace platon::offscreen_play_test {
namespace {

class OffscreenReplayTest : public testing::Test {
 protected:
  OffscreenReplayTest() {
    options_.offscreen = true;
    options_.replay = "tests/determinism/golden/hexahedron.recording";
  }

  // Returns as soon as the recording has been read.
  std::unique_ptr<OffscreenReplay> read() const {
    auto replay = std::make_unique<OffscreenReplay>(options_, Settings(), steadyClock().now());
    EXPECT_TRUE(waitUntil([&] { return replay->read(steadyClock().now()); }));
    return replay;
  }

  const TemporaryFolder folder_;
  ClientOptions options_;
};

TEST_F(OffscreenReplayTest, TheMomentOfTheTimeIsDrawn) {
  options_.seconds = 3;
  options_.screenshot = (folder_ / "picture.png").string();
  const auto replay = read();
  replay->draw();
  EXPECT_EQ(replay->viewer().player().tick(), 180U);
  EXPECT_GT(std::filesystem::file_size(options_.screenshot), 10000U);
}

TEST_F(OffscreenReplayTest, WithoutATimeTheEndIsDrawn) {
  const auto replay = read();
  replay->draw();
  EXPECT_EQ(replay->viewer().player().tick(), replay->viewer().player().replay().ticks());
}

TEST_F(OffscreenReplayTest, WhatCannotBePlayedIsRefused) {
  options_.replay = (folder_ / "text").string();
  writeText(options_.replay, "no recording");
  try {
    read();
    ADD_FAILURE() << "accepted";
  } catch (const ProgramError& error) {
    EXPECT_EQ(error.exitCode(), ProgramError::kInvalid);
    EXPECT_EQ(std::string(error.what()),
              options_.replay + ": cannot be played: byte 0: not a recording, or an unsupported version");
  }
}

// Ctrl-C was without effect until all was played.
TEST_F(OffscreenReplayTest, AStopEndsTheReading) {
  const OffscreenReplay replay(options_, Settings(), steadyClock().now());
  EXPECT_EQ(replay.stopped().exitCode(), ProgramError::kFailed);
  EXPECT_EQ(std::string(replay.stopped().what()), options_.replay + ": was not read to its end");
}

}  // namespace
}  // namespace platon::offscreen_play_test
