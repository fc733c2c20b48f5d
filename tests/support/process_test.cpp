#include "tests/support/process.h"

#include <gtest/gtest.h>

#include <csignal>
#include <stdexcept>

#include "tests/support/files.h"
#include "tests/support/temporary_folder.h"

namespace platon::process_test {
namespace {

std::vector<std::string> shell(const std::string& script) { return {"sh", "-c", script}; }

TEST(Process, ReturnsExitCodeAndOutput) {
  const ProcessResult result = runProcess(shell("echo out; echo err >&2; exit 3"));
  EXPECT_EQ(result.exitCode, 3);
  EXPECT_EQ(result.output, "out\n");
  EXPECT_EQ(result.errors, "err\n");
}

TEST(Process, ReportsTheSignalThatEndedIt) { EXPECT_EQ(runProcess(shell("kill -9 $$")).exitCode, 128 + SIGKILL); }

TEST(Process, ExitsWith127WhenTheProgramDoesNotExist) { EXPECT_EQ(runProcess({"/no/such/program"}).exitCode, 127); }

TEST(Process, CapturesMoreThanAPipeHolds) {
  EXPECT_EQ(runProcess(shell("head -c 1000000 /dev/zero")).output.size(), 1000000u);
}

TEST(Process, ReadsTheInputFileInTheFolder) {
  const TemporaryFolder folder;
  writeText(folder / "input", "text");
  ProcessOptions options;
  options.folder = folder.path();
  options.inputFile = folder / "input";
  EXPECT_EQ(runProcess(shell("cat; ls"), options).output, "textinput\n");
}

TEST(Process, WaitsForALine) {
  Process process(shell("echo one two; echo three >&2; echo four >&2; exec sleep 60"));
  EXPECT_EQ(process.waitForOutput("one"), " two");
  EXPECT_EQ(process.nextErrorLine(), "three");
  EXPECT_EQ(process.nextErrorLine(), "four");
}

TEST(Process, ThrowsWhenItEndsWithoutTheLine) {
  Process process(shell("echo something else"));
  EXPECT_THROW(process.waitForOutput("expected"), std::runtime_error);
}

TEST(Process, ThrowsWhenItDoesNotEndInTime) {
  Process process(shell("exec sleep 60"));
  EXPECT_THROW(process.wait(std::chrono::seconds(0)), std::runtime_error);
}

TEST(Files, ReadWhatWasWritten) {
  const TemporaryFolder folder;
  writeText(folder / "file", std::string("a\0b", 3));
  EXPECT_EQ(readText(folder / "file"), std::string("a\0b", 3));
  EXPECT_EQ(readBytes(folder / "file"), (std::vector<std::uint8_t>{'a', 0, 'b'}));
}

TEST(Files, UnreadableFilesAndEmptyListsAreErrors) {
  const TemporaryFolder folder;
  EXPECT_THROW(readText(folder / "missing"), std::runtime_error);
  EXPECT_THROW(filesIn(folder.path(), ".level"), std::runtime_error);
}

TEST(TemporaryFolder, IsDeletedWithItsContents) {
  std::filesystem::path path;
  {
    const TemporaryFolder folder;
    path = folder.path();
    writeText(folder / "file", "");
  }
  EXPECT_FALSE(std::filesystem::exists(path));
}

}  // namespace
}  // namespace platon::process_test
