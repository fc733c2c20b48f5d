#include "server/admin/console_socket.h"

#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <atomic>
#include <filesystem>
#include <optional>
#include <sstream>
#include <thread>
#include <utility>

#include <gtest/gtest.h>

#include "protocol/program_error.h"
#include "server/admin/console.h"
#include "server/admin/stream_socket.h"
#include "tests/support/files.h"
#include "tests/support/temporary_folder.h"

namespace platon::console_socket_test {
namespace {

TEST(LineBuffer, CutsAStreamIntoLines) {
  LineBuffer buffer(10);
  buffer.add("one\ntw");
  EXPECT_TRUE(buffer.ready());
  EXPECT_EQ(buffer.next(), "one");
  EXPECT_FALSE(buffer.ready());
  EXPECT_EQ(buffer.next(), std::nullopt);
  buffer.add("o\r\n\nx\n");
  EXPECT_EQ(buffer.next(), "two");
  EXPECT_EQ(buffer.next(), "");
  EXPECT_EQ(buffer.next(), "x");
  EXPECT_EQ(buffer.next(), std::nullopt);
}

TEST(LineBuffer, ALineMayHaveTheLongestLength) {
  LineBuffer buffer(3);
  buffer.add("abc");
  EXPECT_FALSE(buffer.tooLong());
  buffer.add("\n");
  EXPECT_FALSE(buffer.tooLong());
  EXPECT_EQ(buffer.next(), "abc");
}

TEST(LineBuffer, ALineThatIsTooLongIsReportedBeforeItEnds) {
  LineBuffer buffer(3);
  buffer.add("ab\nabcd");
  EXPECT_FALSE(buffer.tooLong());
  EXPECT_EQ(buffer.next(), "ab");
  EXPECT_TRUE(buffer.tooLong());
  EXPECT_EQ(buffer.next(), std::nullopt);
  buffer.add("\nx\n");
  EXPECT_TRUE(buffer.tooLong());
  EXPECT_FALSE(buffer.ready());
  EXPECT_EQ(buffer.next(), std::nullopt);
}

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
  EXPECT_EQ(errorOf(path_), refusal_ + "it is not a socket; name another path after --socket");
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

using namespace std::chrono_literals;

/// A server that replies to a line with the line, in virtual time. What is sent over a Unix socket is there at once.
class ConsoleServerTest : public testing::Test {
 protected:
  Descriptor connect() { return connectUnix(server_.path()); }

  static void send(const Descriptor& console, std::string bytes) {
    EXPECT_TRUE(sendTo(console, bytes));
    EXPECT_EQ(bytes, "");
  }

  void poll(std::chrono::milliseconds passed = 10ms) {
    now_ += passed;
    server_.poll(now_, [this](std::string_view line) {
      lines_.emplace_back(line);
      return ConsoleReply{true, reply_.empty() ? std::string(line) : reply_};
    });
  }

  std::string pollAndReceive(const Descriptor& console) {
    poll();
    return receiveFrom(console).bytes;
  }

