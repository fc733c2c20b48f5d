#include "protocol/files/text_file.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>
#include <fstream>

#include "tests/support/files.h"
#include "tests/support/temporary_folder.h"

namespace platon::text_file_test {
namespace {

namespace fs = std::filesystem;

// The mask of access rights of this program while this lives.
class Umask {
 public:
  explicit Umask(mode_t mask) : before_(umask(mask)) {}
  ~Umask() { umask(before_); }
  Umask(const Umask&) = delete;
  Umask& operator=(const Umask&) = delete;

 private:
  mode_t before_;
};

class TextFileTest : public testing::Test {
 protected:
  std::size_t filesInFolder() const {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder_.path()), fs::directory_iterator()));
  }

  mode_t rights() const {
    struct stat status {};
    EXPECT_EQ(stat(path_.c_str(), &status), 0);
    return status.st_mode & 0777u;
  }

  const TemporaryFolder folder_;
  const std::string path_ = folder_ / "file";
};

TEST_F(TextFileTest, ReadsAFile) {
  writeText(path_, "one\ntwo");
  EXPECT_EQ(std::get<std::string>(readTextFile(path_, 100)), "one\ntwo");
  writeText(path_, "");
  EXPECT_EQ(std::get<std::string>(readTextFile(path_, 100)), "");
}

TEST_F(TextFileTest, ReadsAtMostOneByteMoreThanAllowed) {
  writeText(path_, "abcdef");
  EXPECT_EQ(std::get<std::string>(readTextFile(path_, 6)), "abcdef");
  EXPECT_EQ(std::get<std::string>(readTextFile(path_, 3)), "abcd");
}

TEST_F(TextFileTest, SaysWhyAFileCannotBeRead) {
  EXPECT_EQ(std::get<ParseError>(readTextFile(path_, 1)).what, "No such file or directory");
  EXPECT_EQ(std::get<ParseError>(readTextFile(folder_.path(), 1)).what, "Is a directory");
}

TEST_F(TextFileTest, ReplacesTheContent) {
  EXPECT_EQ(replaceTextFile(path_, "new"), "");
  EXPECT_EQ(readText(path_), "new");
  EXPECT_EQ(replaceTextFile(path_, ""), "");
  EXPECT_EQ(readText(path_), "");
  EXPECT_EQ(filesInFolder(), 1u);
}

TEST_F(TextFileTest, TheLongestNameOfAFileIsReplacedToo) {
  const std::string longest = folder_ / std::string(255, 'n');
  EXPECT_EQ(replaceTextFile(longest, "new"), "");
  EXPECT_EQ(replaceTextFile(longest, "newer"), "");
  EXPECT_EQ(readText(longest), "newer");
  EXPECT_EQ(filesInFolder(), 1u);
}

TEST_F(TextFileTest, KeepsTheAccessRights) {
  writeText(path_, "old");
  for (const mode_t mode : {0640u, 0600u, 0664u}) {
    ASSERT_EQ(chmod(path_.c_str(), mode), 0);
    EXPECT_EQ(replaceTextFile(path_, "new"), "");
    EXPECT_EQ(rights(), mode);
    EXPECT_EQ(replacePublicFile(path_, "newer"), "");
    EXPECT_EQ(rights(), mode);
  }
}

TEST_F(TextFileTest, OnlyAPublicFileCanBeReadByOthersWhenItIsNew) {
  for (const mode_t mask : {0022u, 0077u, 0000u}) {
    const Umask umask(mask);
    fs::remove(path_);
    EXPECT_EQ(replacePublicFile(path_, "list"), "");
    EXPECT_EQ(rights(), 0644u) << mask;
    fs::remove(path_);
    EXPECT_EQ(replaceOutputFile(path_, "picture"), "");
    EXPECT_EQ(rights(), 0644u) << mask;
    fs::remove(path_);
    EXPECT_EQ(replaceTextFile(path_, "mine"), "");
    EXPECT_EQ(rights(), 0600u) << mask;
  }
}

TEST_F(TextFileTest, KeepsASymbolicLink) {
  writeText(path_, "old");
  fs::create_symlink(path_, folder_ / "link");
  EXPECT_EQ(replaceTextFile(folder_ / "link", "new"), "");
  EXPECT_TRUE(fs::is_symlink(folder_ / "link"));
  EXPECT_EQ(readText(path_), "new");
}

// Who has the file open reads the old content to its end.
TEST_F(TextFileTest, AReaderNeverSeesAPartOfTheNewContent) {
  writeText(path_, "old");
  std::ifstream reader(path_);
  EXPECT_EQ(replaceTextFile(path_, "brand new"), "");
  std::string line;
  std::getline(reader, line);
  EXPECT_EQ(line, "old");
}

TEST_F(TextFileTest, ACachedFileIsReplacedByARenameToo) {
  writeText(path_, "old");
  std::ifstream reader(path_);
  EXPECT_EQ(replaceCachedFile(path_, "brand new"), "");
  std::string line;
  std::getline(reader, line);
  EXPECT_EQ(line, "old");
  EXPECT_EQ(readText(path_), "brand new");
  EXPECT_EQ(replaceCachedFile(folder_ / "missing/file", "new"), "No such file or directory");
  EXPECT_EQ(filesInFolder(), 1u);
}

TEST_F(TextFileTest, AContentInPiecesReplacesTheFileAtItsEnd) {
  writeText(path_, "old");
  {
    FileReplacement replacement(path_);
    replacement.write("brand ");
    replacement.write("new");
    EXPECT_EQ(readText(path_), "old");
    EXPECT_EQ(replacement.finish(), "");
    EXPECT_EQ(readText(path_), "brand new");
  }
  { FileReplacement(path_).write("given up"); }
  EXPECT_EQ(readText(path_), "brand new");
  EXPECT_EQ(filesInFolder(), 1u);
  FileReplacement failed(folder_ / "missing/file");
  EXPECT_EQ(failed.fault(), "No such file or directory");
  failed.write("new");
  EXPECT_EQ(failed.finish(), "No such file or directory");
}

TEST_F(TextFileTest, OnFailureTheFileIsAsBeforeAndNothingIsLeft) {
  EXPECT_EQ(replaceTextFile(folder_ / "missing/file", "new"), "No such file or directory");
  fs::create_directory(folder_ / "sub");
  EXPECT_EQ(replaceTextFile(folder_ / "sub", "new"), "Is a directory");
  EXPECT_EQ(filesInFolder(), 1u);
}

TEST_F(TextFileTest, WhatIsNoRegularFileIsNeitherReadNorReplaced) {
  ASSERT_EQ(mkfifo(path_.c_str(), 0600), 0);
  EXPECT_EQ(std::get<ParseError>(readTextFile(path_, 100)).what, "it is a pipe, not a regular file");
  EXPECT_EQ(replaceTextFile(path_, "new"), "it is a pipe, not a regular file");
  EXPECT_TRUE(fs::is_fifo(path_));
  const std::string link = folder_ / "link";
  fs::create_symlink("/dev/zero", link);
  EXPECT_EQ(std::get<ParseError>(readTextFile(link, 100)).what, "it is a device, not a regular file");
}

}  // namespace
}  // namespace platon::text_file_test
