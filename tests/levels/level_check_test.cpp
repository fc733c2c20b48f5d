#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "tests/support/files.h"
#include "tests/support/process.h"
#include "tests/support/temporary_folder.h"

namespace platon {
namespace {

constexpr const char* kGood =
    "# title: A \"quoted\" \\ title\nHEXAHEDRON\n0 0 0 0\n1 0 0\n480\n%\n5 50 9 50\n%\n%\n%\n%\n%\n";
constexpr const char* kOdd = "HEXAHEDRON\n0 0 0 0\n1 0 0\n480\n%\n5 50 5 50\n%\n%\n%\n%\n%\n";
constexpr const char* kBad = "HEXAHEDRON\n0 0 0 0\n6 0 0\n480\n%\n5 50 5\n%\n%\n%\n%\n%\n";

class CheckTest : public testing::Test {
 protected:
  void SetUp() override {
    write("good.txt", kGood);
    write("odd.txt", kOdd);
    write("bad.txt", kBad);
  }

  void write(const std::string& name, const std::string& content) { writeText(folder_ / name, content); }

  // Runs platon-level in the folder of the files.
  ProcessResult run(const std::string& arguments) {
    ProcessOptions options;
    options.folder = folder_.path();
    return runProcess(platonCommand("platon-level", wordsOf(arguments)), options);
  }

 private:
  const TemporaryFolder folder_;
};

TEST_F(CheckTest, GoodLevelsAreOk) {
  const ProcessResult outcome = run("check good.txt odd.txt");
  EXPECT_EQ(outcome.exitCode, 0);
  EXPECT_EQ(outcome.output, "good.txt: ok, HEXAHEDRON, 1 line\nodd.txt: ok, HEXAHEDRON, 1 line, 1 warning\n");
  EXPECT_EQ(outcome.errors, "odd.txt:6:1: warning: a line without length: it blocks as a point\n");
}

TEST_F(CheckTest, EveryErrorOfEveryFileIsReported) {
  const ProcessResult outcome = run("check bad.txt good.txt");
  EXPECT_EQ(outcome.exitCode, 3);
  EXPECT_EQ(outcome.output, "bad.txt: 2 errors\ngood.txt: ok, HEXAHEDRON, 1 line\n");
  EXPECT_EQ(outcome.errors,
            "bad.txt:3:1: error: face must be between 0 and 5, not '6'\n"
            "bad.txt:6:7: error: a line is: x0 y0 x1 y1; y1 is missing\n");
}

TEST_F(CheckTest, UnreadableFilesAreAUsageErrorInOneLine) {
  const ProcessResult missing = run("check nowhere.txt");
  EXPECT_EQ(missing.exitCode, 2);
  EXPECT_EQ(missing.errors, "platon-level: cannot read 'nowhere.txt': No such file or directory\n");
  const ProcessResult folder = run("check .");
  EXPECT_EQ(folder.exitCode, 2);
  EXPECT_EQ(folder.errors, "platon-level: cannot read '.': Is a directory\n");
  EXPECT_EQ(run("check bad.txt nowhere.txt").exitCode, 2);
}

TEST_F(CheckTest, WrongUseIsAnErrorInOneLine) {
  for (const char* arguments : {"", "check", "unknown", "check --unknown good.txt", "--unknown"}) {
    const ProcessResult outcome = run(arguments);
    EXPECT_EQ(outcome.exitCode, 2) << arguments;
    EXPECT_EQ(outcome.output, "") << arguments;
    EXPECT_EQ(std::count(outcome.errors.begin(), outcome.errors.end(), '\n'), 1) << outcome.errors;
    EXPECT_TRUE(outcome.errors.starts_with("platon-level: ")) << outcome.errors;
  }
}

TEST_F(CheckTest, HelpAndVersionGoToStandardOutput) {
  for (const char* arguments : {"--help", "--version", "check --help"}) {
    const ProcessResult outcome = run(arguments);
    EXPECT_EQ(outcome.exitCode, 0) << arguments;
    EXPECT_NE(outcome.output, "") << arguments;
    EXPECT_EQ(outcome.errors, "") << arguments;
  }
  EXPECT_TRUE(run("--version").output.starts_with("platon-level "));
}

TEST_F(CheckTest, JsonIsOneObject) {
  const ProcessResult outcome = run("check --json good.txt bad.txt");
  EXPECT_EQ(outcome.exitCode, 3);
  EXPECT_EQ(
      outcome.output,
      "{\"levels\":[{\"file\":\"good.txt\",\"ok\":true,\"solid\":\"HEXAHEDRON\",\"faceSize\":480,\"lines\":1,"
      "\"title\":\"A \\\"quoted\\\" \\\\ title\",\"author\":\"\",\"diagnostics\":[]},"
      "{\"file\":\"bad.txt\",\"ok\":false,\"diagnostics\":["
      "{\"line\":3,\"column\":1,\"severity\":\"error\",\"message\":\"face must be between 0 and 5, not '6'\"},"
      "{\"line\":6,\"column\":7,\"severity\":\"error\",\"message\":\"a line is: x0 y0 x1 y1; y1 is missing\"}]}]}\n");
}

TEST_F(CheckTest, FilesTooLongAreRefusedWithoutReadingAll) {
  write("long.txt", std::string((std::size_t{4} << 20) + 10, ' '));
  const ProcessResult outcome = run("check long.txt");
  EXPECT_EQ(outcome.exitCode, 3);
  EXPECT_EQ(outcome.errors, "long.txt:1:1: error: the text has more than 4194304 bytes\n");
}

}  // namespace
}  // namespace platon
