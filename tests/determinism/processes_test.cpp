// Processes record the same bytes whatever differs between them: addresses, environment, working directory.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "platon/game/game.h"
#include "platon/game/recorder.h"
#include "tests/determinism/lockstep_levels.h"
#include "tests/sim/churn.h"
#include "tests/support/files.h"
#include "tests/support/process.h"
#include "tests/support/temporary_folder.h"

namespace platon::sim::processes_test {
namespace {

constexpr std::uint64_t kSeed = 5;
constexpr std::uint32_t kPlayers = 6;
constexpr int kTicks = 400;

using Bytes = std::vector<std::uint8_t>;

ProcessOptions inFolder(const std::string& folder) {
  ProcessOptions options;
  options.folder = folder;
  return options;
}

class ProcessesTest : public testing::TestWithParam<std::string> {
 protected:
  // Records in another process, which is started by the program and the arguments in `wrapper`.
  Bytes recordedBy(const std::string& wrapper, const ProcessOptions& options = {}) const {
    const TemporaryFolder folder;
    const std::string file = folder / "recording";
    std::vector<std::string> command = wordsOf(wrapper);
    const std::vector<std::string> program =
        platonCommand("platon-sim", {"run", std::filesystem::absolute(GetParam()), "--drive", "churn", "--players",
                                     std::to_string(kPlayers), "--ticks", std::to_string(kTicks), "--seed",
                                     std::to_string(kSeed), "--record", file});
    command.insert(command.end(), program.begin(), program.end());
    const ProcessResult result = runProcess(command, options);
    EXPECT_EQ(result.exitCode, 0) << wrapper << ": " << result.errors;
    return readBytes(file);
  }
  // Records in this process.
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
  EXPECT_EQ(recordedBy("env", inFolder("/")), here);
  EXPECT_EQ(recordedBy("env MALLOC_PERTURB_=165"), here) << "memory is read before it is written";
  EXPECT_EQ(recordedBy("env -i LC_ALL=tr_TR.UTF-8 TZ=Asia/Kathmandu"), here);
  EXPECT_EQ(recordedBy("setarch -R"), here) << "addresses change the result";
}

INSTANTIATE_TEST_SUITE_P(All, ProcessesTest, testing::ValuesIn(lockstepLevels()),
                         [](const auto& file) { return testName(file.param); });

}  // namespace
}  // namespace platon::sim::processes_test
