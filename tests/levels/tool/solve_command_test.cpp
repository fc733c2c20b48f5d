#include "levels/tool/solve_command.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <string>

#include "tests/sim/verify/verification.h"
#include "tests/support/files.h"
#include "tests/support/process.h"
#include "tests/support/temporary_folder.h"

namespace platon::solve_command_test {
namespace {

// The goal is round the right edge.
constexpr const char* kCrossing =
    "HEXAHEDRON\n0 0 -180 0\n1 0 -184\n480\n%\n-240 -200 240 -200\n%\n-240 -200 240 -200\n%\n%\n%\n%\n";
constexpr const char* kClosed =
    "HEXAHEDRON\n0 0 -180 0\n0 0 100\n480\n%\n-90 -200 90 -200\n-90 -200 -90 -90\n90 -200 90 -90\n-90 -90 90 -90\n"
    "%\n%\n%\n%\n%\n";
// Only the key opens the door before the goal.
constexpr const char* kDoor =
    "HEXAHEDRON\n0 0 -180 0\n0 160 -184\n480\n%\n-240 -200 240 -200\n60 -200 60 -20 door 1\n60 -20 240 -20\n"
    "240 -20 240 -200\n-100 -180 -100 -160 key 1\n%\n-240 -200 240 -200\n%\n-240 -200 240 -200\n%\n"
    "-240 -200 240 -200\n%\n%\n";
// A jump is as high as the goal, but not as wide.
constexpr const char* kUnknown =
    "HEXAHEDRON\n0 -300 -180 0\n0 300 -184\n1000\n%\n-400 -200 -200 -200\n200 -200 400 -200\n-480 -480 480 -480\n"
    "-480 -480 -480 480\n-480 480 480 480\n480 -480 480 480\n%\n%\n%\n%\n%\n";

class SolveCommandTest : public testing::Test {
 protected:
  void SetUp() override {
    writeText(folder_ / "crossing.level", kCrossing);
    writeText(folder_ / "closed.level", kClosed);
    writeText(folder_ / "door.level", kDoor);
    writeText(folder_ / "unknown.level", kUnknown);
    writeText(folder_ / "invalid.level", "HEXAHEDRON\n");
  }
  ProcessResult run(const std::string& arguments) {
    ProcessOptions options;
    options.folder = folder_.path();
    return runProcess(platonCommand("platon-level", wordsOf("solve " + arguments)), options);
  }

