#include "client/gl/screenshot_writer.h"

#include <filesystem>
#include <optional>
#include <string>

#include <gtest/gtest.h>

#include "tests/protocol/work/held_threads.h"
#include "tests/protocol/work/no_thread.h"
#include "tests/support/files.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/wait_until.h"

namespace platon::screenshot_writer_test {
namespace {

const Image kPicture{2, 1, {255, 0, 0, 0, 0, 255}};

TEST(ScreenshotWriter, ReplacesNoFile) {
  const TemporaryFolder folder;
  {
    ScreenshotWriter writer(folder / "made");
    writer.write(kPicture);
    writer.write(kPicture);
  }
  EXPECT_EQ(readText(folder / "made/platon-0001.png").substr(0, 4), "\x89PNG");
  EXPECT_TRUE(std::filesystem::exists(folder / "made/platon-0002.png"));
}

TEST(ScreenshotWriter, SaysWhereThePictureIsOrThatItWasNotSaved) {
  const TemporaryFolder folder;
  writeText(folder / "file", "");
  for (const bool possible : {true, false}) {
    ScreenshotWriter writer(folder / (possible ? "made" : "file/made"));
    writer.write(kPicture);
    std::optional<std::string> report;
    ASSERT_TRUE(waitUntil([&] { return (report = writer.takeReport()).has_value(); }));
    EXPECT_EQ(report->substr(0, 13), possible ? "picture saved" : "the picture w");
    EXPECT_FALSE(writer.takeReport());
  }
}

TEST(ScreenshotWriter, DoesNotWaitForThePictureBefore) {
  const TemporaryFolder folder;
  HeldThreads threads;
  threads.hold();
  ScreenshotWriter writer(folder / "made", threads.start());
  writer.write(kPicture);
  for (std::size_t i = 0; i < ScreenshotWriter::kMaxWaiting; ++i) writer.write(kPicture);
  EXPECT_FALSE(writer.takeReport());
  writer.write(kPicture);
  EXPECT_EQ(writer.takeReport(), "the picture was not saved: too many at once");
  EXPECT_FALSE(std::filesystem::exists(folder / "made"));
  threads.letGo();
  for (int number = 1; number <= 1 + static_cast<int>(ScreenshotWriter::kMaxWaiting); ++number) {
    std::optional<std::string> report;
    ASSERT_TRUE(waitUntil([&] { return (report = writer.takeReport()).has_value(); }));
    EXPECT_EQ(*report, "picture saved: " + (folder / ("made/platon-000" + std::to_string(number) + ".png")).string());
  }
}

TEST(ScreenshotWriter, WithoutAThreadThePictureIsWrittenAtOnce) {
  const TemporaryFolder folder;
  ScreenshotWriter writer(folder / "made", noThread);
  writer.write(kPicture);
  EXPECT_EQ(writer.takeReport(), "picture saved: " + (folder / "made/platon-0001.png").string());
}

}  // namespace
}  // namespace platon::screenshot_writer_test
