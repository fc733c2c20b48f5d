#include "server/admin/stream_socket.h"

#include <gtest/gtest.h>
#include <sys/socket.h>

#include <array>
#include <cerrno>

#include "server/admin/console_socket.h"
#include "tests/support/temporary_folder.h"

namespace platon::stream_socket_test {
namespace {

/// The two ends of a connection that neither end waits for.
struct Pair {
  Pair() {
    std::array<int, 2> ends{};
    EXPECT_EQ(socketpair(AF_UNIX, SOCK_STREAM | SOCK_NONBLOCK, 0, ends.data()), 0);
    here = Descriptor(ends[0]);
    there = Descriptor(ends[1]);
  }

  Descriptor here, there;
};

TEST(StreamSocket, ReceivesWhatWasSent) {
  const Pair pair;
  EXPECT_EQ(receiveFrom(pair.there).bytes, "");
  EXPECT_FALSE(receiveFrom(pair.there).closed);
  std::string bytes = "hello";
  EXPECT_TRUE(sendTo(pair.here, bytes));
  EXPECT_EQ(bytes, "");
  EXPECT_EQ(receiveFrom(pair.there).bytes, "hello");
}

TEST(StreamSocket, SendingStopsWhenTheReaderTakesNothing) {
  const Pair pair;
  std::string bytes(8 * 1024 * 1024, 'x');
  EXPECT_TRUE(sendTo(pair.here, bytes));
  const std::size_t left = bytes.size();
  EXPECT_GT(left, 0u);
  EXPECT_TRUE(sendTo(pair.here, bytes));
  EXPECT_EQ(bytes.size(), left);
  EXPECT_EQ(receiveFrom(pair.there).bytes.size(), kMaxReceivedBytes);
}

TEST(StreamSocket, NoticesThatTheOtherEndHasClosed) {
  Pair pair;
  pair.there = Descriptor();
  EXPECT_TRUE(receiveFrom(pair.here).closed);
  std::string bytes = "hello";
  EXPECT_FALSE(sendTo(pair.here, bytes));  // and no signal ends the program
}

TEST(StreamSocket, FinishSendingLeavesTheOtherDirectionOpen) {
  const Pair pair;
  finishSending(pair.here);
  EXPECT_TRUE(receiveFrom(pair.there).closed);
  std::string bytes = "hello";
  EXPECT_TRUE(sendTo(pair.there, bytes));
  EXPECT_EQ(receiveFrom(pair.here).bytes, "hello");
}

TEST(StreamSocket, AcceptsUnixConnectionsOfThisUser) {
  const TemporaryFolder folder = TemporaryFolder::forSockets();
  const ConsoleSocket console(folder / "s");
  EXPECT_FALSE(acceptFrom(console.listener()));
  const Descriptor client = connectUnix(console.path());
  ASSERT_TRUE(client);
  const Descriptor server = acceptFrom(console.listener());
  ASSERT_TRUE(server);
  EXPECT_TRUE(peerIsTrusted(client));
  EXPECT_TRUE(peerIsTrusted(server));
}

TEST(StreamSocket, ConnectingSaysWhyItFails) {
  EXPECT_FALSE(connectUnix("/no/such/socket"));
  EXPECT_EQ(errno, ENOENT);
  EXPECT_FALSE(connectUnix(std::string(200, 'x')));
  EXPECT_EQ(errno, ENAMETOOLONG);
}

TEST(StreamSocket, ListensOnIpv4) {
  const Descriptor listener = listenTcp({*IpAddress::parse("127.0.0.1"), 0});
  ASSERT_TRUE(listener);
  EXPECT_NE(portOf(listener), 0);
  EXPECT_FALSE(listenTcp({*IpAddress::parse("127.0.0.1"), portOf(listener)}));
  EXPECT_EQ(errno, EADDRINUSE);
  EXPECT_FALSE(listenTcp({*IpAddress::parse("198.51.100.1"), 0}));
  EXPECT_EQ(errno, EADDRNOTAVAIL);
}

}  // namespace
}  // namespace platon::stream_socket_test
