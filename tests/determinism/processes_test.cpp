// Processes against each other: what differs between them (addresses, environment, where they stand) must not show.
#include <gtest/gtest.h>

#include <cstdlib>

#include "platon/game/game.h"
#include "platon/game/recorder.h"
#include "tests/determinism/lockstep_levels.h"
#include "tests/sim/churn.h"
#include "tests/sim/files.h"

namespace platon::sim {
namespace {

constexpr std::uint64_t kSeed = 5;
constexpr std::uint32_t kPlayers = 6;
constexpr int kTicks = 400;
constexpr std::size_t kMaxBytes = std::size_t{1} << 24;

using Bytes = std::vector<std::uint8_t>;

std::string simPath() {
  const char* folder = std::getenv("PLATON_BIN");
  return std::filesystem::absolute(folder != nullptr ? folder : ".") / "platon-sim";
}

class ProcessesTest : public testing::TestWithParam<std::string> {
 protected:
  // By a process of its own; `environment` stands before the program's name.
  Bytes recordedBy(const std::string& environment) const {
    const std::string file = testing::TempDir() + "platon_processes_" + testName(GetParam());
    const std::string command = environment + " " + simPath() + " run " +
                                std::filesystem::absolute(GetParam()).string() + " --drive churn --players " +
                                std::to_string(kPlayers) + " --ticks " + std::to_string(kTicks) + " --seed " +
                                std::to_string(kSeed) + " --record " + file + " >/dev/null 2>&1";
    EXPECT_EQ(std::system(command.c_str()), 0) << command;
    const Bytes bytes = readBytes(file, kMaxBytes);
    std::remove(file.c_str());
    return bytes;
  }
  // By this process.
  Bytes recordedHere() const {
    Game game(levelFrom(GetParam()));
    Recorder recorder(game);
    Churn churn(kSeed, kPlayers);
    for (int tick = 0; tick < kTicks; ++tick) {
      const auto& inputs = churn.next();
      game.advance(inputs);
      recorder.record(inputs, game);
    }
    recorder.finish(game);
    return recorder.takeBytes();
  }
};

TEST_P(ProcessesTest, RecordTheSameBytes) {
  const Bytes here = recordedHere();
  EXPECT_EQ(recordedBy("cd / && exec env"), here);
  EXPECT_EQ(recordedBy("exec env MALLOC_PERTURB_=165"), here) << "memory that is used must have been written";
  EXPECT_EQ(recordedBy("exec env -i LC_ALL=tr_TR.UTF-8 TZ=Asia/Kathmandu"), here);
  EXPECT_EQ(recordedBy("exec setarch -R"), here) << "addresses must not show";
}

INSTANTIATE_TEST_SUITE_P(All, ProcessesTest, testing::ValuesIn(lockstepLevels()),
                         [](const auto& file) { return testName(file.param); });

}  // namespace
}  // namespace platon::sim