  TemporaryFolder folder_;
};

TEST_F(SolveCommandTest, WritesARecordingThatReachesTheGoal) {
  const ProcessResult result = run("crossing.level -o way.recording");
  EXPECT_EQ(result.exitCode, 0) << result.errors;
  EXPECT_NE(result.output.find("1 crossing,"), std::string::npos) << result.output;
  const auto bytes = readBytes(folder_ / "way.recording");
  const sim::Verification found = sim::Verifier(bytes).run();
  EXPECT_EQ(found.fault, "");
  EXPECT_FALSE(found.divergence.has_value());
  EXPECT_GT(found.ticks, 60u);
}

TEST_F(SolveCommandTest, TellsAboutARecordedWay) {
  const ProcessResult found = run("crossing.level --press-cost 30 -o way.recording");
  const ProcessResult told = run("crossing.level --recorded way.recording");
  EXPECT_EQ(told.exitCode, 0) << told.errors;
  EXPECT_EQ(told.output, found.output.substr(0, found.output.rfind(" (")) + "\n");
  EXPECT_TRUE(run("crossing.level --recorded way.recording --json").output.ends_with(",\"difficulty\":1}\n"));
  const ProcessResult other = run("closed.level --recorded way.recording");
  EXPECT_EQ(other.exitCode, 1);
  EXPECT_NE(other.errors.find("does not lead to the goal of 'closed.level' as it is now"), std::string::npos);
  EXPECT_EQ(run("crossing.level --recorded missing.recording").exitCode, 2);
  EXPECT_EQ(run("crossing.level --recorded way.recording --without-crossing 1").exitCode, 2);
  EXPECT_EQ(run("crossing.level --recorded closed.level").exitCode, 3);
}

TEST_F(SolveCommandTest, PrintsJson) {
  const ProcessResult result = run("crossing.level --json");
  EXPECT_EQ(result.exitCode, 0);
  EXPECT_EQ(result.output.find("{\"solved\":true,\"ticks\":"), 0u) << result.output;
  EXPECT_NE(result.output.find("\"crossings\":1,"), std::string::npos);
  EXPECT_EQ(run("closed.level --json").output.find("{\"solved\":false,"), 0u);
}

TEST_F(SolveCommandTest, SaysThatNoWayWasFound) {
  const ProcessResult result = run("closed.level");
  EXPECT_EQ(result.exitCode, 1);
  EXPECT_NE(result.errors.find("no way to the goal found"), std::string::npos) << result.errors;
}

TEST_F(SolveCommandTest, ProvesThatALevelNeedsItsCrossings) {
  const ProcessResult proved = run("crossing.level --without-crossing 1");
  EXPECT_EQ(proved.exitCode, 0) << proved.errors;
  EXPECT_NE(proved.output.find("proved: every way to the goal has 1 crossings or more"), std::string::npos);
  const ProcessResult refuted = run("crossing.level --without-crossing 2");
  EXPECT_EQ(refuted.exitCode, 1);
  EXPECT_EQ(refuted.errors, "platon-level: a way was found: it has 1 crossings\n");
  EXPECT_EQ(run("closed.level --without-crossing 1 --json").output,
            "{\"withoutCrossing\":1,\"proved\":true,\"found\":false}\n");
  EXPECT_EQ(run("crossing.level --without-crossing 2 --json").output,
            "{\"withoutCrossing\":2,\"proved\":false,\"found\":true}\n");
}

TEST_F(SolveCommandTest, ProvesThatALevelNeedsItsKey) {
  const ProcessResult proved = run("door.level --without key 1");
  EXPECT_EQ(proved.exitCode, 0) << proved.errors;
  EXPECT_EQ(proved.output, "proved: every way to the goal uses key 1\n");
  const ProcessResult both = run("door.level --without key 1 --without-crossing 2 --json");
  EXPECT_EQ(both.exitCode, 0) << both.errors;
  EXPECT_EQ(both.output, "{\"withoutCrossing\":2,\"without\":\"key 1\",\"proved\":true,\"found\":false}\n");
}

TEST_F(SolveCommandTest, ShowsAWayWithoutWhatALevelDoesNotNeed) {
  const ProcessResult refuted = run("crossing.level --without key 1 -o way.recording");
  EXPECT_EQ(refuted.exitCode, 1);
  EXPECT_EQ(refuted.errors, "platon-level: a way was found without key 1: it has 1 crossings\n");
  EXPECT_EQ(run("crossing.level --recorded way.recording").exitCode, 0);
}

TEST_F(SolveCommandTest, SaysWhenItCanNeitherProveNorRefute) {
  const ProcessResult unknown = run("unknown.level --without checkpoint");
  EXPECT_EQ(unknown.exitCode, 1);
  EXPECT_EQ(unknown.errors,
            "platon-level: not proved that every way to the goal uses a checkpoint: no other way was found, but there "
            "may be one\n");
  const std::string verdict = "{\"without\":\"checkpoint\",\"proved\":false,\"found\":false}\n";
  EXPECT_EQ(run("unknown.level --without checkpoint --json").output, verdict);
  EXPECT_EQ(run("--without checkpoint unknown.level --json").output, verdict);
}

TEST_F(SolveCommandTest, RefusesWhatItCannotUse) {
  EXPECT_EQ(run("missing.level").exitCode, 2);
  EXPECT_EQ(run("invalid.level").exitCode, 3);
  EXPECT_EQ(run("crossing.level --without-crossing -1").exitCode, 2);
  EXPECT_EQ(run("crossing.level --without door 1").errors,
            "platon-level: --without must be key K or plate K with K from 0 to 31, or checkpoint, not 'door 1' (see "
            "platon-level --help)\n");
  EXPECT_EQ(run("crossing.level --without key").exitCode, 2);
  EXPECT_EQ(run("").errors, "platon-level: solve: FILE is missing (see platon-level --help)\n");
  EXPECT_EQ(run("crossing.level --without key 32").exitCode, 2);
  EXPECT_EQ(run("crossing.level --without key 1 2").exitCode, 2);
  const ProcessResult unwritten = run("crossing.level -o missing/way.recording");
  EXPECT_EQ(unwritten.exitCode, 1);
  EXPECT_EQ(unwritten.errors, "platon-level: cannot write 'missing/way.recording': No such file or directory\n");
}

TEST_F(SolveCommandTest, WhoReadsTheOldRecordingNeverSeesAPartOfTheNewOne) {
  writeText(folder_ / "way.recording", "old");
  std::ifstream reader(folder_ / "way.recording", std::ios::binary);
  ASSERT_EQ(run("crossing.level -o way.recording").exitCode, 0);
  EXPECT_EQ(std::string(std::istreambuf_iterator<char>(reader), {}), "old");
  EXPECT_GT(readBytes(folder_ / "way.recording").size(), 3U);
}

}  // namespace
}  // namespace platon::solve_command_test
