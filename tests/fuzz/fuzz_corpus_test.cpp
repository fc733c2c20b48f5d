#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <vector>

#include "tests/fuzz/fuzz_targets.h"
#include "tests/support/files.h"

namespace platon::fuzz {
namespace {

struct Target {
  const char* name;
  std::string (*fault)(Bytes);
};

class FuzzCorpusTest : public testing::TestWithParam<Target> {};

/// The committed inputs reached new code in the fuzzers, or once found a fault.
TEST_P(FuzzCorpusTest, EveryCommittedInputPasses) {
  const std::vector<std::string> files = filesIn(std::string("tests/fuzz/corpus/") + GetParam().name, "");
  ASSERT_GE(files.size(), 10u);
  for (const std::string& file : files) EXPECT_EQ(GetParam().fault(readBytes(file)), "") << file;
}

TEST_P(FuzzCorpusTest, EmptyAndConstantInputsPass) {
  EXPECT_EQ(GetParam().fault({}), "");
  for (int value = 0; value < 256; ++value) {
    const std::vector<std::uint8_t> bytes(64, static_cast<std::uint8_t>(value));
    EXPECT_EQ(GetParam().fault(bytes), "") << value;
  }
}

INSTANTIATE_TEST_SUITE_P(Targets, FuzzCorpusTest,
                         testing::Values(Target{"sweep", &sweepFault}, Target{"scene", &sceneFault},
                                         Target{"level", &levelFault}, Target{"game_state", &gameStateFault},
                                         Target{"recording", &recordingFault}, Target{"protocol", &protocolFault},
                                         Target{"handshake", &handshakeFault}, Target{"channel", &channelFault},
                                         Target{"console", &consoleFault}, Target{"config", &configFault},
                                         Target{"ban_list", &banListFault}, Target{"best_times", &bestTimesFault},
                                         Target{"server_list", &serverListFault}, Target{"settings", &settingsFault}),
                         [](const auto& described) { return std::string(described.param.name); });

}  // namespace
}  // namespace platon::fuzz
