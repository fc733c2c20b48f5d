#include "server/app/recording_writer.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <future>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "protocol/program_error.h"
#include "tests/support/files.h"
#include "tests/support/resource_limit.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/wait_until.h"

namespace platon::recording_writer_test {
namespace {

namespace fs = std::filesystem;
using Kind = RecordingEvent::Kind;

constexpr RecordingFolder::Time kTime{std::chrono::seconds(1795284301)};  // 2026-11-21 18:05:01 UTC
constexpr std::uint64_t kNoLimit = UINT64_MAX;

std::vector<std::uint8_t> bytes(std::size_t count) { return std::vector<std::uint8_t>(count, 'x'); }

class RecordingFolderTest : public testing::Test {
 protected:
  std::vector<std::string> names() const {
    std::vector<std::string> found;
    for (const auto& entry : fs::directory_iterator(folder_)) found.push_back(entry.path().filename().string());
    std::sort(found.begin(), found.end());
    return found;
  }
  std::string content(const std::string& name) const { return readText(folder_ / name); }
  std::string pathOf(const std::string& name) const { return (folder_ / name).string(); }

  // What happens when a piece is written.
  std::vector<RecordingEvent> write(RecordingFolder& folder, const RecordingPiece& piece,
                                    RecordingFolder::Time now = kTime) {
    std::vector<RecordingEvent> events;
    folder.write(piece, now, events);
    return events;
  }

  // A finished recording of another day.
  void putOld(int day, std::size_t size) {
    fs::create_directories(folder_);
    writeText(folder_ / oldName(day), std::string(size, 'o'));
  }
  static std::string oldName(int day) { return "2026110" + std::to_string(day) + "T120000Z-round-0001-old.recording"; }

