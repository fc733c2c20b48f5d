#include "server/net/host.h"

#include <gtest/gtest.h>

#include "tests/server/net/host_fixture.h"

namespace platon::host_test {
namespace {

using namespace std::chrono_literals;

TEST_F(HostTest, DeliversTheMessagesOfAClient) {
  EXPECT_TRUE(host_.empty());
  const ClientId client = connect();
  EXPECT_FALSE(host_.empty());
  EXPECT_FALSE(events_[0].disconnected);
  EXPECT_EQ(messages_[0], (Bytes{1, 2, 3}));
  EXPECT_EQ(host_.addressOf(client), kClient.ip);
  EXPECT_EQ(host_.addressOf(client + 1), IpAddress());
  EXPECT_TRUE(host_.isOpen(client));
  EXPECT_FALSE(host_.isOpen(client + 1));
}

// ENet averages, in whole milliseconds: it comes as near as eight.
TEST_F(HostTest, TheRoundTripIsTheTimeInWhichAClientAnswers) {
  const ClientId client = connect();
  EXPECT_LE(host_.roundTripMs(client), 1u);
  for (int i = 0; i < 50; ++i) {
    host_.send(client, true, Bytes{1});
    host_.flush(now_);
    now_ += 40ms;
    client_.service(now_, [](std::span<const std::uint8_t>) {});
    client_.flush(now_);
    host_.service(now_);
  }
  EXPECT_EQ(host_.roundTripMs(client), 33u);
  EXPECT_EQ(host_.roundTripMs(client + 1), 0u);
}

TEST_F(HostTest, ReportsThatAClientHasDisconnected) {
  const ClientId client = connect();
  host_.close(client, now_);
  EXPECT_FALSE(host_.isOpen(client));
  EXPECT_TRUE(run([this] { return client_.state() == EnetLink::State::kClosed && host_.empty(); }));
  ASSERT_EQ(events_.size(), 2u);
  EXPECT_TRUE(events_[1].disconnected);
  EXPECT_EQ(events_[1].client, client);
}

// As when its router gives it another port.
TEST_F(HostTest, AClientWhoseAddressChangesIsFollowedAndMissesNoMessage) {
  const SocketAddress moved = addressAt("192.0.2.1", 4001);
  const ClientId client = connect();
  host_.admit(client);
  network_.setFilter([&](const DatagramNetwork::Sent& sent) {
    if (sent.from == kClient) network_.inject(moved, kServer, sent.bytes);
    if (sent.to == moved) network_.inject(kServer, kClient, sent.bytes);
    return sent.from == kEve || sent.to == kEve;
  });
  for (std::uint8_t i = 0; i < 100; ++i) {
    host_.send(client, true, Bytes{i});
    client_.send(Bytes(20, i), false);
    step();
  }
  EXPECT_TRUE(run([this] { return received_.size() == 100 && messages_.size() == 101; }));
  for (std::uint8_t i = 0; i < 100; ++i) EXPECT_EQ(received_.at(i), Bytes{i});
}

// Neither what it sends nor its admission prolongs the connection.
TEST_F(HostTest, AnAdmittedClientThatKeepsSendingAfterCloseEndsAfterThreeSeconds) {
  eve_.connect(host_, now_);
  eve_.send(reliableContent(eve_.peer(), 1, 5), now_);
  const std::span<const HostEvent> events = host_.service(now_);
  ASSERT_EQ(events.size(), 1u);
  const ClientId client = events[0].client;
  host_.admit(client);
  const Time closed = now_;
  host_.close(client, closed);
  for (now_ += 100ms; now_ < closed + 3s; now_ += 100ms) {
    eve_.send(acknowledgeContent(eve_.peer(), 1), now_);
    ASSERT_TRUE(host_.service(now_).empty()) << (now_ - closed) / 1ms << " ms";
    ASSERT_FALSE(host_.empty());
  }
  const std::span<const HostEvent> last = host_.service(closed + 3s);
  ASSERT_EQ(last.size(), 1u);
  EXPECT_TRUE(last[0].disconnected);
  EXPECT_EQ(last[0].client, client);
  EXPECT_TRUE(host_.empty());
  EXPECT_EQ(host_.rejections(), Rejections()) << "the server has closed it";
}

TEST_F(HostTest, AnOldConnectionWaitsThreeSecondsForTheAnswerToItsClose) {
  const ClientId client = connect();
  host_.admit(client);
  const Time connected = now_;
  EXPECT_TRUE(run([&] { return now_ >= connected + 10s; }));
  EXPECT_TRUE(host_.isOpen(client));
  const Time closed = now_;
  host_.close(client, closed);
  EXPECT_TRUE(host_.service(closed + 3s - 1ms).empty());
  EXPECT_FALSE(host_.empty());
  const std::span<const HostEvent> last = host_.service(closed + 3s);
  ASSERT_EQ(last.size(), 1u);
  EXPECT_TRUE(last[0].disconnected);
  EXPECT_TRUE(host_.empty());
}

TEST_F(HostTest, AnAdmittedConnectionEndsAfterFiveSecondsOfSilence) {
  const ClientId client = connect();
  host_.admit(client);
  EXPECT_TRUE(host_.service(now_ + 4s).empty());
  EXPECT_TRUE(host_.isOpen(client));
  const std::span<const HostEvent> events = host_.service(now_ + 5s);
  ASSERT_EQ(events.size(), 1u);
  EXPECT_TRUE(events[0].disconnected);
  EXPECT_TRUE(host_.empty());
  EXPECT_EQ(host_.rejections().silent, 1u);
}

TEST_F(HostTest, AConnectionThatIsNotAdmittedEnds) {
  const ClientId client = connect();
  const Time connected = now_;
  host_.service(connected + Host::kAdmissionTime - 5s);
  EXPECT_TRUE(host_.isOpen(client));
  host_.service(connected + Host::kAdmissionTime);
  EXPECT_FALSE(host_.isOpen(client));
  EXPECT_EQ(host_.rejections().idle, 1u);
}

TEST_F(HostTest, AClientThatDoesNotCompleteTheHandshakeEndsAfterThreeSeconds) {
  eve_.join(host_, now_);
  eve_.send(connectContent(77), now_);
  eve_.step(host_, now_);
  EXPECT_TRUE(host_.service(now_ + 3s - 1ms).empty());
  EXPECT_FALSE(host_.empty());
  EXPECT_TRUE(host_.service(now_ + 3s).empty()) << "nobody has heard of it";
  EXPECT_TRUE(host_.empty());
  EXPECT_EQ(host_.rejections().idle, 1u);
}

TEST_F(HostTest, TheTimeUntilAdmissionBeginsWithTheEndOfTheHandshake) {
  eve_.join(host_, now_);
  eve_.send(connectContent(77), now_);
  eve_.step(host_, now_);
  now_ += 2900ms;
  eve_.send(acknowledgeContent(eve_.peer(), 1), now_);
  eve_.step(host_, now_);
  host_.service(now_ + Host::kAdmissionTime - 1ms);
  EXPECT_FALSE(host_.empty());
  host_.service(now_ + Host::kAdmissionTime);
  EXPECT_TRUE(host_.empty());
}

TEST_F(HostTest, ConnectionsThatHaveEndedLeaveTheirPlacesAtOnce) {
  for (int times = 0; times < 3; ++times) {
    std::vector<ClientId> clients;
    for (std::uint32_t i = 1; i <= settings().connections; ++i) {
      HostileClient client(network_, addressAt("192.0.2." + std::to_string(i), 5000), kServer);
      client.connect(host_, now_);
      client.send(reliableContent(client.peer(), 1, 5), now_);
      for (const HostEvent& event : host_.service(now_)) clients.push_back(event.client);
    }
    ASSERT_EQ(clients.size(), settings().connections) << times;
    for (const ClientId client : clients) host_.close(client, now_);
    now_ += Host::kAnswerTime;
    EXPECT_EQ(host_.service(now_).size(), clients.size());
    EXPECT_TRUE(host_.empty());
  }
}

TEST_F(HostTest, DatagramsBeyondTheBudgetOfTheirConnectionAreDropped) {
  connect();
  for (int i = 0; i < 600; ++i) {
    client_.send(Bytes{1}, false);
    client_.flush(now_);
  }
  EXPECT_TRUE(run([this] { return host_.rejections().excess > 100; }));
}

TEST_F(HostTest, BytesBeyondTheBudgetOfTheirConnectionAreDropped) {
  eve_.connect(host_, now_);
  for (int i = 0; i < 100; ++i) eve_.send(unsequencedContent(eve_.peer(), 1000), now_);
  eve_.step(host_, now_);
  EXPECT_GT(host_.rejections().excess, 20u);
}

// ENet alone would double the pause each time.
TEST_F(HostTest, AMessageIsRepeatedAtOnePaceUntilItIsAcknowledged) {
  const ClientId client = connect();
  host_.admit(client);
  host_.send(client, true, Bytes{9});
  const std::size_t before = network_.sent().size();
  for (int ms = 0; ms < 4000; ms += 10) host_.service(now_ + ms * 1ms);
  const std::size_t sent = network_.sent().size() - before;
  EXPECT_GE(sent, 4000u / 200);
  EXPECT_LE(sent, 4000u / 100);
}

// A tick of 4.35 s: ENet sorted packets without data, for sequence numbers far ahead, into a list without bound.
TEST_F(HostTest, ContentsThatNoClientSendsNeverReachEnet) {
  eve_.connect(host_, now_);
  EXPECT_FALSE(host_.empty());
  const std::uint64_t before = host_.rejections().content;
  const Bytes hostile[] = {fragmentContent(eve_.peer()),
                           unreliableContent(eve_.peer(), 9),
                           unreliableContent(eve_.peer(), 60000),
                           reliableContent(eve_.peer(), 2000, 5),
                           reliableContent(eve_.peer(), 1, 0),
                           pingContent(3),
                           connectContent(78),
                           Bytes(30, 0xff)};
  for (const Bytes& content : hostile) eve_.send(content, now_);
  eve_.step(host_, now_);
  EXPECT_EQ(host_.rejections().content - before, std::size(hostile));
  connect();
}

// The client chooses the id of its connection: a repeated request with another id took another place each time.
TEST_F(HostTest, ASessionHasOneConnection) {
  eve_.connect(host_, now_);
  for (std::uint32_t id = 100; id < 110; ++id) {
    eve_.send(connectContent(id), now_);
    eve_.step(host_, now_);
  }
  EXPECT_EQ(host_.rejections().content, 10u);
  connect();
}

// The log of a server blamed honest clients whose connection loses datagrams.
TEST_F(HostTest, ARepeatedRequestToConnectIsNotCountedAsHostile) {
  eve_.join(host_, now_);
  for (int i = 0; i < 4; ++i) {
    eve_.send(connectContent(77), now_);
    eve_.step(host_, now_);
  }
  EXPECT_EQ(host_.rejections(), Rejections());
  for (int i = 0; i < 1000; ++i) {
    eve_.send(connectContent(77), now_);
    eve_.step(host_, now_);
  }
  EXPECT_EQ(host_.rejections().content, 0u);
  EXPECT_GT(host_.rejections().excess, 500u);
}

// So did the last message of a client whose acknowledgement was lost while the server closed the connection.
TEST_F(HostTest, AMessageRepeatedWhileTheConnectionClosesIsNotCountedAsHostile) {
  eve_.connect(host_, now_);
  eve_.send(reliableContent(eve_.peer(), 1, 5), now_);
  const std::span<const HostEvent> events = host_.service(now_);
  ASSERT_EQ(events.size(), 1u);
  host_.close(events[0].client, now_);
  host_.flush(now_);
  eve_.send(reliableContent(eve_.peer(), 1, 5), now_);
  EXPECT_TRUE(host_.service(now_).empty());
  EXPECT_EQ(host_.rejections(), Rejections());
}

TEST_F(HostTest, ASessionWithoutAConnectionEnds) {
  eve_.join(host_, now_);
  EXPECT_EQ(host_.rejections().unconfirmed, 0u);
  host_.service(now_ + 3s);
  EXPECT_EQ(host_.rejections().unconfirmed, 1u);
}

TEST_F(HostTest, AClientThatAcknowledgesNothingIsDroppedBeforeItsQueueGrows) {
  const ClientId client = connect();
  host_.admit(client);
  EXPECT_EQ(host_.room(client), Host::kMaxQueuedMessages);
  for (std::size_t i = 0; i < Host::kMaxQueuedMessages; ++i) host_.send(client, true, Bytes(1000));
  EXPECT_EQ(host_.room(client), 0u);
  EXPECT_TRUE(host_.service(now_).empty());
  host_.send(client, true, Bytes(1000));
  const std::span<const HostEvent> events = host_.service(now_);
  ASSERT_EQ(events.size(), 1u);
  EXPECT_TRUE(events[0].disconnected);
  EXPECT_EQ(host_.rejections().slow, 1u);
}

// The newcomer got the place, and the end of the connection before it was never reported: its player stayed for ever.
TEST_F(HostTest, TheEndOfASlowClientIsReportedEvenIfANewcomerGetsItsPlace) {
  const ClientId client = connect();
  host_.admit(client);
  eve_.join(host_, now_);
  for (std::size_t i = 0; i <= Host::kMaxQueuedMessages; ++i) host_.send(client, true, Bytes(1000));
  eve_.send(connectContent(77), now_);
  const std::span<const HostEvent> events = host_.service(now_);
  ASSERT_EQ(events.size(), 1u);
  EXPECT_TRUE(events[0].disconnected);
  EXPECT_EQ(events[0].client, client);
  EXPECT_EQ(host_.room(client), 0u);
}

TEST_F(HostTest, AClientThatAcknowledgesMakesRoom) {
  const ClientId client = connect();
  host_.admit(client);
  std::size_t sent = 0;
  EXPECT_TRUE(run([&] {
    while (sent < 1000 && host_.room(client) > 0) {
      host_.send(client, true, Bytes(1000, static_cast<std::uint8_t>(sent)));
      ++sent;
    }
    return received_.size() == 1000;
  }));
  EXPECT_TRUE(host_.isOpen(client));
}

TEST_F(HostTest, CountsRejectionsByReason) {
  network_.inject(kEve, kServer, Bytes{0});
  network_.inject(kEve, kServer, Bytes(40, 0xff));
  host_.service(now_);
  const std::vector<Rejection> rejections = host_.rejections().list();
  const auto count = [&](std::string_view reason) {
    const auto found = std::find_if(rejections.begin(), rejections.end(),
                                    [&](const Rejection& each) { return each.reason == reason; });
    return found == rejections.end() ? 99 : found->count;
  };
  EXPECT_EQ(count("malformed"), 1u);
  EXPECT_EQ(count("seal"), 1u);
  EXPECT_EQ(count("excess"), 0u);
}

}  // namespace
}  // namespace platon::host_test
