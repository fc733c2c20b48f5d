#include "protocol/files/regular_file.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <array>
#include <filesystem>
#include <thread>

#include "tests/support/files.h"
#include "tests/support/temporary_folder.h"

namespace platon::regular_file_test {
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

}  // namespace
}  // namespace platon::regular_file_test
