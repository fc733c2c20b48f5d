#include "client/replay/track_file.h"

#include <string>
#include <utility>

#include <gtest/gtest.h>

#include "client/replay/recording_facts.h"
#include "platon/game/recorder.h"
#include "platon/game/recording_format.h"
#include "tests/client/replay/followed_game.h"
#include "tests/shared/game/forged_recording.h"
#include "tests/shared/game/played_game.h"
#include "tests/support/files.h"
#include "tests/support/temporary_folder.h"

namespace platon::track_file_test {
namespace {

class TrackFileTest : public testing::Test {
 protected:
  TrackFileTest() {
    followed_.hold(30, 0);
    followed_.holdToGoal(300, Input::kRight);
  }
  void write(const std::vector<std::uint8_t>& bytes) {
    writeText(file_, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
  }
  std::string fault(const Level* level = nullptr) const {
    const auto track = readTrack(file_, level);
    const auto* const text = std::get_if<std::string>(&track);
    return text == nullptr ? "" : text->substr(file_.string().size());
  }

  const TemporaryFolder folder_;
  const std::filesystem::path file_ = folder_ / "run";
  FollowedGame followed_{cubeLevel("0 0 -180 0", {"-240 -200 240 -200"}, "0 100 -190")};
};

TEST_F(TrackFileTest, ReadsARunOfItsLevel) {
  write(followed_.run->recording);
  const auto track = readTrack(file_, &followed_.game.level());
  ASSERT_TRUE(std::holds_alternative<RunTrack>(track));
  EXPECT_EQ(std::get<RunTrack>(track).ticks, *followed_.time);
  EXPECT_EQ(fault(), "");
}

TEST_F(TrackFileTest, SaysWhyAFileIsNoRun) {
  EXPECT_EQ(fault().substr(0, 17), ": cannot be read:");
  write(followed_.run->recording);
  Level forged = followed_.game.level();  // with the same hash
  forged.text += "# another";
  EXPECT_EQ(fault(&forged), ": is a recording of another level");
  Recorder recorder{Game(followed_.game.sharedLevel())};
  recorder.finish(Game(followed_.game.sharedLevel()));
  write(recorder.takeBytes());
  EXPECT_EQ(fault(), ": is no run: it does not end with a player at the goal");
}

// Such a file verifies, and has a time of a few ticks.
TEST_F(TrackFileTest, ARecordingThatBeginsBesideTheGoalIsNoRun) {
  write(forgedRun(followed_.game.sharedLevel(), units(60)));
  EXPECT_EQ(fault(), ": is no run: its player does not begin at the start of the level, at rest");
  const RecordingFacts facts = readRecordingFacts(file_);
  EXPECT_EQ(facts.note, "") << "it can be watched";
  EXPECT_EQ(facts.ticks, std::nullopt);
  EXPECT_EQ(": " + facts.noRun, fault());
}

TEST_F(TrackFileTest, ARunThatIsLongerThanAnyWhichTheGameKeepsIsRefused) {
  for (const auto& [wait, allowed] :
       {std::pair(RunCutter::kMaxTicks - 200, true), std::pair(RunCutter::kMaxTicks, false)}) {
    PlayedGame played(followed_.game.sharedLevel());
    Recorder recorder(played.game, kMaxCheckpointTicks);
    const auto hold = [&](std::uint8_t buttons) {
      const Input input{static_cast<std::uint8_t>(buttons | Input::kPresent)};
      played.run(1, buttons);
      recorder.record({&input, 1}, played.game);
    };
    hold(Input::kJump);
    for (std::size_t tick = 0; tick < wait; ++tick) hold(0);
    for (int tick = 0; tick < 199 && played.player().arrived == 0; ++tick) hold(Input::kRight);
    ASSERT_EQ(played.player().arrived, 1);
    recorder.finish(played.game);
    write(recorder.takeBytes());
    EXPECT_EQ(fault(), allowed ? "" : ": is a run of more than 30 minutes, too long for a ghost");
  }
}

}  // namespace
}  // namespace platon::track_file_test
