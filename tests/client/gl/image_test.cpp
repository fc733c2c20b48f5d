#include "client/gl/image.h"

#include <stdexcept>
#include <string>

#include <gtest/gtest.h>
#include <stb/stb_image.h>
#include <sys/stat.h>

#include "tests/support/files.h"
#include "tests/support/resource_limit.h"
#include "tests/support/temporary_folder.h"

namespace platon::image_test {
namespace {

TEST(Image, FlipRowsReversesTheRows) {
  Image image{1, 3, {1, 1, 1, 2, 2, 2, 3, 3, 3}};
  flipRows(image);
  EXPECT_EQ(image.pixels, (std::vector<std::uint8_t>{3, 3, 3, 2, 2, 2, 1, 1, 1}));
}

TEST(Image, AWrittenPngIsReadBack) {
  const Image image{2, 2, {255, 0, 0, 0, 255, 0, 0, 0, 255, 9, 8, 7}};
  const TemporaryFolder folder;
  const std::string file = folder / "image.png";
  writePng(image, file);
  int width = 0;
  int height = 0;
  int parts = 0;
  unsigned char* pixels = stbi_load(file.c_str(), &width, &height, &parts, 3);
  ASSERT_NE(pixels, nullptr);
  EXPECT_EQ(width, 2);
  EXPECT_EQ(height, 2);
  EXPECT_EQ(std::vector<std::uint8_t>(pixels, pixels + 12), image.pixels);
  stbi_image_free(pixels);
}

TEST(Image, OnAFullDiskThePictureBeforeRemainsAndTheErrorIsNamed) {
  const TemporaryFolder folder;
  const std::string file = folder / "image.png";
  writeText(file, "before");
  const FullDisk full(10);
  try {
    writePng(Image{1, 1, {1, 2, 3}}, file);
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_EQ(error.what(), "cannot write the picture " + file + ": File too large");
  }
  EXPECT_EQ(readText(file), "before");
}

TEST(Image, APictureIsWrittenIntoNoPipe) {
  const TemporaryFolder folder;
  const std::string file = folder / "image.png";
  ASSERT_EQ(mkfifo(file.c_str(), 0600), 0);
  EXPECT_THROW(writePng(Image{1, 1, {1, 2, 3}}, file), std::runtime_error);
}

TEST(Image, AnUnwritableFileIsAnError) {
  EXPECT_THROW(writePng(Image{1, 1, {1, 2, 3}}, TemporaryFolder() / "no_such_folder/picture.png"), std::runtime_error);
}

}  // namespace
}  // namespace platon::image_test
