#include "tests/sim/recording_file.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "tests/shared/game/played_game.h"
#include "tests/sim/verify/verification.h"
#include "tests/support/files.h"
#include "tests/support/temporary_folder.h"

namespace platon::sim::recording_file_test {
namespace {

class RecordingFileTest : public testing::Test {
 protected:
  std::string path() const { return folder_ / "recording"; }
  Options options(std::vector<std::string> more = {}) const {
    more.insert(more.begin(), {"--record", path()});
    return Options(more, {"record", "checkpoint-every"}, {});
  }
  // Plays and records `ticks` ticks.
  static void record(RecordingFile& file, int ticks) {
    PlayedGame played(cubeLevel("0 0 -180 0", {"-240 -200 240 -200"}));
    const std::vector<Input> inputs{Input{Input::kPresent | Input::kRight}};
    file.start(played.game);
    for (int tick = 0; tick < ticks; ++tick) {
      played.game.advance(inputs);
      file.tick(inputs, played.game);
    }
    file.finish(played.game);
  }

 private:
  const TemporaryFolder folder_;
};

TEST_F(RecordingFileTest, WritesACompleteRecording) {
  RecordingFile file(options());
  EXPECT_TRUE(file.enabled());
  record(file, 100);
  const auto bytes = platon::readBytes(path());
  const Verification replay = Verifier(bytes).run();
  EXPECT_EQ(replay.ticks, 100u);
  EXPECT_EQ(replay.slots, 1u);
  EXPECT_EQ(replay.fault, "");
  EXPECT_FALSE(replay.divergence);
}

TEST_F(RecordingFileTest, WritesCheckpointsAsOftenAsAskedFor) {
  for (const std::uint32_t every : {1u, 7u, 100u}) {
    RecordingFile file(options({"--checkpoint-every", std::to_string(every)}));
    record(file, 100);
    const auto bytes = platon::readBytes(path());
    const auto block = RecordingReader(bytes).next();
    ASSERT_TRUE(block);
    EXPECT_EQ(block->ticks(), every);
  }
}

TEST_F(RecordingFileTest, DoesNothingWithoutTheOption) {
  RecordingFile file(Options({}, {"record", "checkpoint-every"}, {}));
  EXPECT_FALSE(file.enabled());
  record(file, 3);
  EXPECT_FALSE(std::filesystem::exists(path()));
}

TEST_F(RecordingFileTest, RefusesInvalidOptions) {
  EXPECT_THROW(RecordingFile(Options({"--record="}, {"record", "checkpoint-every"}, {})), UsageError);
  EXPECT_THROW(RecordingFile(options({"--checkpoint-every", "0"})), UsageError);
  EXPECT_THROW(RecordingFile(options({"--checkpoint-every", "3601"})), UsageError);
}

}  // namespace
}  // namespace platon::sim::recording_file_test