  const TemporaryFolder folder_ = TemporaryFolder::forSockets();
  ConsoleServer server_{folder_ / "console.sock"};
  TimePoint now_{};
  std::vector<std::string> lines_;
  std::string reply_;
};

TEST_F(ConsoleServerTest, RepliesToACommand) {
  const Descriptor console = connect();
  send(console, "status\n");
  EXPECT_EQ(pollAndReceive(console), " status\nok\n");
  send(console, "sta");
  EXPECT_EQ(pollAndReceive(console), "");
  send(console, "tus\r\n");
  EXPECT_EQ(pollAndReceive(console), " status\nok\n");
}

TEST_F(ConsoleServerTest, ExecutesOneCommandOfAConsoleAtATime) {
  const Descriptor console = connect();
  send(console, "a\nb\nc\n");
  EXPECT_EQ(pollAndReceive(console), " a\nok\n");
  EXPECT_EQ(pollAndReceive(console), " b\nok\n");
  EXPECT_EQ(pollAndReceive(console), " c\nok\n");
  poll();
  EXPECT_EQ(lines_.size(), 3u);
}

TEST_F(ConsoleServerTest, ExecutesWhatWasSentBeforeTheConsoleEnded) {
  const Descriptor console = connect();
  send(console, "a\nb\n");
  finishSending(console);
  EXPECT_EQ(pollAndReceive(console), " a\nok\n");
  EXPECT_EQ(pollAndReceive(console), " b\nok\n");
  poll();
  EXPECT_EQ(server_.consoles(), 0u);
}

TEST_F(ConsoleServerTest, ServesSeveralConsoles) {
  const Descriptor one = connect();
  const Descriptor two = connect();
  poll();
  poll();
  EXPECT_EQ(server_.consoles(), 2u);
  send(one, "1\n");
  send(two, "2\n");
  poll();
  EXPECT_EQ(receiveFrom(one).bytes, " 1\nok\n");
  EXPECT_EQ(receiveFrom(two).bytes, " 2\nok\n");
}

TEST_F(ConsoleServerTest, ClosesAConsoleWhoseLineIsTooLong) {
  const Descriptor console = connect();
  send(console, std::string(kMaxConsoleLineBytes, 'x'));
  EXPECT_EQ(pollAndReceive(console), "");
  send(console, "xx");
  EXPECT_EQ(pollAndReceive(console), " the command has more than 512 bytes; the console is closed\nfailed\n");
  EXPECT_TRUE(receiveFrom(console).closed);
  EXPECT_EQ(server_.consoles(), 0u);
  EXPECT_TRUE(lines_.empty());
}

TEST_F(ConsoleServerTest, DropsAConsoleThatDoesNotRead) {
  reply_ = std::string(4 * 1024 * 1024, 'x');  // more than the system takes
  const Descriptor console = connect();
  send(console, "a\nb\n");
  poll();
  poll(ConsoleServer::kReadTime);
  EXPECT_EQ(server_.consoles(), 1u);
  poll();
  EXPECT_EQ(server_.consoles(), 0u);
  EXPECT_EQ(lines_, std::vector<std::string>{"a"});  // no command is executed while a reply waits
}

TEST_F(ConsoleServerTest, AConsoleThatReadsSlowlyGetsEverything) {
  reply_ = std::string(1024 * 1024, 'x');
  const Descriptor console = connect();
  send(console, "a\n");
  std::size_t received = 0;
  for (int i = 0; i < 10'000 && received < reply_.size() + 5; ++i) {
    poll(1s);
    for (int reads = 0; reads < 20; ++reads) received += receiveFrom(console).bytes.size();
  }
  EXPECT_EQ(received, reply_.size() + 5);
  EXPECT_EQ(server_.consoles(), 1u);
}

TEST_F(ConsoleServerTest, AConsoleMayBeSilentForHours) {
  const Descriptor console = connect();
  poll();
  poll(12h);
  EXPECT_EQ(server_.consoles(), 1u);
  send(console, "a\n");
  EXPECT_EQ(pollAndReceive(console), " a\nok\n");
}

TEST_F(ConsoleServerTest, WhenThereAreTooManyTheOneThatWasSilentLongestGoes) {
  std::vector<Descriptor> consoles;
  for (std::size_t i = 0; i < ConsoleServer::kMaxConsoles; ++i) {
    consoles.push_back(connect());
    poll();
  }
  send(consoles[0], "a\n");
  EXPECT_EQ(pollAndReceive(consoles[0]), " a\nok\n");
  const Descriptor last = connect();
  poll();
  EXPECT_EQ(server_.consoles(), ConsoleServer::kMaxConsoles);
  EXPECT_FALSE(receiveFrom(consoles[0]).closed);
  EXPECT_TRUE(receiveFrom(consoles[1]).closed);
  send(last, "b\n");
  EXPECT_EQ(pollAndReceive(last), " b\nok\n");
}

TEST_F(ConsoleServerTest, MemoryStaysBoundedWhateverIsSent) {
  const Descriptor console = connect();
  std::string flood;
  for (int i = 0; i < 1'000'000; ++i) flood += "a\n";
  for (int i = 0; i < 1000; ++i) {
    EXPECT_TRUE(sendTo(console, flood));
    poll();
    receiveFrom(console);
  }
  EXPECT_EQ(lines_.size(), 1000u);
  EXPECT_FALSE(flood.empty());  // the rest waits at the sender
}

/// A server in a thread of its own that replies with the line; lines that begin with "no" fail, and "end" ends it.
class RunningServer {
 public:
  explicit RunningServer(const std::string& path) : server_(path), thread_([this] { run(); }) {}
  ~RunningServer() {
    stop_ = true;
    thread_.join();
  }

 private:
  void run() {
    while (!stop_) {
      server_->poll(std::chrono::steady_clock::now(), [this](std::string_view line) {
        if (line == "end") stop_ = true;
        return ConsoleReply{!line.starts_with("no"), "> " + std::string(line)};
      });
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    server_.reset();
  }

  std::optional<ConsoleServer> server_;
  std::atomic<bool> stop_{false};
  std::thread thread_;  // last: uses the members above from its start
};

class ConsoleClientTest : public testing::Test {
 protected:
  int run(const std::string& commands, bool interactive = false) {
    std::istringstream in(commands);
    return runConsole(path_, {in, results_, talk_, interactive});
  }