  const TemporaryFolder temporary_;
  const fs::path folder_ = temporary_ / "deep";
};

TEST(RecordingName, ConsistsOfTimeRoundAndTitle) {
  EXPECT_EQ(recordingName(kTime, 3, "First steps"), "20261121T180501Z-round-0003-first-steps");
  EXPECT_EQ(recordingName(kTime, 12345, ""), "20261121T180501Z-round-12345");
  EXPECT_EQ(recordingName(kTime, 1, "../ß \"x/y\"!"), "20261121T180501Z-round-0001-x-y");
  EXPECT_EQ(recordingName(kTime, 1, std::string(100, 'A')).size(), 68u);
}

TEST(RecordingName, IsRecognised) {
  for (const char* title : {"First steps", "", "../ß \"x/y\"!", "2", "Z-round-1"}) {
    EXPECT_TRUE(isRecordingName(recordingName(kTime, 3, title) + ".recording")) << title;
    EXPECT_TRUE(isRecordingName(recordingName(kTime, 3, title) + "-2.recording")) << title;
  }
  for (const char* name :
       {"", "x", ".recording", "20261121T180501Z-round-0003", "20261121T180501Z-round-0003.recording.bak",
        "20261121T180501Z-round-003.recording", "20261121T18050Z-round-0003.recording",
        "2026112T180501Z-round-0003.recording", "20261121T180501-round-0003.recording",
        "20261121T180501Z-round-0003 mine.recording", "20261121T180501Z-round-0003-Mine.recording",
        "my-20261121T180501Z-round-0003.recording", "20261121T180501Z-round-0003.Recording"}) {
    EXPECT_FALSE(isRecordingName(name)) << name;
  }
}

TEST_F(RecordingFolderTest, WritesAFileForEachRound) {
  RecordingFolder folder(folder_, kNoLimit);
  EXPECT_TRUE(names().empty());
  EXPECT_TRUE(write(folder, {1, "One", 60, false, {'a', 'b'}}, kTime + std::chrono::seconds(1)).empty());
  EXPECT_EQ(content("20261121T180501Z-round-0001-one.recording"), "ab");  // before the round ends
  const auto events = write(folder, {1, "One", 70, true, {'c'}}, kTime + std::chrono::seconds(2));
  EXPECT_TRUE(write(folder, {2, "Two", 300, false, {'d'}}, kTime + std::chrono::seconds(8)).empty());
  EXPECT_EQ(names(), (std::vector<std::string>{"20261121T180501Z-round-0001-one.recording",
                                               "20261121T180504Z-round-0002-two.recording"}))
      << "named after the beginning of the round";
  EXPECT_EQ(content(names()[0]), "abc");
  EXPECT_EQ(events, (std::vector<RecordingEvent>{{Kind::kFinished, pathOf(names()[0]), 70, 3, ""}}));
}

TEST_F(RecordingFolderTest, NeverOverwritesAFile) {
  for (const char letter : {'a', 'b', 'c'}) {
    RecordingFolder folder(folder_, kNoLimit);
    write(folder, {1, "", 1, true, {static_cast<std::uint8_t>(letter)}});
  }
  ASSERT_EQ(names().size(), 3u);
  EXPECT_EQ(content("20261121T180501Z-round-0001.recording"), "a");
  EXPECT_EQ(content("20261121T180501Z-round-0001-2.recording"), "b");
  EXPECT_EQ(content("20261121T180501Z-round-0001-3.recording"), "c");
}

// The clock may be set back or forward at any time.
TEST_F(RecordingFolderTest, AClockThatJumpsChangesOnlyNames) {
  RecordingFolder folder(folder_, kNoLimit);
  write(folder, {1, "", 60, false, {'a'}}, kTime);
  write(folder, {1, "", 120, true, {'b'}}, kTime - std::chrono::hours(24));
  write(folder, {2, "", 60, true, {'c'}}, kTime - std::chrono::hours(24));
  write(folder, {3, "", 60, true, {'d'}}, RecordingFolder::Time{});
  ASSERT_EQ(names().size(), 3u);
  EXPECT_EQ(content("20261121T180500Z-round-0001.recording"), "ab");
  EXPECT_EQ(content("20261120T180500Z-round-0002.recording"), "c");
  EXPECT_EQ(content("19691231T235959Z-round-0003.recording"), "d");
}

TEST_F(RecordingFolderTest, RefusesAFolderThatIsNotWritable) {
  writeText(folder_, "a file");
  try {
    RecordingFolder folder(folder_ / "games", kNoLimit);
    FAIL();
  } catch (const ProgramError& error) {
    EXPECT_EQ(error.exitCode(), ProgramError::kUsage);
    EXPECT_EQ(error.what(), "cannot write recordings to '" + (folder_ / "games").string() +
                                "': the folder cannot be created: Not a directory; name another folder after --record");
  }
}

TEST_F(RecordingFolderTest, AFullDiskStopsTheRecordingOfOneRound) {
  RecordingFolder folder(folder_, kNoLimit);
  write(folder, {1, "", 0, false, bytes(100)});
  {
    const FullDisk disk(150);
    EXPECT_EQ(write(folder, {1, "", 60, false, bytes(100)}),
              (std::vector<RecordingEvent>{
                  {Kind::kStopped, pathOf("20261121T180501Z-round-0001.recording"), 0, 0, "File too large"}}));
    EXPECT_TRUE(write(folder, {1, "", 120, false, bytes(1)}).empty()) << "it is said once";
    EXPECT_EQ(write(folder, {2, "", 0, false, bytes(200)}).size(), 1u);
  }
  EXPECT_TRUE(write(folder, {2, "", 60, true, bytes(1)}).empty());
  EXPECT_EQ(names(), (std::vector<std::string>{"20261121T180501Z-round-0001.recording"})) << "nothing of round 2";
  EXPECT_EQ(content(names()[0]), std::string(100, 'x')) << "whole pieces only";
  EXPECT_EQ(write(folder, {3, "", 0, true, bytes(200)}).at(0).kind, Kind::kFinished);
}

TEST_F(RecordingFolderTest, AFileThatCannotBeOpenedStopsTheRecordingOfOneRound) {
  RecordingFolder folder(folder_, kNoLimit);
  {
    const ResourceLimit descriptors(RLIMIT_NOFILE, 0);
    const auto events = write(folder, {1, "", 0, false, bytes(10)});
    ASSERT_EQ(events.size(), 1u);
    EXPECT_EQ(events[0].kind, Kind::kStopped);
    EXPECT_EQ(events[0].reason, "Too many open files");
    EXPECT_TRUE(write(folder, {1, "", 60, false, bytes(10)}).empty());
  }
  EXPECT_TRUE(write(folder, {1, "", 120, true, bytes(10)}).empty());
  EXPECT_EQ(write(folder, {2, "", 0, true, bytes(10)}).at(0).kind, Kind::kFinished);
  fs::remove_all(folder_);
  EXPECT_EQ(write(folder, {3, "", 0, true, bytes(10)}).at(0).reason, "No such file or directory");
}

TEST_F(RecordingFolderTest, TheOldestRecordingsMakeRoomForNewOnes) {
  for (const int day : {3, 1, 2}) putOld(day, 100);
  RecordingFolder folder(folder_, 350);
  EXPECT_TRUE(write(folder, {1, "", 0, false, bytes(50)}).empty()) << "it fits exactly";
  EXPECT_EQ(write(folder, {1, "", 60, false, bytes(1)}),
            (std::vector<RecordingEvent>{{Kind::kRemoved, pathOf(oldName(1)), 0, 100, ""}}));
  EXPECT_TRUE(write(folder, {1, "", 120, false, bytes(90)}).empty());
  const auto events = write(folder, {1, "", 180, true, bytes(200)});
  ASSERT_EQ(events.size(), 3u);
  EXPECT_EQ(events[0].file, pathOf(oldName(2)));
  EXPECT_EQ(events[1].file, pathOf(oldName(3)));
  EXPECT_EQ(events[2].kind, Kind::kFinished);
  EXPECT_EQ(names(), (std::vector<std::string>{"20261121T180501Z-round-0001.recording"}));
}

TEST_F(RecordingFolderTest, ARecordingThatIsLargerThanTheLimitIsStopped) {
  putOld(1, 100);
  RecordingFolder folder(folder_, 300);
  write(folder, {1, "", 0, false, bytes(250)});
  const auto events = write(folder, {1, "", 60, false, bytes(51)});
  ASSERT_EQ(events.size(), 1u);
  EXPECT_EQ(events[0].kind, Kind::kStopped);
  EXPECT_EQ(events[0].reason, "the limit of 300 bytes for recordings is reached; raise --record-limit");
  EXPECT_EQ(names(), (std::vector<std::string>{"20261121T180501Z-round-0001.recording"}));
  const auto next = write(folder, {2, "", 60, true, bytes(60)});
  ASSERT_EQ(next.size(), 2u);
  EXPECT_EQ(next[0].kind, Kind::kRemoved) << "the finished part of round 1";
  EXPECT_EQ(next[1].kind, Kind::kFinished);
}

TEST_F(RecordingFolderTest, OtherFilesAreNeitherCountedNorRemoved) {
  putOld(1, 100);
  const std::vector<std::string> others = {"notes.txt", "my-" + oldName(1), oldName(2) + ".bak", "Round.recording"};
  for (const std::string& name : others) writeText(folder_ / name, std::string(1000, 'n'));
  fs::create_directory(folder_ / oldName(3));
  writeText(temporary_ / "target", std::string(1000, 't'));
  fs::create_symlink(temporary_ / "target", folder_ / oldName(4));
  RecordingFolder folder(folder_, 150);
  EXPECT_EQ(write(folder, {1, "", 0, true, bytes(60)}).size(), 2u);
  EXPECT_FALSE(fs::exists(folder_ / oldName(1)));
  for (const std::string& name : others) EXPECT_TRUE(fs::exists(folder_ / name)) << name;
  EXPECT_TRUE(fs::exists(folder_ / oldName(3)));
  EXPECT_TRUE(fs::exists(folder_ / oldName(4)));
  EXPECT_TRUE(fs::exists(temporary_ / "target"));
}

TEST_F(RecordingFolderTest, AFileThatAServerIsWritingIsNotRemoved) {
  RecordingFolder other(folder_, kNoLimit);
  write(other, {7, "other", 0, false, bytes(100)}, kTime - std::chrono::hours(1));
  putOld(1, 100);
  RecordingFolder folder(folder_, 150);
  const auto events = write(folder, {1, "", 0, false, bytes(60)});
  ASSERT_EQ(events.size(), 2u);
  EXPECT_EQ(events[0].file, pathOf(oldName(1)));
  EXPECT_EQ(events[1].kind, Kind::kStopped);
  write(other, {7, "other", 60, true, bytes(1)}, kTime);
  EXPECT_EQ(write(folder, {2, "", 0, true, bytes(60)}).at(0).kind, Kind::kRemoved) << "it is finished now";
}

// A folder at its limit is not searched for every piece.
TEST_F(RecordingFolderTest, RemovesAHundredthMoreThanIsNeeded) {
  for (int day = 1; day <= 9; ++day) putOld(day, 1000);
  RecordingFolder folder(folder_, 10000);
  EXPECT_TRUE(write(folder, {1, "", 0, false, bytes(1000)}).empty());
  EXPECT_EQ(write(folder, {1, "", 60, false, bytes(950)}).size(), 2u);
}

// Three servers write at different rates. Each of the two others may have written a hundredth of the limit unseen.
TEST_F(RecordingFolderTest, ServersThatShareAFolderKeepTheLimitTogether) {
  constexpr std::uint64_t kLimit = 10000;
  putOld(1, 5000);
  std::array<RecordingFolder, 3> servers{RecordingFolder(folder_, kLimit), RecordingFolder(folder_, kLimit),
                                         RecordingFolder(folder_, kLimit)};
  std::uint64_t largest = 0;
  for (std::uint32_t i = 0; i < 1000; ++i) {
    const std::uint32_t each = i % 10 == 0 ? 0 : i % 3 == 0 ? 1 : 2;
    write(servers[each], {each + 1, "", 0, false, bytes(20 + each)});
    std::uint64_t total = 0;
    for (const std::string& name : names()) total += fs::file_size(folder_ / name);
    largest = std::max(largest, total);
  }
  EXPECT_FALSE(fs::exists(folder_ / oldName(1)));
  EXPECT_GT(largest, kLimit - kLimit / 100);
  EXPECT_LE(largest, kLimit + 2 * (kLimit / 100));
}

// The server finds out whether it can write by making a file, which is never one of somebody else.
TEST_F(RecordingFolderTest, TheTrialTouchesNoFileOfOthers) {
  fs::create_directories(folder_);
  writeText(temporary_ / "victim", "mine");
  const std::vector<std::string> planted{".platon-trial", ".platon-trial-XXXXXX"};
  for (const std::string& name : planted) fs::create_symlink(temporary_ / "victim", folder_ / name);
  const RecordingFolder first(folder_, kNoLimit);
  EXPECT_EQ(readText(temporary_ / "victim"), "mine");
  EXPECT_EQ(names(), planted);
  fs::remove(folder_ / ".platon-trial");
  writeText(folder_ / ".platon-trial", "notes");
  const RecordingFolder second(folder_, kNoLimit);
  EXPECT_EQ(content(".platon-trial"), "notes");
}

using namespace std::chrono_literals;

constexpr RecordingWriter::Time kWriteTime{1h};

RecordingPiece piece(std::uint32_t round, std::size_t size, std::uint32_t ticks = 60) {
  return {round, "", ticks, false, std::vector<std::uint8_t>(size)};
}

/// Keeps the pieces that are written. While it is locked, it does not answer, as a stuck disk.
class Disk {
 public:
  RecordingWriter::Write write() {
    return
        [state = state_](const RecordingPiece& piece, RecordingWriter::Time now, std::vector<RecordingEvent>& events) {
          const std::lock_guard answers(state->answers);
          const std::lock_guard lock(state->mutex);
          state->pieces.push_back({piece.round, piece.ticks});
          state->threads.push_back(std::this_thread::get_id());
          EXPECT_EQ(now, kWriteTime);
          events.push_back({RecordingEvent::Kind::kFinished, "file", piece.ticks, piece.bytes.size(), ""});
        };
  }
  std::unique_lock<std::mutex> hang() { return std::unique_lock(state_->answers); }

