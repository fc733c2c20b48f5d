#include "server/app/recording_folder.h"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <algorithm>
#include <csignal>
#include <vector>

#include "protocol/program_error.h"
#include "tests/support/files.h"
#include "tests/support/temporary_folder.h"

namespace platon {
namespace {

namespace fs = std::filesystem;

constexpr RecordingFolder::Time kTime{std::chrono::seconds(1795284301)};  // 2026-11-21 18:05:01 UTC

class RecordingFolderTest : public testing::Test {
 protected:
  std::vector<std::string> names() const {
    std::vector<std::string> found;
    for (const auto& entry : fs::directory_iterator(folder_)) found.push_back(entry.path().filename().string());
    std::sort(found.begin(), found.end());
    return found;
  }
  std::string content(const std::string& name) const { return readText(folder_ / name); }

  const TemporaryFolder temporary_;
  const fs::path folder_ = temporary_ / "deep";
  std::vector<std::string> lines_;
  Log log_{LogFormat::kText, [this](std::string_view line) { lines_.emplace_back(line); }};
};

TEST(RecordingName, ConsistsOfTimeRoundAndTitle) {
  EXPECT_EQ(recordingName(kTime, 3, "First steps"), "20261121T180501Z-round-0003-first-steps");
  EXPECT_EQ(recordingName(kTime, 12345, ""), "20261121T180501Z-round-12345");
  EXPECT_EQ(recordingName(kTime, 1, "../ß \"x/y\"!"), "20261121T180501Z-round-0001-x-y");
  EXPECT_EQ(recordingName(kTime, 1, std::string(100, 'A')).size(), 68u);
}

TEST_F(RecordingFolderTest, WritesAFileForEachRound) {
  RecordingFolder folder(folder_);
  EXPECT_TRUE(names().empty());
  folder.write({1, "One", 60, false, {'a', 'b'}}, kTime, log_);
  EXPECT_EQ(content("20261121T180501Z-round-0001-one.recording"), "ab");  // before the round ends
  folder.write({1, "One", 70, true, {'c'}}, kTime + std::chrono::seconds(2), log_);
  folder.write({2, "Two", 60, false, {'d'}}, kTime + std::chrono::seconds(3), log_);
  EXPECT_EQ(names(), (std::vector<std::string>{"20261121T180501Z-round-0001-one.recording",
                                               "20261121T180504Z-round-0002-two.recording"}));
  EXPECT_EQ(content(names()[0]), "abc");
  const std::string path = (folder_ / names()[0]).string();
  EXPECT_EQ(lines_, (std::vector<std::string>{"recording finished file=\"" + path + "\" ticks=70 bytes=3"}));
}

TEST_F(RecordingFolderTest, NeverOverwritesAFile) {
  for (const char letter : {'a', 'b', 'c'}) {
    const auto byte = static_cast<std::uint8_t>(letter);
    RecordingFolder(folder_).write({1, "", 1, true, {byte}}, kTime, log_);
  }
  ASSERT_EQ(names().size(), 3u);
  EXPECT_EQ(content("20261121T180501Z-round-0001.recording"), "a");
  EXPECT_EQ(content("20261121T180501Z-round-0001-2.recording"), "b");
  EXPECT_EQ(content("20261121T180501Z-round-0001-3.recording"), "c");
}

TEST_F(RecordingFolderTest, RefusesAFolderThatIsNotWritable) {
  writeText(folder_, "a file");
  try {
    RecordingFolder folder(folder_ / "games");
    FAIL();
  } catch (const ProgramError& error) {
    EXPECT_EQ(error.exitCode(), ProgramError::kUsage);
    EXPECT_EQ(error.what(), "cannot write recordings to '" + (folder_ / "games").string() +
                                "': Not a directory; name another folder after --record");
  }
}

// Simulates a full disk by a limit on the size of files.
TEST_F(RecordingFolderTest, LogsAFailedWriteOnceAndRecordsTheNextRound) {
  RecordingFolder folder(folder_);
  folder.write({1, "", 60, false, {1, 2, 3}}, kTime, log_);
  const auto before = std::signal(SIGXFSZ, SIG_IGN);
  rlimit limit{};
  getrlimit(RLIMIT_FSIZE, &limit);
  const rlimit small{2, limit.rlim_max};
  setrlimit(RLIMIT_FSIZE, &small);
  folder.write({1, "", 120, false, {4, 5, 6}}, kTime, log_);
  setrlimit(RLIMIT_FSIZE, &limit);
  std::signal(SIGXFSZ, before);
  folder.write({1, "", 180, false, {7}}, kTime, log_);
  folder.write({1, "", 190, true, {8}}, kTime, log_);
  EXPECT_EQ(content("20261121T180501Z-round-0001.recording"), std::string("\1\2\3"));
  ASSERT_EQ(lines_.size(), 1u);
  EXPECT_TRUE(lines_[0].starts_with("recording stopped file=")) << lines_[0];
  EXPECT_TRUE(lines_[0].ends_with("reason=\"File too large\"")) << lines_[0];
  folder.write({2, "", 1, true, {9}}, kTime, log_);
  EXPECT_EQ(content("20261121T180501Z-round-0002.recording"), std::string("\t"));
  EXPECT_EQ(lines_.size(), 2u);
}

TEST_F(RecordingFolderTest, LogsOnceThatAFileCannotBeCreated) {
  RecordingFolder folder(folder_);
  fs::remove_all(folder_);
  folder.write({1, "", 60, false, {1}}, kTime, log_);
  folder.write({1, "", 120, false, {2}}, kTime, log_);
  ASSERT_EQ(lines_.size(), 1u);
  EXPECT_TRUE(lines_[0].ends_with("reason=\"No such file or directory\"")) << lines_[0];
}

}  // namespace
}  // namespace platon
