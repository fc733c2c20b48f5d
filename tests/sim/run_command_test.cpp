#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <string>
#include <vector>

#include "tests/sim/command_testing.h"
#include "tests/sim/sim_options.h"

namespace platon::sim::run_command_test {
namespace {

using testing::HasSubstr;
using testing::MatchesRegex;
using testing::StartsWith;

TEST(RunCommandTest, PrintsOneJsonObject) {
  const std::string level = levelFile();
  const std::string json = outputOf(runCommand, {level, "--players", "3", "--ticks", "200", "--seed", "9", "--json"});
  EXPECT_THAT(json,
              MatchesRegex("\\{\"level\":\"[^\"]*\",\"players\":3,\"ticks\":200,\"seed\":9,\"hash\":\"[0-9a-f]+\","
                           "\"crossings\":[0-9]+,\"goals\":[0-9]+,\"nsPerPlayerTick\":[0-9.]+\\}\n"));
  EXPECT_EQ(hashIn(json).size(), 16u);
}

TEST(RunCommandTest, TheHashDependsOnTheSeed) {
  const std::string level = levelFile();
  for (const char* drive : {"play", "fling"}) {
    const auto hashOf = [&](const char* seed) {
      return hashIn(outputOf(runCommand,
                             {level, "--ticks", "300", "--players", "2", "--drive", drive, "--seed", seed, "--json"}));
    };
    EXPECT_EQ(hashOf("4"), hashOf("4")) << drive;
    EXPECT_NE(hashOf("4"), hashOf("5")) << drive;
  }
}

TEST(RunCommandTest, PushCrossesTheEdgeOnce) {
  const std::string json =
      outputOf(runCommand, {levelFile(), "--drive", "push", "--velocity", "4096,-256", "--ticks", "100", "--json"});
  EXPECT_THAT(json, HasSubstr("\"crossings\":1,"));
}

TEST(RunCommandTest, ATraceDoesNotChangeTheGame) {
  const std::string level = levelFile();
  const std::string trace = pathOf("trace");
  const std::vector<std::string> plain{level, "--ticks", "50", "--json"};
  std::vector<std::string> traced = plain;
  traced.insert(traced.end(), {"--trace", trace});
  const std::string hash = hashIn(outputOf(runCommand, plain));
  EXPECT_EQ(hashIn(outputOf(runCommand, traced)), hash);
  std::ifstream file(trace);
  std::string line;
  std::string last;
  int lines = 0;
  while (std::getline(file, line)) {
    if (lines++ == 0) {
      EXPECT_THAT(line, StartsWith("{\"solid\":\"HEXAHEDRON\",\"subunits\":1024,\"shape\":[["));
    }
    last = line;
  }
  EXPECT_EQ(lines, 51);
  EXPECT_THAT(last,
              StartsWith("{\"tick\":50,\"hash\":\"" + hash + "\",\"open\":[],\"players\":[{\"id\":0,\"legs\":[["));
}

TEST(RunCommandTest, RefusesInvalidArguments) {
  const std::string level = levelFile();
  EXPECT_THROW(runCommand({}), UsageError);
  EXPECT_THROW(runCommand({level, level}), UsageError);
  EXPECT_THROW(runCommand({level, "--players", "0"}), UsageError);
  EXPECT_THROW(runCommand({level, "--players", "257"}), UsageError);
  EXPECT_THROW(runCommand({level, "--ticks", "1", "--drive", "swim"}), UsageError);
  EXPECT_THROW(runCommand({level, "--ticks", "1", "--drive", "push"}), UsageError);
  EXPECT_THROW(runCommand({level, "--ticks", "1", "--drive", "push", "--velocity", "5"}), UsageError);
  EXPECT_THROW(runCommand({level, "--ticks", "1", "--drive", "push", "--velocity", "268435456,0"}), UsageError);
  EXPECT_THROW(runCommand({pathOf("no such level")}), UsageError);
}

TEST(RunCommandTest, RecordsOnlyGames) {
  EXPECT_THROW(runCommand({levelFile(), "--drive", "fling", "--record", pathOf("r")}), UsageError);
  EXPECT_THROW(runCommand({levelFile(), "--record", pathOf("no such folder/r")}), UsageError);
  EXPECT_THROW(runCommand({levelFile(), "--checkpoint-every", "0"}), UsageError);
}

TEST(WorldCommandTest, RunsAScene) {
  const std::string scene = fileWith("scene", "shape 0 0 9 0 0 9\nline -500 -30 500 -30\nentity 0 0\nvelocity 5 -5\n");
  const std::string json = outputOf(worldCommand, {scene, "--ticks", "20", "--json"});
  EXPECT_THAT(json, HasSubstr("\"entities\":1,\"ticks\":20,\"hash\":\""));
  EXPECT_EQ(hashIn(json), hashIn(outputOf(worldCommand, {scene, "--ticks", "20", "--json"})));
  EXPECT_NE(hashIn(json), hashIn(outputOf(worldCommand, {scene, "--ticks", "21", "--json"})));
  EXPECT_NE(hashIn(json), hashIn(outputOf(worldCommand, {scene, "--ticks", "20", "--max-speed", "9", "--json"})));
  EXPECT_THROW(worldCommand({fileWith("bad", "line 1\n")}), InputError);
}

}  // namespace
}  // namespace platon::sim::run_command_test
