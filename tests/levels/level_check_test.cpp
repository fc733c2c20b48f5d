#include <gtest/gtest.h>

#include <sys/wait.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

namespace platon {
namespace {

constexpr const char* kGood =
    "# title: A \"quoted\" \\ title\nHEXAHEDRON\n0 0 0 0\n1 0 0\n480\n%\n5 50 9 50\n%\n%\n%\n%\n%\n";
constexpr const char* kOdd = "HEXAHEDRON\n0 0 0 0\n1 0 0\n480\n%\n5 50 5 50\n%\n%\n%\n%\n%\n";
constexpr const char* kBad = "HEXAHEDRON\n0 0 0 0\n6 0 0\n480\n%\n5 50 5\n%\n%\n%\n%\n%\n";

struct Outcome {
  int code = -1;
  std::string out;
  std::string err;
};

std::string contentOf(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

class CheckTest : public testing::Test {
 protected:
  void SetUp() override {
    std::string pattern = (std::filesystem::temp_directory_path() / "platon-level-XXXXXX").string();
    ASSERT_NE(mkdtemp(pattern.data()), nullptr);
    folder_ = pattern;
    write("good.txt", kGood);
    write("odd.txt", kOdd);
    write("bad.txt", kBad);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  void write(const std::string& name, const std::string& content) {
    std::ofstream(folder_ / name, std::ios::binary) << content;
  }

  // Runs platon-level in the folder of the files.
  Outcome run(const std::string& arguments) {
    const char* bin = std::getenv("PLATON_BIN");
    const std::string program =
        std::filesystem::absolute(std::string(bin == nullptr ? "." : bin) + "/platon-level").string();
    const std::string command = "cd '" + folder_.string() + "' && '" + program + "' " + arguments + " >out 2>err";
    const int status = std::system(command.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, contentOf(folder_ / "out"), contentOf(folder_ / "err")};
  }

 private:
  std::filesystem::path folder_;
};

TEST_F(CheckTest, GoodLevelsAreOk) {
  const Outcome outcome = run("check good.txt odd.txt");
  EXPECT_EQ(outcome.code, 0);
  EXPECT_EQ(outcome.out, "good.txt: ok, HEXAHEDRON, 1 line\nodd.txt: ok, HEXAHEDRON, 1 line, 1 warning\n");
  EXPECT_EQ(outcome.err, "odd.txt:6:1: warning: a line without length: it blocks as a point\n");
}

TEST_F(CheckTest, EveryErrorOfEveryFileIsReported) {
  const Outcome outcome = run("check bad.txt good.txt");
  EXPECT_EQ(outcome.code, 3);
  EXPECT_EQ(outcome.out, "bad.txt: 2 errors\ngood.txt: ok, HEXAHEDRON, 1 line\n");
  EXPECT_EQ(outcome.err,
            "bad.txt:3:1: error: face must be between 0 and 5, not '6'\n"
            "bad.txt:6:7: error: a line is: x0 y0 x1 y1; y1 is missing\n");
}

TEST_F(CheckTest, UnreadableFilesAreAUsageErrorInOneLine) {
  const Outcome missing = run("check nowhere.txt");
  EXPECT_EQ(missing.code, 2);
  EXPECT_EQ(missing.err, "platon-level: cannot read 'nowhere.txt': No such file or directory\n");
  const Outcome folder = run("check .");
  EXPECT_EQ(folder.code, 2);
  EXPECT_EQ(folder.err, "platon-level: cannot read '.': Is a directory\n");
  EXPECT_EQ(run("check bad.txt nowhere.txt").code, 2);
}

TEST_F(CheckTest, WrongUseIsAnErrorInOneLine) {
  for (const char* arguments : {"", "check", "unknown", "check --unknown good.txt", "--unknown"}) {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.code, 2) << arguments;
    EXPECT_EQ(outcome.out, "") << arguments;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
    EXPECT_TRUE(outcome.err.starts_with("platon-level: ")) << outcome.err;
  }
}

TEST_F(CheckTest, HelpAndVersionGoToStandardOutput) {
  for (const char* arguments : {"--help", "--version", "check --help"}) {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.code, 0) << arguments;
    EXPECT_NE(outcome.out, "") << arguments;
    EXPECT_EQ(outcome.err, "") << arguments;
  }
  EXPECT_TRUE(run("--version").out.starts_with("platon-level "));
}

TEST_F(CheckTest, JsonIsOneObject) {
  const Outcome outcome = run("check --json good.txt bad.txt");
  EXPECT_EQ(outcome.code, 3);
  EXPECT_EQ(
      outcome.out,
      "{\"levels\":[{\"file\":\"good.txt\",\"ok\":true,\"solid\":\"HEXAHEDRON\",\"faceSize\":480,\"lines\":1,"
      "\"title\":\"A \\\"quoted\\\" \\\\ title\",\"author\":\"\",\"diagnostics\":[]},"
      "{\"file\":\"bad.txt\",\"ok\":false,\"diagnostics\":["
      "{\"line\":3,\"column\":1,\"severity\":\"error\",\"message\":\"face must be between 0 and 5, not '6'\"},"
      "{\"line\":6,\"column\":7,\"severity\":\"error\",\"message\":\"a line is: x0 y0 x1 y1; y1 is missing\"}]}]}\n");
}

TEST_F(CheckTest, FilesTooLongAreRefusedWithoutReadingAll) {
  write("long.txt", std::string((std::size_t{4} << 20) + 10, ' '));
  const Outcome outcome = run("check long.txt");
  EXPECT_EQ(outcome.code, 3);
  EXPECT_EQ(outcome.err, "long.txt:1:1: error: the text has more than 4194304 bytes\n");
}

}  // namespace
}  // namespace platon
