#include "protocol/files/text_file.h"

#include <fcntl.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <thread>

#include <gtest/gtest.h>

#include "tests/support/files.h"
#include "tests/support/temporary_folder.h"

namespace platon::text_file_test {
namespace {

constexpr const char* kPipeFault = "it is a pipe, not a regular file";
constexpr const char* kDeviceFault = "it is a device, not a regular file";

class RegularFileTest : public testing::Test {
 protected:
  std::string pathOf(const std::string& name) const { return folder_ / name; }
  std::string pipe() const {
    EXPECT_EQ(mkfifo(pathOf("pipe").c_str(), 0600), 0);
    return pathOf("pipe");
  }
  std::string linkTo(const std::string& target) const {
    std::filesystem::create_symlink(target, pathOf("link"));
    return pathOf("link");
  }
  // The first bytes of what was opened.
  static std::string read(const OpenedFile& opened, std::size_t count) {
    std::string bytes(count, '\0');
    bytes.resize(readNext(opened.file, bytes.data(), count).value());
    return bytes;
  }

  const TemporaryFolder folder_ = TemporaryFolder::forSockets();
};

TEST_F(RegularFileTest, OpensARegularFileAlsoThroughALink) {
  writeText(pathOf("file"), "abcdef");
  const OpenedFile opened = openToRead(pathOf("file"));
  EXPECT_EQ(opened.fault, "");
  EXPECT_EQ(read(opened, 4), "abcd");
  EXPECT_EQ(read(opened, 4), "ef");
  EXPECT_EQ(read(opened, 4), "");
  EXPECT_EQ(read(openToRead(linkTo(pathOf("file"))), 9), "abcdef");
}

TEST_F(RegularFileTest, APipeIsRefusedAndNotWaitedFor) {
  const OpenedFile opened = openToRead(pipe());
  EXPECT_FALSE(opened.file);
  EXPECT_EQ(opened.fault, kPipeFault);
  EXPECT_EQ(faultOfKind(pathOf("pipe")), kPipeFault);
}

TEST_F(RegularFileTest, ALinkToADeviceIsRefused) {
  const std::string link = linkTo("/dev/zero");
  for (const Pipes pipes : {Pipes::kRefuse, Pipes::kRead}) EXPECT_EQ(openToRead(link, pipes).fault, kDeviceFault);
  EXPECT_EQ(faultOfKind(link), kDeviceFault);
}

TEST_F(RegularFileTest, ASocketIsRefused) {
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  pathOf("socket").copy(address.sun_path, sizeof address.sun_path - 1);
  const Descriptor socket(::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0));
  ASSERT_EQ(bind(socket.number(), reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
  EXPECT_EQ(openToRead(pathOf("socket")).fault, "it is a socket, not a regular file");
  EXPECT_EQ(faultOfKind(pathOf("socket")), "it is a socket, not a regular file");
}

TEST_F(RegularFileTest, TheReasonOfTheSystemIsKept) {
  EXPECT_EQ(openToRead(pathOf("missing")).fault, "No such file or directory");
  EXPECT_EQ(openToRead(folder_.path()).fault, "Is a directory");
  EXPECT_EQ(faultOfKind(pathOf("missing")), "");
  EXPECT_EQ(faultOfKind(folder_.path().string()), "Is a directory");
}

TEST_F(RegularFileTest, APipeWithoutAWriterIsEmptyWhereItMayBeRead) {
  const OpenedFile opened = openToRead(pipe(), Pipes::kRead);
  EXPECT_EQ(opened.fault, "");
  EXPECT_EQ(read(opened, 4), "");
}

TEST_F(RegularFileTest, APipeIsReadToItsEndWhereItMayBe) {
  std::array<int, 2> ends{};
  ASSERT_EQ(pipe2(ends.data(), O_CLOEXEC), 0);
  const Descriptor output(ends[0]);
  Descriptor input(ends[1]);
  const OpenedFile opened = openToRead("/dev/fd/" + std::to_string(output.number()), Pipes::kRead);
  ASSERT_TRUE(opened.file) << opened.fault;
  std::jthread writer([&input] {
    for (const char byte : std::string("abcdef")) EXPECT_EQ(write(input.number(), &byte, 1), 1);
    input = Descriptor();
  });
  EXPECT_EQ(read(opened, 9), "abcdef");
}

TEST_F(RegularFileTest, AReadThatFailsSaysWhy) {
  writeText(pathOf("file"), "abc");
  const Descriptor file(open(pathOf("file").c_str(), O_WRONLY | O_CLOEXEC));
  std::array<char, 4> bytes{};
  EXPECT_EQ(readNext(file, bytes.data(), bytes.size()), std::nullopt);
  EXPECT_EQ(errno, EBADF);
}

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
    EXPECT_EQ(replaceOutputFile(path_, "newer"), "");
    EXPECT_EQ(rights(), mode);
  }
}

TEST_F(TextFileTest, OnlyAPublicFileCanBeReadByOthersWhenItIsNew) {
  for (const mode_t mask : {0022u, 0077u, 0000u}) {
    const Umask umask(mask);
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
