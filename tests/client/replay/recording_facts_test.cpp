#include "client/replay/recording_facts.h"

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "client/replay/recording_head.h"
#include "client/replay/track_file.h"
#include "platon/game/game.h"
#include "tests/client/replay/followed_game.h"
#include "tests/client/replay/older_rules.h"
#include "tests/shared/game/played_game.h"
#include "tests/shared/game/recorded_game.h"
#include "tests/support/files.h"
#include "tests/support/temporary_folder.h"

namespace platon::recording_facts_test {
namespace {

class RecordingFactsTest : public testing::Test {
 protected:
  RecordingFactsTest() {
    followed_.hold(700, 0);  // more than one block
    followed_.holdToGoal(300, Input::kRight);
  }
  RecordingFacts factsOf(const std::vector<std::uint8_t>& recording) const {
    writeText(file_, {reinterpret_cast<const char*>(recording.data()), recording.size()});
    return readRecordingFacts(file_);
  }

  const TemporaryFolder folder_;
  const std::filesystem::path file_ = folder_ / "file";
  FollowedGame followed_{
      levelOf("# title: Floor\nHEXAHEDRON\n0 0 -180 0\n0 100 -190\n480\n%\n-240 -200 240 -200\n%\n%\n%\n%\n%\n")};
};

TEST_F(RecordingFactsTest, ARunHasItsTime) {
  const RecordingFacts facts = factsOf(followed_.run->recording);
  EXPECT_EQ(facts.note, "");
  EXPECT_EQ(facts.rules, kRulesVersion);
  ASSERT_TRUE(facts.level);
  EXPECT_EQ(facts.level->title, "Floor");
  EXPECT_EQ(facts.ticks, followed_.time);
}

TEST_F(RecordingFactsTest, TheTimesAreThoseOfTheWholePlay) {
  for (const auto& entry : std::filesystem::directory_iterator("levels/data/ways")) {
    if (entry.path().extension() != ".recording") continue;
    const RecordingFacts facts = readRecordingFacts(entry.path());
    const auto track = readTrack(entry.path());
    const auto* const run = std::get_if<RunTrack>(&track);
    EXPECT_EQ(facts.ticks, run == nullptr ? std::nullopt : std::optional(run->ticks)) << entry.path();
    EXPECT_EQ(facts.note, "") << entry.path();
  }
}

TEST_F(RecordingFactsTest, ARoundHasNoTime) {
  const RecordingFacts facts = factsOf(recordGame(100, 60).recording);
  EXPECT_EQ(facts.ticks, std::nullopt);
  EXPECT_EQ(facts.noRun, "is no run: it does not end with a player at the goal");
  EXPECT_EQ(facts.note, "");
}

TEST_F(RecordingFactsTest, SaysWhatCannotBePlayed) {
  EXPECT_EQ(factsOf({1, 2, 3}).note, "is not a recording");
  EXPECT_EQ(readRecordingFacts(folder_ / "missing").note, "cannot be read: No such file or directory");
  const auto older = asOfOlderRules(followed_.run->recording, followed_.game.level());
  const RecordingFacts facts = factsOf(older);
  EXPECT_EQ(facts.note, otherRulesText(kRulesVersion - 1));
  EXPECT_EQ(facts.rules, kRulesVersion - 1);
  ASSERT_TRUE(facts.level);
  EXPECT_EQ(facts.level->title, "Floor");
}

TEST_F(RecordingFactsTest, ACutOffOrDamagedRecordingSaysSo) {
  const auto& whole = followed_.run->recording;
  EXPECT_EQ(factsOf({whole.begin(), whole.begin() + 10}).note.find("is a recording that is cut off: "), 0U);
  EXPECT_EQ(factsOf({whole.begin(), whole.end() - 1}).note.find("is a recording that is cut off: "), 0U);
  auto damaged = whole;
  damaged.back() ^= 1;
  const RecordingFacts facts = factsOf(damaged);
  EXPECT_EQ(facts.note.find("is a damaged recording: "), 0U) << facts.note;
  EXPECT_EQ(facts.ticks, std::nullopt);
}

TEST_F(RecordingFactsTest, StopsWhenItIsAskedTo) {
  factsOf(followed_.run->recording);
  std::stop_source stop;
  stop.request_stop();
  EXPECT_EQ(readRecordingFacts(file_, stop.get_token()).ticks, std::nullopt);
}

}  // namespace
}  // namespace platon::recording_facts_test
