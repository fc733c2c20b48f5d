#include <gtest/gtest.h>
#include <sys/stat.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "tests/support/environment_variable.h"
#include "tests/support/process.h"
#include "tests/support/temporary_folder.h"

namespace platon::refusals_test {
namespace {

using Arguments = std::vector<std::string>;

struct Refusal {
  const char* name;
  std::string program;
  Arguments arguments;
  int exitCode;
  std::string message;  // on standard error
};

class Refused : public testing::TestWithParam<Refusal> {};

TEST_P(Refused, WithOneLineAndItsExitCode) {
  const Refusal& refusal = GetParam();
  Process program(platonCommand(refusal.program, refusal.arguments));
  EXPECT_EQ(program.wait(), refusal.exitCode) << program.errors();
  const std::string errors = program.errors();
  EXPECT_NE(errors.find(refusal.message), std::string::npos) << errors;
  EXPECT_EQ(std::count(errors.begin(), errors.end(), '\n'), 1) << errors;
}

// No program listens on UDP port 1.
const std::vector<Refusal> kRefusals = {
    {"Option", "platon-client", {"--frobnicate"}, 2, "--frobnicate"},
    {"Port", "platon-client", {"localhost:70000"}, 2, "'localhost:70000'"},
    {"Seconds", "platon-client", {"--seconds", "soon"}, 2, "--seconds"},
    {"Name", "platon-client", {"--name", std::string(33, 'x')}, 2, "--name"},
    {"LevelForARemoteServer", "platon-client", {"localhost", "--level", "x.level"}, 2, "--level"},
    {"NoSuchLevel", "platon-client", {"--offscreen", "--level", "no/such.level"}, 2, "no/such.level"},
    {"NoDisplay", "platon-client", {"--level", "tests/determinism/golden/levels/hexahedron.level"}, 2, "--offscreen"},
    {"NoServer",
     "platon-client",
     {"127.0.0.1:1", "--offscreen", "--seconds", "30"},
     1,
     "no answer from 127.0.0.1:1 within 5 s: is platon-server running there?"},
    {"TimeLimitBeforeAnyAnswer",
     "platon-client",
     {"127.0.0.1:1", "--offscreen", "--seconds", "1"},
     1,
     "time limit reached: connecting to 127.0.0.1:1"},
    {"BotCount", "platon-bot", {"localhost", "--count", "0", "--seconds", "1"}, 2, "--count"},
    {"BotWithoutSeconds", "platon-bot", {"localhost", "--count", "1"}, 2, "--seconds"},
    {"BotLoss", "platon-bot", {"localhost", "--count", "1", "--seconds", "1", "--loss", "101"}, 2, "--loss"},
    {"BotPort", "platon-bot", {"localhost:x", "--count", "1", "--seconds", "1"}, 2, "'localhost:x'"},
    {"BotNoServer", "platon-bot", {"127.0.0.1:1", "--count", "1", "--seconds", "7"}, 1, "no answer from 127.0.0.1:1"},
};

INSTANTIATE_TEST_SUITE_P(All, Refused, testing::ValuesIn(kRefusals),
                         [](const testing::TestParamInfo<Refusal>& test) { return test.param.name; });

TEST(Programs, PrintTheErrorsOfALevel) {
  Process program(platonCommand("platon-client", {"--offscreen", "--level", "LICENSE"}));
  EXPECT_EQ(program.wait(), 3);
  EXPECT_EQ(program.errors().rfind("LICENSE:1:1: error: ", 0), 0u) << program.errors();
}

TEST(Programs, PrintTheirVersionAndHelp) {
  for (const char* const name : {"platon-client", "platon-bot", "platon-server"}) {
    Process version(platonCommand(name, {"--version"}));
    EXPECT_EQ(version.wait(), 0);
    EXPECT_EQ(version.output().rfind(name, 0), 0u) << version.output();
    Process help(platonCommand(name, {"--help"}));
    EXPECT_EQ(help.wait(), 0);
    EXPECT_NE(help.output().find("--version"), std::string::npos) << help.output();
    EXPECT_EQ(help.errors(), "");
  }
}

// The start of a program would wait for somebody who writes to the pipe.
TEST(Programs, RefuseAPipeInPlaceOfAFile) {
  const TemporaryFolder folder;
  const std::string pipe = folder / "platon/known_servers";
  std::filesystem::create_directory(folder / "platon");
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  const EnvironmentVariable data("XDG_DATA_HOME", folder.path());
  const std::vector<std::vector<std::string>> commands{
      platonCommand("platon-server", {"--config", pipe}), platonCommand("platon-server", {"--key-file", pipe}),
      platonCommand("platon-client", {"127.0.0.1:1", "--offscreen"}),
      platonCommand("platon-client", {"--offscreen", "--level", pipe})};
  for (const std::vector<std::string>& command : commands) {
    const ProcessResult result = runProcess(command);
    EXPECT_EQ(result.exitCode, 2) << command.front();
    EXPECT_NE(result.errors.find("it is a pipe, not a regular file; "), std::string::npos) << result.errors;
  }
  // A password may come from a pipe, but this one has no writer.
  const ProcessResult result = runProcess(
      platonCommand("platon-bot", {"127.0.0.1:1", "--count", "1", "--seconds", "1", "--password-file", pipe}));
  EXPECT_EQ(result.exitCode, 2);
  EXPECT_NE(result.errors.find("the first line is empty; "), std::string::npos) << result.errors;
}

}  // namespace
}  // namespace platon::refusals_test
