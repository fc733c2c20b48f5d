#include "levels/tool/preview_command.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "tests/support/files.h"
#include "tests/support/process.h"
#include "tests/support/temporary_folder.h"

namespace platon::preview_command_test {
namespace {

constexpr const char* kValid = "HEXAHEDRON\n0 0 0 0\n1 0 0\n480\n%\n5 50 9 50\n%\n%\n%\n%\n%\n";
constexpr const char* kWarning = "HEXAHEDRON\n0 0 0 0\n1 0 0\n480\n%\n5 50 5 50\n%\n%\n%\n%\n%\n";
constexpr const char* kInvalid = "HEXAHEDRON\n0 0 0 0\n6 0 0\n480\n%\n5 50 5\n%\n%\n%\n%\n%\n";

class PreviewCommandTest : public testing::Test {
 protected:
  void SetUp() override {
    writeText(folder_ / "valid.txt", kValid);
    writeText(folder_ / "warning.txt", kWarning);
    writeText(folder_ / "invalid.txt", kInvalid);
  }

  // Runs platon-level in the folder with the files.
  ProcessResult run(const std::string& arguments) {
    ProcessOptions options;
    options.folder = folder_.path();
    return runProcess(platonCommand("platon-level", wordsOf(arguments)), options);
  }

  bool exists(const std::string& name) const { return std::filesystem::exists(folder_ / name); }

  std::vector<std::uint8_t> bytesOf(const std::string& name) const { return readBytes(folder_ / name); }

  // Width and height, as the header of a PNG file states them.
  std::vector<int> sizeOf(const std::string& name) const {
    const std::vector<std::uint8_t> bytes = bytesOf(name);
    const auto number = [&](std::size_t at) {
      return bytes.at(at) << 24 | bytes.at(at + 1) << 16 | bytes.at(at + 2) << 8 | bytes.at(at + 3);
    };
    return {number(16), number(20)};
  }

  const TemporaryFolder folder_;
};

TEST_F(PreviewCommandTest, WritesAPicture) {
  const ProcessResult result = run("preview valid.txt -o picture.png");
  EXPECT_EQ(result.exitCode, 0);
  EXPECT_EQ(result.output + result.errors, "");
  EXPECT_EQ(sizeOf("picture.png"), (std::vector<int>{1600, 1000}));
}

TEST_F(PreviewCommandTest, TheSameLevelGivesTheSameBytes) {
  EXPECT_EQ(run("preview valid.txt -o first.png --width 320").exitCode, 0);
  EXPECT_EQ(run("preview valid.txt --output second.png --width 320").exitCode, 0);
  EXPECT_EQ(sizeOf("first.png"), (std::vector<int>{320, 200}));
  EXPECT_EQ(bytesOf("first.png"), bytesOf("second.png"));
}

TEST_F(PreviewCommandTest, WarningsArePrintedAsByCheck) {
  const ProcessResult result = run("preview warning.txt -o picture.png");
  EXPECT_EQ(result.exitCode, 0);
  EXPECT_EQ(result.errors,
            "warning.txt:6:1: warning: the line has no length: it blocks as a point\n    5 50 5 50\n    ^\n");
  EXPECT_TRUE(exists("picture.png"));
}

TEST_F(PreviewCommandTest, AnInvalidLevelGivesTheErrorsOfCheckAndNoPicture) {
  const ProcessResult result = run("preview invalid.txt -o picture.png");
  EXPECT_EQ(result.exitCode, 3);
  EXPECT_EQ(result.output, "");
  EXPECT_EQ(result.errors, run("check invalid.txt").errors);
  EXPECT_FALSE(exists("picture.png"));
}

TEST_F(PreviewCommandTest, AnUnwritablePictureIsAnError) {
  const ProcessResult result = run("preview valid.txt -o nowhere/picture.png");
  EXPECT_EQ(result.exitCode, 1);
  EXPECT_EQ(result.errors, "platon-level: cannot write 'nowhere/picture.png': No such file or directory\n");
  EXPECT_EQ(run("preview valid.txt -o .").errors, "platon-level: cannot write '.': Is a directory\n");
  const ProcessResult device = run("preview valid.txt -o /dev/full");
  EXPECT_EQ(device.exitCode, 1);
  EXPECT_EQ(device.errors, "platon-level: cannot write '/dev/full': it is a device, not a regular file\n");
}

TEST_F(PreviewCommandTest, WhoReadsTheOldPictureNeverSeesAPartOfTheNewOne) {
  ASSERT_EQ(run("preview valid.txt -o picture.png --width 320").exitCode, 0);
  const std::string old = readText(folder_ / "picture.png");
  std::ifstream reader(folder_ / "picture.png", std::ios::binary);
  ASSERT_EQ(run("preview valid.txt -o picture.png --width 640").exitCode, 0);
  EXPECT_EQ(std::string(std::istreambuf_iterator<char>(reader), {}), old);
  EXPECT_EQ(sizeOf("picture.png"), (std::vector<int>{640, 400}));
}

TEST_F(PreviewCommandTest, InvalidArgumentsAreUsageErrors) {
  for (const char* arguments :
       {"preview", "preview valid.txt", "preview -o picture.png", "preview valid.txt valid.txt",
        "preview valid.txt -o picture.png --width 159", "preview valid.txt -o picture.png --width 8193",
        "preview valid.txt -o picture.png --width wide"}) {
    const ProcessResult result = run(arguments);
    EXPECT_EQ(result.exitCode, 2) << arguments;
    EXPECT_EQ(result.output, "") << arguments;
    EXPECT_EQ(std::count(result.errors.begin(), result.errors.end(), '\n'), 1) << result.errors;
    EXPECT_TRUE(result.errors.starts_with("platon-level: ")) << result.errors;
  }
  const ProcessResult missing = run("preview nowhere.txt -o picture.png");
  EXPECT_EQ(missing.exitCode, 2);
  EXPECT_EQ(missing.errors,
            "platon-level: cannot read 'nowhere.txt': No such file or directory; name a readable file\n");
  EXPECT_FALSE(exists("picture.png"));
}

TEST_F(PreviewCommandTest, PrintsHelp) {
  const ProcessResult result = run("preview --help");
  EXPECT_EQ(result.exitCode, 0);
  EXPECT_NE(result.output.find("--width"), std::string::npos);
  EXPECT_EQ(result.errors, "");
}

}  // namespace
}  // namespace platon::preview_command_test
