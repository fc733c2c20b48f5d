#include "server/admin/console_server.h"

#include <gtest/gtest.h>

#include "server/admin/console_command.h"
#include "server/admin/stream_socket.h"
#include "tests/support/temporary_folder.h"

namespace platon::console_server_test {
namespace {

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
  EXPECT_EQ(pollAndReceive(console), " a command has at most 512 bytes; the console is closed\nfailed\n");
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

}  // namespace
}  // namespace platon::console_server_test
