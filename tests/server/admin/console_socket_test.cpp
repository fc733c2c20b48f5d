#include "server/admin/console_socket.h"

#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>

#include <filesystem>
#include <optional>

#include "protocol/program_error.h"
#include "server/admin/stream_socket.h"
#include "tests/support/files.h"
#include "tests/support/temporary_folder.h"

namespace platon::console_socket_test {
namespace {

namespace fs = std::filesystem;

class ConsoleSocketTest : public testing::Test {
 protected:
  // The message when the console cannot be opened.
  static std::string errorOf(const std::string& path, int exitCode = ProgramError::kUsage) {
    try {
      const ConsoleSocket socket(path);
      return "none";
    } catch (const ProgramError& error) {
      EXPECT_EQ(error.exitCode(), exitCode);
      return error.what();
    }
  }

  // A socket file to which nobody listens any more, as a killed server leaves it.
  void leaveStaleSocket() const {
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    path_.copy(address.sun_path, path_.size());
    const Descriptor socket(::socket(AF_UNIX, SOCK_STREAM, 0));
    ASSERT_EQ(bind(socket.number(), reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
    ASSERT_EQ(listen(socket.number(), 1), 0);
  }

  const TemporaryFolder folder_ = TemporaryFolder::forSockets();
  const std::string path_ = folder_ / "console.sock";
  const std::string refusal_ = "cannot open the console at '" + path_ + "': ";
};

TEST(ConsolePath, IsInTheFolderOfTheUserOrInTmp) {
  EXPECT_EQ(defaultConsolePath("/run/user/7", 7), "/run/user/7/platon-server.sock");
  EXPECT_EQ(defaultConsolePath(nullptr, 7), "/tmp/platon-server-7.sock");
  EXPECT_EQ(defaultConsolePath("", 7), "/tmp/platon-server-7.sock");
}

TEST_F(ConsoleSocketTest, ListensForItsUserAlone) {
  const ConsoleSocket socket(path_);
  struct stat status {};
  ASSERT_EQ(stat(path_.c_str(), &status), 0);
  EXPECT_TRUE(S_ISSOCK(status.st_mode));
  EXPECT_EQ(status.st_mode & 0777u, 0600u);
  EXPECT_TRUE(connectUnix(path_));
}

TEST_F(ConsoleSocketTest, TheModeDoesNotDependOnTheUmask) {
  const mode_t before = umask(0);
  const ConsoleSocket socket(path_);
  umask(before);
  struct stat status {};
  ASSERT_EQ(stat(path_.c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 0777u, 0600u);
}

TEST_F(ConsoleSocketTest, RemovesItsFileAtTheEnd) {
  std::optional<ConsoleSocket> socket(path_);
  EXPECT_TRUE(fs::exists(path_));
  socket.reset();
  EXPECT_FALSE(fs::exists(path_));
}

TEST_F(ConsoleSocketTest, LeavesAFileThatIsNoLongerItsOwn) {
  {
    const ConsoleSocket socket(path_);
    fs::remove(path_);
    writeText(path_, "of somebody else");
  }
  EXPECT_EQ(readText(path_), "of somebody else");
}

TEST_F(ConsoleSocketTest, ReplacesTheSocketOfAServerThatNoLongerRuns) {
  leaveStaleSocket();
  EXPECT_FALSE(connectUnix(path_));
  const ConsoleSocket socket(path_);
  EXPECT_TRUE(connectUnix(path_));
}

TEST_F(ConsoleSocketTest, RefusesThePathOfARunningServer) {
  const ConsoleSocket first(path_);
  EXPECT_EQ(errorOf(path_, ProgramError::kFailed),
            refusal_ + "another server uses it; name another path after --socket");
  EXPECT_TRUE(connectUnix(path_));
}

TEST_F(ConsoleSocketTest, RefusesAPathWithAnotherKindOfFileAndKeepsIt) {
  writeText(path_, "precious");
  EXPECT_EQ(errorOf(path_), refusal_ + "it is a file of another kind; name another path after --socket");
  EXPECT_EQ(readText(path_), "precious");
}

TEST_F(ConsoleSocketTest, TheCheckOfAPathAcceptsThatOfARunningServerAndOpensNothing) {
  EXPECT_NO_THROW(checkConsolePath(path_));
  EXPECT_FALSE(fs::exists(path_));
  const ConsoleSocket running(path_);
  EXPECT_NO_THROW(checkConsolePath(path_));
  EXPECT_TRUE(connectUnix(path_));
  for (const std::string& path : {std::string(folder_ / "missing/console.sock"), std::string(108, 'x')}) {
    EXPECT_THROW(checkConsolePath(path), ProgramError);
  }
}

TEST_F(ConsoleSocketTest, SaysWhyAPathCannotBeUsed) {
  const std::string missing = folder_ / "missing/console.sock";
  EXPECT_EQ(errorOf(missing), "cannot open the console at '" + missing +
                                  "': No such file or directory; name another path after --socket");
  const std::string tooLong(108, 'x');
  EXPECT_EQ(errorOf(tooLong), "cannot open the console at '" + tooLong +
                                  "': the path has more than 107 bytes; name another path after --socket");
}

}  // namespace
}  // namespace platon::console_socket_test
