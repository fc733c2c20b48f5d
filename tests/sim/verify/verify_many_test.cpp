#include "tests/sim/verify/verify_many.h"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/file.h>
#include <unistd.h>

#include <filesystem>

#include "tests/sim/command_testing.h"
#include "tests/sim/sim_options.h"

namespace platon::sim::verify_many_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

class VerifyManyTest : public testing::Test {
 protected:
  void SetUp() override {
    std::filesystem::create_directories(folder_ + "/b");
    good_ = readText(recordedFile());
  }

  std::string add(const std::string& name, const std::string& bytes) const {
    writeText(folder_ + "/" + name, bytes);
    return folder_ + "/" + name;
  }

  VerifySummary verify(unsigned jobs) {
    faults_.clear();
    counted_.clear();
    return verifyMany(
        recordingsAmong({folder_}), jobs, [this](const std::string& fault) { faults_.push_back(fault); },
        [this](std::size_t count) { counted_.push_back(count); });
  }

  TemporaryFolder temporary_;
  std::string folder_ = temporary_ / "recordings";
  std::string good_;
  std::vector<std::string> faults_;
  std::vector<std::size_t> counted_;
};

TEST_F(VerifyManyTest, FindsRecordingsByTheirNamesInOrder) {
  const std::string second = add("b/2.recording", good_);
  const std::string first = add("a.recording", good_);
  const std::string other = add("notes.txt", "");
  EXPECT_THAT(recordingsAmong({folder_}), ElementsAre(first, second));
  EXPECT_THAT(recordingsAmong({other, folder_}), ElementsAre(other, first, second)) << "a file is taken as it is";
  EXPECT_THROW(recordingsAmong({folder_ + "/none"}), UsageError);
}

TEST_F(VerifyManyTest, AFolderWithoutRecordingsIsNoProof) {
  try {
    recordingsAmong({folder_});
    FAIL() << "no error";
  } catch (const UsageError& error) {
    EXPECT_EQ(error.what(), "no file in '" + folder_ + "' is named like a recording: NAME.recording");
  }
}

TEST_F(VerifyManyTest, CountsTheSameWithAnyNumberOfJobs) {
  for (int i = 0; i < 20; ++i) add("good" + std::to_string(i) + ".recording", good_);
  const std::string cut = add("cut.recording", good_.substr(0, good_.size() - 100));
  const std::string other = add("x.recording", differingRecording());
  for (const unsigned jobs : {1u, 2u, 7u, kMaxJobs}) {
    SCOPED_TRACE(jobs);
    const VerifySummary summary = verify(jobs);
    EXPECT_EQ(summary.recordings, 22u);
    EXPECT_EQ(summary.agree, 20u);
    EXPECT_EQ(summary.differ, 1u);
    EXPECT_EQ(summary.invalid, 1u);
    EXPECT_EQ(summary.skipped, 0u);
    EXPECT_EQ(summary.ticks, 21 * 300 + 20u);
    EXPECT_EQ(summary.jobs, jobs);
    EXPECT_EQ(summary.exitCode(), 1);
    EXPECT_GT(summary.timesRealTime(), 0);
    ASSERT_EQ(counted_.size(), 22u);
    for (std::size_t i = 0; i < counted_.size(); ++i) EXPECT_EQ(counted_[i], i + 1);
    ASSERT_THAT(faults_, ElementsAre(HasSubstr(cut + ": byte "), HasSubstr(other + ": desync at tick 20")));
  }
}

TEST_F(VerifyManyTest, LeavesOutWhatAServerIsWriting) {
  const std::string writing = add("a.recording", good_.substr(0, good_.size() / 2));
  add("b.recording", good_);
  const int server = ::open(writing.c_str(), O_RDONLY | O_CLOEXEC);
  ASSERT_EQ(flock(server, LOCK_EX | LOCK_NB), 0);
  const VerifySummary busy = verify(2);
  ::close(server);
  EXPECT_EQ(busy.skipped, 1u);
  EXPECT_EQ(busy.agree, 1u);
  EXPECT_EQ(busy.exitCode(), 0);
  EXPECT_TRUE(faults_.empty());
  EXPECT_EQ(verify(2).exitCode(), 3) << "a server that is gone leaves it cut off";
}

TEST_F(VerifyManyTest, LeavesOutWhatWasRemovedMeanwhile) {
  const std::string path = add("a.recording", good_);
  const std::vector<std::string> recordings = recordingsAmong({folder_});
  std::filesystem::remove(path);
  EXPECT_EQ(verifyMany(
                recordings, 1, [](const std::string&) { FAIL(); }, [](std::size_t) {})
                .skipped,
            1u);
}

TEST_F(VerifyManyTest, TheProgramPrintsASummary) {
  add("a.recording", good_);
  add("b/b.recording", good_);
  EXPECT_THAT(outputOf(verifyCommand, {folder_, "--jobs", "2", "--json"}),
              testing::MatchesRegex("\\{\"recordings\":2,\"agree\":2,\"differ\":0,\"invalid\":0,\"skipped\":0,"
                                    "\"ticks\":600,\"seconds\":[0-9.]+,\"jobs\":2,\"recordingsPerHourAndJob\":[0-9]+,"
                                    "\"timesRealTimePerJob\":[0-9]+\\}\n"));
  EXPECT_THAT(outputOf(verifyCommand, {folder_}), testing::StartsWith("recordings 2\nagree 2\n"));
  EXPECT_THROW(verifyCommand({folder_, "--from", "20"}), UsageError);
  EXPECT_THROW(verifyCommand({folder_, "--jobs", "0"}), UsageError);
}

}  // namespace
}  // namespace platon::sim::verify_many_test
