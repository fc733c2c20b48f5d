#include "client/replay/recording_fault.h"

#include <cstddef>
#include <vector>

#include <gtest/gtest.h>

#include "tests/shared/game/recorded_game.h"

namespace platon::recording_fault_test {
namespace {

std::string faultOf(const std::vector<std::uint8_t>& recording) {
  RecordingReader reader(recording);
  while (reader.next()) {
  }
  return recordingFault(reader, recording);
}

TEST(RecordingFault, TellsWhatIsCutOffFromWhatIsDamaged) {
  const std::vector<std::uint8_t> whole = recordGame(100, 60).recording;
  EXPECT_EQ(faultOf(whole), "");
  EXPECT_EQ(faultOf({whole.begin(), whole.end() - 1}).find("is a recording that is cut off: byte "), 0U);
  auto damaged = whole;
  damaged.back() ^= 1;
  EXPECT_EQ(faultOf(damaged).find(damagedText("byte ")), 0U);
  EXPECT_EQ(faultOf({1, 2, 3}), "cannot be played: byte 0: not a recording, or an unsupported version");
}

}  // namespace
}  // namespace platon::recording_fault_test
