#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "tests/fuzz/fuzz_targets.h"

namespace platon::fuzz {
namespace {

namespace fs = std::filesystem;

struct Target {
  const char* name;
  std::string (*fault)(Bytes);
};

std::vector<std::uint8_t> contentOf(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

class FuzzCorpusTest : public testing::TestWithParam<Target> {};

/// Every committed input: those by which the fuzzers reached something new, and those that once broke something.
TEST_P(FuzzCorpusTest, HoldsForEveryCommittedInput) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(fs::path("tests/fuzz/corpus") / GetParam().name)) {
    files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  ASSERT_GE(files.size(), 10u);
  for (const fs::path& file : files) EXPECT_EQ(GetParam().fault(contentOf(file)), "") << file;
}

/// What a byte-wise fuzzer begins with.
TEST_P(FuzzCorpusTest, HoldsForNoBytesAndForEqualBytes) {
  EXPECT_EQ(GetParam().fault({}), "");
  for (int value = 0; value < 256; ++value) {
    const std::vector<std::uint8_t> bytes(64, static_cast<std::uint8_t>(value));
    EXPECT_EQ(GetParam().fault(bytes), "") << value;
  }
}

INSTANTIATE_TEST_SUITE_P(Targets, FuzzCorpusTest,
                         testing::Values(Target{"sweep", &sweepFault}, Target{"scene", &sceneFault},
                                         Target{"level", &levelFault}, Target{"game_state", &gameStateFault},
                                         Target{"recording", &recordingFault}, Target{"protocol", &protocolFault}),
                         [](const auto& described) { return std::string(described.param.name); });

}  // namespace
}  // namespace platon::fuzz