  const TemporaryFolder folder_ = TemporaryFolder::forSockets();
  const std::string path_ = folder_ / "console.sock";
  std::ostringstream results_, talk_;
};

TEST_F(ConsoleClientTest, ExecutesOneCommandALine) {
  const RunningServer server(path_);
  EXPECT_EQ(run("a\n b\n"), 0);
  EXPECT_EQ(results_.str(), "> a\n>  b\n");
  EXPECT_EQ(talk_.str(), "");
}

TEST_F(ConsoleClientTest, SkipsEmptyLinesAndComments) {
  const RunningServer server(path_);
  EXPECT_EQ(run("\n# a\n  \n  # b\na"), 0);
  EXPECT_EQ(results_.str(), "> a\n");
}

TEST_F(ConsoleClientTest, AFailedCommandIsReportedAndDoesNotEndTheOthers) {
  const RunningServer server(path_);
  EXPECT_EQ(run("no1\na\nno2\n"), 1);
  EXPECT_EQ(results_.str(), "> a\n");
  EXPECT_EQ(talk_.str(), "error: > no1\nerror: > no2\n");
}

TEST_F(ConsoleClientTest, QuitEndsTheConsole) {
  const RunningServer server(path_);
  EXPECT_EQ(run("a\nquit \nno\n"), 0);
  EXPECT_EQ(run("exit\nno\n"), 0);
  EXPECT_EQ(results_.str(), "> a\n");
}

TEST_F(ConsoleClientTest, APersonGetsAPrompt) {
  const RunningServer server(path_);
  EXPECT_EQ(run("a\n", true), 0);
  EXPECT_EQ(talk_.str(), "platon> platon> ");
}

TEST_F(ConsoleClientTest, ALineThatTheServerRefusesEndsTheConsole) {
  const RunningServer server(path_);
  EXPECT_EQ(run(std::string(1000, 'x') + "\na\n"), 1);
  EXPECT_TRUE(talk_.str().starts_with("error: the command has more than 512 bytes; the console is closed\n"))
      << talk_.str();
}

TEST_F(ConsoleClientTest, SaysThatNoServerAnswers) {
  EXPECT_EQ(run("a\n"), 1);
  EXPECT_EQ(talk_.str(), "platon-server: no server answers at '" + path_ +
                             "' (No such file or directory); start one, or name its socket after --socket\n");
}

TEST_F(ConsoleClientTest, SaysThatTheServerHasEnded) {
  const RunningServer server(path_);
  EXPECT_EQ(run("end\na\n"), 1);
  EXPECT_EQ(results_.str(), "> end\n");
  EXPECT_EQ(talk_.str(),
            "platon-server: the server at '" + path_ + "' has stopped or does not answer; its log may say why\n");
}

// A user of this machine other than root.
constexpr uid_t kStranger = 65534;

// Makes the system take this program for one of another user, as long as it lives. Only root can.
class ActingAs {
 public:
  explicit ActingAs(uid_t user) { EXPECT_EQ(seteuid(user), 0); }
  ~ActingAs() { EXPECT_EQ(seteuid(0), 0); }
  ActingAs(const ActingAs&) = delete;
  ActingAs& operator=(const ActingAs&) = delete;
};

// The server of another user, at a path that root gives to its console.
class StrangersServerTest : public ConsoleClientTest {
 protected:
  void SetUp() override {
    if (geteuid() != 0) GTEST_SKIP() << "only root may act as another user";
    ASSERT_EQ(chown(folder_.path().c_str(), kStranger, kStranger), 0);
    const ActingAs stranger(kStranger);
    server_.emplace(path_);
  }

  // What the console says if the folder has an owner and rights.
  int runIn(uid_t owner, mode_t rights) {
    EXPECT_EQ(chown(folder_.path().c_str(), owner, 0), 0);
    EXPECT_EQ(chmod(folder_.path().c_str(), rights), 0);
    return run("a\n");
  }

  std::optional<RunningServer> server_;
  const std::string refusal_ =
      "platon-server: the server at '" + path_ +
      "' belongs to another user; name the socket of your own server after --socket, or run the console as that user\n";
};

// It was told that no server answers, and to start one.
TEST_F(StrangersServerTest, AnotherUserIsToldWhoMayOpenIt) {
  ASSERT_EQ(chmod(folder_.path().c_str(), 0755), 0);
  ASSERT_EQ(chmod(path_.c_str(), 0600), 0);
  const ActingAs other(kStranger - 1);
  EXPECT_EQ(run("a\n"), 1);
  EXPECT_EQ(
      talk_.str(),
      "platon-server: no server answers at '" + path_ +
          "' (Permission denied); this user may not open it; run the console as the user of the server, or as root\n");
}

TEST_F(StrangersServerTest, RootTellsItNothingWhereOthersCanMakeASocket) {
  for (const auto& [owner, rights] :
       {std::pair(0u, 01777u), std::pair(0u, 0755u), std::pair(kStranger, 0757u), std::pair(kStranger, 0775u)}) {
    EXPECT_EQ(runIn(owner, rights), 1);
    EXPECT_EQ(talk_.str(), refusal_) << owner << " " << rights;
    talk_.str("");
  }
  EXPECT_EQ(results_.str(), "");
}

TEST_F(StrangersServerTest, RootControlsItInAFolderOfItsOwn) {
  EXPECT_EQ(runIn(kStranger, 0755), 0);
  EXPECT_EQ(results_.str(), "> a\n");
  EXPECT_EQ(talk_.str(), "");
}

TEST_F(StrangersServerTest, AnotherUserTellsItNothing) {
  EXPECT_EQ(chmod(path_.c_str(), 0666), 0);
  EXPECT_EQ(chmod(folder_.path().c_str(), 0755), 0);
  {
    const ActingAs another(kStranger - 1);
    EXPECT_EQ(run("a\n"), 1);
  }
  EXPECT_EQ(talk_.str(), refusal_);
}

}  // namespace
}  // namespace platon::console_socket_test
