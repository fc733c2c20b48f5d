#include "client/replay/recording_head.h"

#include <gtest/gtest.h>

#include "tests/client/replay/older_rules.h"
#include "tests/shared/game/recorded_game.h"

namespace platon::recording_head_test {
namespace {

TEST(RecordingHead, IsReadFromTheFirstBytes) {
  const std::vector<std::uint8_t> recording = recordGame(100, 60).recording;
  const std::size_t bytes = Recorder(Game(recordedLevel())).takeBytes().size();
  const auto head = readRecordingHead(std::span(recording).first(bytes));
  ASSERT_TRUE(head && head->level);
  EXPECT_EQ(head->rules, kRulesVersion);
  EXPECT_EQ(head->level->hash, recordedLevel()->hash);
  EXPECT_FALSE(readRecordingHead(std::span(recording).first(bytes - 1)));
  EXPECT_FALSE(readRecordingHead({}));
}

TEST(RecordingHead, OfOlderRulesIsReadToo) {
  const auto older = asOfOlderRules(recordGame(10, 60).recording, *recordedLevel());
  const auto head = readRecordingHead(older);
  ASSERT_TRUE(head && head->level);
  EXPECT_EQ(head->rules, kRulesVersion - 1);
  EXPECT_EQ(head->level->hash, recordedLevel()->hash);
}

TEST(RecordingHead, ADamagedOneIsNoneWhateverItsRules) {
  const std::vector<std::uint8_t> recording = recordGame(10, 60).recording;
  const auto older = asOfOlderRules(recording, *recordedLevel());
  for (std::vector<std::uint8_t> bytes : {recording, older}) {
    for (const std::size_t place : {0U, 8U, 12U, 16U, 40U}) {
      bytes[place] ^= 4;
      EXPECT_FALSE(readRecordingHead(bytes)) << place;
      bytes[place] ^= 4;
    }
  }
}

TEST(RecordingHead, TheTextNamesBothVersions) {
  const std::string text = otherRulesText(3);
  EXPECT_NE(text.find("version 3 of the rules"), std::string::npos);
  EXPECT_NE(text.find("version " + std::to_string(kRulesVersion)), std::string::npos);
  EXPECT_NE(text.find("kept"), std::string::npos);
}

}  // namespace
}  // namespace platon::recording_head_test
