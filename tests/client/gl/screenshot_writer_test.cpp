#include "client/gl/screenshot_writer.h"

#include <filesystem>

#include <gtest/gtest.h>

#include "tests/support/files.h"
#include "tests/support/temporary_folder.h"

namespace platon {
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
    writer.write(kPicture);  // waits for the one before
    const std::optional<std::string> report = writer.takeReport();
    ASSERT_TRUE(report);
    EXPECT_EQ(report->substr(0, 13), possible ? "picture saved" : "the picture w");
  }
}

}  // namespace
}  // namespace platon
