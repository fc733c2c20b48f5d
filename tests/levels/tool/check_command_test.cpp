#include "levels/tool/check_command.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "tests/support/files.h"
#include "tests/support/process.h"
#include "tests/support/temporary_folder.h"

namespace platon::check_command_test {
namespace {

constexpr const char* kValid =
    "# title: A \"quoted\" \\ title\nHEXAHEDRON\n0 0 0 0\n1 0 0\n480\n%\n5 50 9 50\n%\n%\n%\n%\n%\n";
constexpr const char* kWarning = "HEXAHEDRON\n0 0 0 0\n1 0 0\n480\n%\n5 50 5 50\n%\n%\n%\n%\n%\n";
constexpr const char* kInvalid = "HEXAHEDRON\n0 0 0 0\n6 0 0\n480\n%\n5 50 5\n%\n%\n%\n%\n%\n";

class CheckCommandTest : public testing::Test {
 protected:
  void SetUp() override {
    write("valid.txt", kValid);
    write("warning.txt", kWarning);
    write("invalid.txt", kInvalid);
  }

  void write(const std::string& name, const std::string& content) { writeText(folder_ / name, content); }

  // Runs platon-level in the folder with the files.
  ProcessResult run(const std::string& arguments) {
    ProcessOptions options;
    options.folder = folder_.path();
    return runProcess(platonCommand("platon-level", wordsOf(arguments)), options);
  }

 private:
  const TemporaryFolder folder_;
};

TEST_F(CheckCommandTest, ValidLevelsAreOk) {
  const ProcessResult result = run("check valid.txt warning.txt");
  EXPECT_EQ(result.exitCode, 0);
  EXPECT_EQ(result.output, "valid.txt: ok, HEXAHEDRON, 1 line\nwarning.txt: ok, HEXAHEDRON, 1 line, 1 warning\n");
  EXPECT_EQ(result.errors,
            "warning.txt:6:1: warning: the line has no length: it blocks as a point\n    5 50 5 50\n    ^\n");
}

TEST_F(CheckCommandTest, PrintsEveryErrorOfEveryFile) {
  const ProcessResult result = run("check invalid.txt valid.txt");
  EXPECT_EQ(result.exitCode, 3);
  EXPECT_EQ(result.output, "invalid.txt: 2 errors\nvalid.txt: ok, HEXAHEDRON, 1 line\n");
  EXPECT_EQ(result.errors,
            "invalid.txt:3:1: error: face must be between 0 and 5, not '6'\n    6 0 0\n    ^\n"
            "invalid.txt:6:7: error: missing y1: a line is 'x0 y0 x1 y1'\n    5 50 5\n          ^\n");
}

TEST_F(CheckCommandTest, UnreadableFilesAreUsageErrors) {
  const ProcessResult missing = run("check nowhere.txt");
  EXPECT_EQ(missing.exitCode, 2);
  EXPECT_EQ(missing.errors,
            "platon-level: cannot read 'nowhere.txt': No such file or directory; name a readable file\n");
  const ProcessResult folder = run("check .");
  EXPECT_EQ(folder.exitCode, 2);
  EXPECT_EQ(folder.errors, "platon-level: cannot read '.': Is a directory; name a readable file\n");
  EXPECT_EQ(run("check invalid.txt nowhere.txt").exitCode, 2);
}

TEST_F(CheckCommandTest, InvalidArgumentsAreUsageErrors) {
  for (const char* arguments : {"", "check", "unknown", "check --unknown valid.txt", "--unknown"}) {
    const ProcessResult result = run(arguments);
    EXPECT_EQ(result.exitCode, 2) << arguments;
    EXPECT_EQ(result.output, "") << arguments;
    EXPECT_EQ(std::count(result.errors.begin(), result.errors.end(), '\n'), 1) << result.errors;
    EXPECT_TRUE(result.errors.starts_with("platon-level: ")) << result.errors;
  }
}

TEST_F(CheckCommandTest, PrintsHelpAndVersionToStandardOutput) {
  for (const char* arguments : {"--help", "--version", "check --help"}) {
    const ProcessResult result = run(arguments);
    EXPECT_EQ(result.exitCode, 0) << arguments;
    EXPECT_NE(result.output, "") << arguments;
    EXPECT_EQ(result.errors, "") << arguments;
  }
  EXPECT_TRUE(run("--version").output.starts_with("platon-level "));
}

TEST_F(CheckCommandTest, PrintsOneJsonObject) {
  const ProcessResult result = run("check --json valid.txt invalid.txt");
  EXPECT_EQ(result.exitCode, 3);
  EXPECT_EQ(
      result.output,
      "{\"levels\":[{\"file\":\"valid.txt\",\"ok\":true,\"solid\":\"HEXAHEDRON\",\"faceSize\":480,\"lines\":1,"
      "\"title\":\"A \\\"quoted\\\" \\\\ title\",\"author\":\"\",\"diagnostics\":[]},"
      "{\"file\":\"invalid.txt\",\"ok\":false,\"diagnostics\":["
      "{\"line\":3,\"column\":1,\"severity\":\"error\",\"message\":\"face must be between 0 and 5, not '6'\"},"
      "{\"line\":6,\"column\":7,\"severity\":\"error\",\"message\":\"missing y1: a line is 'x0 y0 x1 y1'\"}]}]}\n");
}

TEST_F(CheckCommandTest, RefusesAFileThatIsTooLong) {
  write("long.txt", std::string((std::size_t{4} << 20) + 10, ' '));
  const ProcessResult result = run("check long.txt");
  EXPECT_EQ(result.exitCode, 3);
  EXPECT_EQ(result.errors, "long.txt:1:1: error: the level file is longer than 4194304 bytes\n");
}

}  // namespace
}  // namespace platon::check_command_test