  std::vector<std::pair<std::uint32_t, std::uint32_t>> pieces() const {
    const std::lock_guard lock(state_->mutex);
    return state_->pieces;
  }
  std::vector<std::thread::id> threads() const {
    const std::lock_guard lock(state_->mutex);
    return state_->threads;
  }

 private:
  struct State {
    std::mutex answers;
    std::mutex mutex;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> pieces;
    std::vector<std::thread::id> threads;
  };
  std::shared_ptr<State> state_ = std::make_shared<State>();
};

TEST(RecordingWriter, WritesAllPiecesInOrderFromAnotherThread) {
  Disk disk;
  RecordingWriter writer(disk.write());
  std::vector<std::pair<std::uint32_t, std::uint32_t>> expected;
  for (std::uint32_t i = 0; i < 50; ++i) {
    writer.write(piece(1 + i / 10, 100, i), kWriteTime);
    expected.emplace_back(1 + i / 10, i);
  }
  ASSERT_TRUE(writer.finish());
  EXPECT_EQ(disk.pieces(), expected);
  for (const std::thread::id id : disk.threads()) EXPECT_NE(id, std::this_thread::get_id());
  EXPECT_EQ(writer.takeEvents().size(), 50u);
  EXPECT_TRUE(writer.takeEvents().empty());
}

TEST(RecordingWriter, AStuckDiskDoesNotDelayTheCaller) {
  Disk disk;
  RecordingWriter writer(disk.write());
  auto hanging = disk.hang();
  for (std::uint32_t i = 0; i < 100; ++i) writer.write(piece(1, 1000, i), kWriteTime);  // returns
  EXPECT_FALSE(writer.finish(1ms));
  hanging.unlock();
  EXPECT_TRUE(writer.finish());
  EXPECT_EQ(disk.pieces().size(), 100u);
}

TEST(RecordingWriter, ARoundThatDoesNotFitTheQueueIsDroppedAndTheNextTried) {
  Disk disk;
  RecordingWriter writer(disk.write());
  auto hanging = disk.hang();
  constexpr std::size_t kHalf = RecordingWriter::kQueueBytes / 2;
  writer.write(piece(1, kHalf, 1), kWriteTime);
  writer.write(piece(1, kHalf, 2), kWriteTime);
  EXPECT_TRUE(writer.takeEvents().empty());
  writer.write(piece(1, 1, 3), kWriteTime);
  writer.write(piece(1, 1, 4), kWriteTime);
  const std::vector<RecordingEvent> events = writer.takeEvents();
  ASSERT_EQ(events.size(), 1u) << "it is said once";
  EXPECT_EQ(events[0].kind, RecordingEvent::Kind::kStopped);
  EXPECT_EQ(events[0].reason, "the disk is too slow");
  hanging.unlock();
  ASSERT_TRUE(writer.finish());
  writer.write(piece(1, 1, 5), kWriteTime);
  writer.write(piece(2, 1, 6), kWriteTime);
  ASSERT_TRUE(writer.finish());
  EXPECT_EQ(disk.pieces(), (std::vector<std::pair<std::uint32_t, std::uint32_t>>{{1, 1}, {1, 2}, {2, 6}}));
}

TEST(RecordingWriter, GoesWithoutWaitingForAStuckDisk) {
  Disk disk;
  auto hanging = disk.hang();
  std::promise<void> gone;
  std::thread other([&] {
    {
      RecordingWriter writer(disk.write());
      writer.write(piece(1, 1), kWriteTime);
      EXPECT_FALSE(writer.finish(50ms));
    }
    gone.set_value();
  });
  EXPECT_EQ(gone.get_future().wait_for(60s), std::future_status::ready);
  other.join();
  hanging.unlock();
  EXPECT_TRUE(waitUntil([&disk] { return disk.pieces().size() == 1; })) << "the thread outlives the writer";
}

}  // namespace
}  // namespace platon::recording_writer_test
