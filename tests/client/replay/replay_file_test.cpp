#include "client/replay/replay_file.h"

#include <sys/stat.h>

#include <string>

#include <gtest/gtest.h>

#include "client/replay/recording_facts.h"
#include "client/replay/track_file.h"

#include "tests/support/files.h"
#include "tests/support/temporary_folder.h"

namespace platon::replay_file_test {
namespace {

TEST(ReplayFile, IsRead) {
  const auto replay = readReplay("tests/determinism/golden/hexahedron.recording");
  ASSERT_TRUE(std::holds_alternative<std::shared_ptr<const Replay>>(replay));
  EXPECT_GE(std::get<std::shared_ptr<const Replay>>(replay)->ticks(), 1800U);
}

TEST(ReplayFile, AFaultNamesTheFile) {
  const TemporaryFolder folder;
  const std::string missing = (folder / "missing").string();
  const auto none = readReplay(missing);
  EXPECT_EQ(std::get<std::string>(none), missing + ": cannot be read: No such file or directory");
  const std::string text = (folder / "text").string();
  writeText(text, "no recording");
  const auto other = readReplay(text);
  EXPECT_EQ(std::get<std::string>(other),
            text + ": cannot be played: byte 0: not a recording, or an unsupported version");
}

TEST(ReplayFile, APipeIsNotWaitedFor) {
  const TemporaryFolder folder;
  const std::string pipe = (folder / "pipe").string();
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  EXPECT_EQ(std::get<std::string>(readReplay(pipe)), pipe + ": cannot be read: it is a pipe, not a regular file");
  EXPECT_FALSE(readRecordingHeadOf(pipe));
  EXPECT_EQ(readRecordingFacts(pipe).note, "cannot be read: it is a pipe, not a regular file");
  EXPECT_EQ(std::get<std::string>(readReplay(folder.path())),
            folder.path().string() + ": cannot be read: Is a directory");
}

TEST(ReplayFile, AStopEndsTheReading) {
  std::stop_source stop;
  stop.request_stop();
  const std::filesystem::path file = "levels/data/ways/01_run_and_jump.recording";
  const RecordingBytes read = readRecordingBytes(file, stop.get_token());
  EXPECT_EQ(read.content, "");
  EXPECT_EQ(read.fault, "was not read to its end");
  const std::string fault = file.string() + ": was not read to its end";
  EXPECT_EQ(std::get<std::string>(readReplay(file, stop.get_token())), fault);
  EXPECT_EQ(std::get<std::string>(readTrack(file, nullptr, stop.get_token())), fault);
  EXPECT_FALSE(readRecordingHeadOf(file, stop.get_token()));
}

TEST(ReplayFile, ALargeFileIsReadWhole) {
  const TemporaryFolder folder;
  std::string content(3 * (std::size_t{1} << 20), 'a');
  for (std::size_t i = 0; i < content.size(); i += 1000) content[i] = static_cast<char>('a' + i % 26);
  for (const std::size_t bytes : {content.size(), content.size() - 1, std::size_t{0}}) {
    writeText(folder / "file", content.substr(0, bytes));
    EXPECT_TRUE(readRecordingBytes(folder / "file").content == content.substr(0, bytes)) << bytes;
  }
  std::filesystem::resize_file(folder / "file", Replay::kMaxBytes);
  EXPECT_EQ(readRecordingBytes(folder / "file").content.size(), Replay::kMaxBytes);
  std::filesystem::resize_file(folder / "file", Replay::kMaxBytes + 1);
  EXPECT_EQ(readRecordingBytes(folder / "file").fault, "is larger than any recording that can be played");
}

}  // namespace
}  // namespace platon::replay_file_test
