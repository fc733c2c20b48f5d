// The program platon-sim: help, version and exit codes.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <string>

#include "tests/sim/command_testing.h"

namespace platon::sim::sim_program_test {
namespace {

using testing::HasSubstr;
using testing::MatchesRegex;
using testing::StartsWith;

TEST(SimProgramTest, PrintsHelpAndVersion) {
  const ProcessResult help = runProgram("--help");
  EXPECT_EQ(help.exitCode, 0);
  EXPECT_THAT(help.output, StartsWith("platon-sim: runs the simulation"));
  EXPECT_EQ(runProgram("run --help").output, help.output);
  EXPECT_EQ(runProgram("run --help").exitCode, 0);
  EXPECT_THAT(runProgram("--version").output, MatchesRegex("platon-sim [0-9]+\\.[0-9]+\\.[0-9]+\n"));
}

TEST(SimProgramTest, UsageErrorsExitWith2AndPrintNothingToStdout) {
  for (const std::string& arguments : {std::string(), std::string("swim"), std::string("run"),
                                       "run --ticks many " + levelFile(), "run --unknown " + levelFile()}) {
    const ProcessResult result = runProgram(arguments);
    EXPECT_EQ(result.exitCode, 2) << arguments;
    EXPECT_EQ(result.output, "") << arguments;
    EXPECT_THAT(result.errors, StartsWith("platon-sim: ")) << arguments;
  }
}

TEST(SimProgramTest, InvalidInputFilesExitWith3) {
  const std::string level = fileWith("invalid", "HEXAHEDRON\n0 0 0 0\n0 0 0\n480\n");
  const ProcessResult result = runProgram("run " + level);
  EXPECT_EQ(result.exitCode, 3);
  EXPECT_THAT(result.errors, StartsWith(level + ":"));
  EXPECT_THAT(result.errors, HasSubstr(": error: "));
  EXPECT_EQ(runProgram("world " + fileWith("scene", "line 1\n") + " --ticks 1").exitCode, 3);
  EXPECT_EQ(runProgram("sweep", fileWith("queries", "nothing\n")).exitCode, 3);
}

TEST(SimProgramTest, AFailedWriteExitsWith3) {
  const ProcessResult result = runProgram("run --ticks 60 --trace /dev/full " + levelFile());
  EXPECT_EQ(result.exitCode, 3);
  EXPECT_EQ(result.errors, "cannot write to '/dev/full': No space left on device\n");
}

TEST(SimProgramTest, WhoReadsTheOldRecordingNeverSeesAPartOfTheNewOne) {
  const std::string file = fileWith("recording", "old");
  std::ifstream reader(file, std::ios::binary);
  EXPECT_EQ(runProgram("run --ticks 60 --record " + file + " " + levelFile()).exitCode, 0);
  EXPECT_EQ(std::string(std::istreambuf_iterator<char>(reader), {}), "old");
  EXPECT_EQ(runProgram("verify " + file).exitCode, 0);
  const ProcessResult device = runProgram("run --ticks 60 --record /dev/full " + levelFile());
  EXPECT_EQ(device.exitCode, 2);
  EXPECT_THAT(device.errors, HasSubstr("cannot write '/dev/full': it is a device, not a regular file"));
}

TEST(SimProgramTest, ARunExitsWith0) { EXPECT_EQ(runProgram("run --ticks 5 " + levelFile()).exitCode, 0); }

}  // namespace
}  // namespace platon::sim::sim_program_test
