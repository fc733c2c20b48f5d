#include "protocol/transport/enet_layer.h"

#include <memory>
#include <random>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "protocol/limits.h"
#include "tests/net/support/raw_content.h"

namespace platon::enet_layer_test {
namespace {

/// Two ENet hosts that exchange contents through their ports.
class TestPort : public EnetPort {
 public:
  void sendFromEnet(const ENetAddress& session, ByteSpan bytes) override {
    EXPECT_EQ(session.host, 7u);
    sent.emplace_back(bytes.begin(), bytes.end());
  }
  std::optional<Received> receiveForEnet() override {
    if (waiting.empty()) return std::nullopt;
    current = waiting.front();
    waiting.erase(waiting.begin());
    return Received{{7, 1}, current};
  }

  std::vector<Bytes> sent;
  std::vector<Bytes> waiting;
  Bytes current;
};

TEST(EnetCalls, LibenetUsesThem) { EXPECT_TRUE(enetUsesOurCalls()); }

TEST(EnetCalls, TheTimeIsThatOfTheInnermostScope) {
  TestPort port;
  const EnetScope outer(port, std::chrono::microseconds(5'000'999));
  EXPECT_EQ(enet_time_get(), 5000u);
  {
    const EnetScope inner(port, std::chrono::seconds(9));
    EXPECT_EQ(enet_time_get(), 9000u);
  }
  EXPECT_EQ(enet_time_get(), 5000u);
}

TEST(EnetCalls, TwoHostsConnectWithoutASocket) {
  const std::unique_ptr<ENetHost, void (*)(ENetHost*)> server(enet_host_create(nullptr, 1, 2, 0, 0), enet_host_destroy);
  const std::unique_ptr<ENetHost, void (*)(ENetHost*)> client(enet_host_create(nullptr, 1, 2, 0, 0), enet_host_destroy);
  TestPort serverPort;
  TestPort clientPort;
  const ENetAddress session{7, 1};
  enet_host_connect(client.get(), &session, 2, 0);
  int connected = 0;
  for (int ms = 1; ms < 50; ++ms) {
    for (const auto& [host, port] : {std::pair{server.get(), &serverPort}, std::pair{client.get(), &clientPort}}) {
      const EnetScope scope(*port, std::chrono::milliseconds(ms));
      ENetEvent event{};
      if (enet_host_service(host, &event, 0) > 0 && event.type == ENET_EVENT_TYPE_CONNECT) ++connected;
    }
    std::swap(serverPort.waiting, clientPort.sent);
    std::swap(clientPort.waiting, serverPort.sent);
    serverPort.sent.clear();
    clientPort.sent.clear();
  }
  EXPECT_EQ(connected, 2);
}

/// A connection that begins, to a server that does not answer.
class EnetSettingsTest : public testing::Test {
 protected:
  EnetSettingsTest() : host_(createEnetHost(1, 5), enet_host_destroy) {
    const ENetAddress session{1, 1};
    peer_ = enet_host_connect(host_.get(), &session, kChannels, 0);
  }

  struct Port : EnetPort {
    void sendFromEnet(const ENetAddress&, ByteSpan bytes) override { sent.emplace_back(bytes.begin(), bytes.end()); }
    std::optional<Received> receiveForEnet() override { return std::nullopt; }
    std::vector<Bytes> sent;
  };

  Port port_;
  EnetScope scope_{port_, std::chrono::seconds(1000)};
  std::unique_ptr<ENetHost, void (*)(ENetHost*)> host_;
  ENetPeer* peer_ = nullptr;
};

TEST_F(EnetSettingsTest, ConfiguringAPeerSetsTimeoutAndPings) {
  configurePeer(*peer_);
  EXPECT_EQ(peer_->timeoutLimit, kEnetTimeoutAttempts);
  EXPECT_EQ(peer_->timeoutMinimum, kEnetTimeoutMs);
  EXPECT_EQ(peer_->timeoutMaximum, kEnetTimeoutMs);
  EXPECT_EQ(peer_->pingInterval, kEnetPingIntervalMs);
}

TEST_F(EnetSettingsTest, AnUnthrottledPeerKeepsItsThrottleOpen) {
  peer_->packetThrottle = 3;
  peer_->packetThrottleLimit = 5;
  peer_->packetThrottleDeceleration = 7;
  fixSettings(*peer_);
  enet_peer_throttle(peer_, 10000);  // as after a round trip of 10 s
  EXPECT_EQ(peer_->packetThrottle, ENET_PEER_PACKET_THROTTLE_SCALE + 0u);
}

TEST_F(EnetSettingsTest, AnUnacknowledgedCommandIsSentAgainAfterTheLimit) {
  enet_host_flush(host_.get());  // sends the request to connect
  ASSERT_FALSE(enet_list_empty(&peer_->sentReliableCommands));
  const auto* command = reinterpret_cast<const ENetOutgoingCommand*>(enet_list_front(&peer_->sentReliableCommands));
  ASSERT_GT(command->roundTripTimeout, 70u);
  limitRetransmissionTimeout(*peer_, 70);
  EXPECT_EQ(command->roundTripTimeout, 70u);
  EXPECT_EQ(peer_->nextTimeout, command->sentTime + 70);
  limitRetransmissionTimeout(*peer_, 90);
  EXPECT_EQ(command->roundTripTimeout, 70u);
}

TEST_F(EnetSettingsTest, ACommandThatIsDueIsSentAgainOnlyIfItMay) {
  enet_host_flush(host_.get());
  const auto serviceAt = [&](Time now, bool may) {
    const EnetScope scope(port_, now);
    int asked = 0;
    limitRetransmissionTimeout(*peer_, 70);
    postponeRetransmissions(*peer_, enet_time_get(), [&](const ENetOutgoingCommand&) { return ++asked > 0 && may; });
    ENetEvent event{};
    serviceEnet(*host_, event);
    return asked;
  };
  using std::chrono::milliseconds;
  const Time sent = std::chrono::seconds(1000);
  EXPECT_EQ(serviceAt(sent + milliseconds(69), false), 0) << "it is not due";
  EXPECT_EQ(serviceAt(sent + milliseconds(70), false), 1);
  EXPECT_EQ(serviceAt(sent + milliseconds(71), false), 1) << "it is still due";
  EXPECT_EQ(port_.sent.size(), 1u);
  EXPECT_EQ(serviceAt(sent + milliseconds(90), true), 1);
  EXPECT_EQ(port_.sent.size(), 2u);
  EXPECT_EQ(serviceAt(sent + milliseconds(91), true), 0) << "it was sent a moment ago";
}

TEST_F(EnetSettingsTest, TheLongestMessageIsNotSplit) {
  enet_host_flush(host_.get());
  peer_->state = ENET_PEER_STATE_CONNECTED;
  fixSettings(*peer_);
  port_.sent.clear();
  sendMessage(*peer_, Bytes(kMaxMessageBytes), true);
  enet_host_flush(host_.get());
  EXPECT_EQ(port_.sent.size(), 1u);
  EXPECT_LE(port_.sent.front().size(), kEnetMtu);
}

TEST_F(EnetSettingsTest, AMessageToADisconnectedPeerIsDropped) {
  enet_host_flush(host_.get());
  const std::uint8_t byte = 1;
  sendMessage(*peer_, {&byte, 1}, true);
  EXPECT_TRUE(enet_list_empty(&peer_->outgoingCommands));
}

TEST_F(EnetSettingsTest, ReliableAndUnreliableMessagesHaveTheirOwnChannels) {
  enet_host_flush(host_.get());
  peer_->state = ENET_PEER_STATE_CONNECTED;
  peer_->channels[kTickChannel].outgoingReliableSequenceNumber = 0;
  const std::uint8_t byte = 1;
  sendMessage(*peer_, {&byte, 1}, true);
  EXPECT_EQ(peer_->channels[kReliableChannel].outgoingReliableSequenceNumber, 1);
  const enet_uint16 unsequenced = peer_->outgoingUnsequencedGroup;
  sendMessage(*peer_, {&byte, 1}, false);
  EXPECT_EQ(peer_->outgoingUnsequencedGroup, unsequenced + 1);
  EXPECT_EQ(peer_->channels[kTickChannel].outgoingReliableSequenceNumber, 0);
}

std::optional<EnetCommands> fromClient(ByteSpan content) { return readEnetCommands(content, EnetSender::kClient); }
std::optional<EnetCommands> fromServer(ByteSpan content) { return readEnetCommands(content, EnetSender::kServer); }

Bytes with(Bytes content, std::size_t offset, int value) {
  content[offset] = static_cast<std::uint8_t>(value);
  return content;
}

TEST(EnetCheck, TellsRequestsToConnectFromDatagramsOfPeers) {
  EXPECT_TRUE(fromClient(connectContent(1))->isConnect());
  const std::optional<EnetCommands> ping = fromClient(pingContent(7));
  ASSERT_TRUE(ping);
  EXPECT_FALSE(ping->isConnect());
  EXPECT_EQ(ping->peer, 7);
  EXPECT_EQ(ping->count, 1u);
}

TEST(EnetCheck, TellsARepeatedRequestFromAnother) {
  EXPECT_EQ(fromClient(connectContent(1))->connectId, fromClient(connectContent(1))->connectId);
  EXPECT_NE(fromClient(connectContent(1))->connectId, fromClient(connectContent(2))->connectId);
}

TEST(EnetCheck, ReadsChannelAndSequenceOfEachCommand) {
  const auto commands =
      fromClient(joinedContents({reliableContent(3, 900, 5), pingContent(3), unsequencedContent(3, 9)}));
  ASSERT_TRUE(commands);
  ASSERT_EQ(commands->count, 3u);
  EXPECT_EQ(commands->commands[0].sequence, 900);
  EXPECT_EQ(commands->commands[0].channel, kReliableChannel);
  EXPECT_EQ(commands->commands[2].channel, kTickChannel);
}

TEST(EnetCheck, RefusesWhatOurProgramsDoNotSend) {
  const Bytes reliable = reliableContent(7, 1, 5);
  EXPECT_TRUE(fromClient(reliable));
  const std::pair<const char*, Bytes> refused[] = {
      {"fragment", fragmentContent(7)},
      {"unreliable without data", unreliableContent(7, 1)},
      {"reliable without data", reliableContent(7, 1, 0)},
      {"unsequenced without data", unsequencedContent(7, 0)},
      {"longest", reliableContent(7, 1, kMaxMessageBytes + 1)},
      {"compressed", with(reliable, 0, reliable[0] | 0x40)},
      {"reliable on the tick channel", with(reliable, kCommandAt + 1, kTickChannel)},
      {"channel that does not exist", with(reliable, kCommandAt + 1, 200)},
      {"reliable without acknowledgement", with(reliable, kCommandAt, ENET_PROTOCOL_COMMAND_SEND_RELIABLE)},
      {"bandwidth limit", with(connectContent(1), kCommandAt, ENET_PROTOCOL_COMMAND_BANDWIDTH_LIMIT | 0x80)},
      {"throttle configuration", with(connectContent(1), kCommandAt, ENET_PROTOCOL_COMMAND_THROTTLE_CONFIGURE | 0x80)},
      {"no command", with(pingContent(7), kCommandAt, 0)},
      {"unknown command", with(pingContent(7), kCommandAt, 15)},
      {"ping without peer", pingContent(0xfff)},
      {"connect to a peer", with(connectContent(1), 1, 7)},
      {"ping beside connect", joinedContents({connectContent(1), pingContent(7)})},
  };
  for (const auto& [what, content] : refused) EXPECT_FALSE(fromClient(content)) << what;
}

TEST(EnetCheck, EachSideMaySendOnlyItsOwnHandshake) {
  EXPECT_TRUE(fromClient(connectContent(1)));
  EXPECT_FALSE(fromServer(connectContent(1)));
  Bytes verify(kCommandAt + enet_protocol_command_size(ENET_PROTOCOL_COMMAND_VERIFY_CONNECT));
  verify[0] = 0x80;
  verify[kCommandAt] = ENET_PROTOCOL_COMMAND_VERIFY_CONNECT | 0x80;
  verify[kCommandAt + 1] = 0xff;
  EXPECT_TRUE(fromServer(verify));
  EXPECT_FALSE(fromClient(verify));
}

TEST(EnetCheck, RefusesTooManyCommands) {
  EXPECT_TRUE(fromClient(joinedContents(std::vector<Bytes>(16, pingContent(7)))));
  EXPECT_FALSE(fromClient(joinedContents(std::vector<Bytes>(17, pingContent(7)))));
  EXPECT_TRUE(fromServer(joinedContents(std::vector<Bytes>(32, pingContent(7)))));
  EXPECT_FALSE(fromServer(joinedContents(std::vector<Bytes>(33, pingContent(7)))));
  EXPECT_TRUE(fromClient(joinedContents(std::vector<Bytes>(32, acknowledgeContent(7, 1)))));
  EXPECT_FALSE(fromClient(joinedContents(std::vector<Bytes>(33, acknowledgeContent(7, 1)))));
}

TEST(EnetCheck, RefusesLengthsThatDoNotMatch) {
  for (const Bytes& whole : {connectContent(1), pingContent(7), unsequencedContent(7, 20), reliableContent(7, 3, 20)}) {
    EXPECT_TRUE(fromClient(whole));
    for (std::size_t size = 0; size < whole.size(); ++size) {
      EXPECT_FALSE(fromClient(ByteSpan(whole).first(size))) << size << " of " << whole.size();
    }
    Bytes longer = whole;
    longer.push_back(1);
    EXPECT_FALSE(fromClient(longer));
  }
}

TEST(EnetCheck, ReliableSequencesMustBeNear) {
  ENetChannel channel{};
  channel.incomingReliableSequenceNumber = 65530;
  ENetPeer peer{};
  peer.channels = &channel;
  peer.channelCount = 1;
  const auto isNear = [&](int sequence) {
    return areSequencesNear(*fromClient(reliableContent(7, static_cast<std::uint16_t>(sequence), 5)), peer);
  };
  EXPECT_TRUE(isNear(65531));
  EXPECT_TRUE(isNear(65530));         // repeated
  EXPECT_TRUE(isNear(65530 - 1000));  // repeated
  EXPECT_TRUE(isNear(65530 + 256));   // after a gap
  EXPECT_FALSE(isNear(65530 + 257));
  EXPECT_FALSE(isNear(65530 + 0x8000));
}

TEST(EnetCheck, AReceiverThatIsClosingIsLeftToEnet) {
  EXPECT_TRUE(areSequencesNear(*fromClient(reliableContent(7, 60000, 5)), ENetPeer{}));
}

TEST(EnetCheck, ReadsRandomContents) {
  constexpr std::uint64_t seed = 3;
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937_64 random(seed);
  std::uint64_t passed = 0;
  for (int round = 0; round < 200000; ++round) {
    Bytes bytes = round % 2 == 0 ? unsequencedContent(3, 8) : Bytes(random() % 64);
    for (int i = 0; i < 3 && !bytes.empty(); ++i) bytes[random() % bytes.size()] = static_cast<std::uint8_t>(random());
    passed += fromClient(bytes) ? 1 : 0;
  }
  EXPECT_GT(passed, 0u);
}

/// A connection that has sent a request and two messages.
class EnetOutstandingTest : public testing::Test {
 protected:
  EnetOutstandingTest() : host_(createEnetHost(1, 5), enet_host_destroy) {
    const ENetAddress session{1, 1};
    peer_ = enet_host_connect(host_.get(), &session, kChannels, 0);
    enet_host_flush(host_.get());
    peer_->state = ENET_PEER_STATE_CONNECTED;
    sendMessage(*peer_, Bytes(100), true);
    sendMessage(*peer_, Bytes(200), true);
    sendMessage(*peer_, Bytes(300), false);
    enet_host_flush(host_.get());
    sendMessage(*peer_, Bytes(400), true);  // not on the way yet
  }

  struct Port : EnetPort {
    void sendFromEnet(const ENetAddress&, ByteSpan) override {}
    std::optional<Received> receiveForEnet() override { return std::nullopt; }
  };

  // What remains of a content.
  Bytes remainder(Bytes content) const {
    std::optional<EnetCommands> commands = fromClient(content);
    EXPECT_TRUE(commands);
    removeFalseAcknowledgements(content, *commands, *peer_);
    const std::optional<EnetCommands> again = fromClient(content);
    EXPECT_EQ(commands->count, again ? again->count : 0);
    for (std::size_t i = 0; i < commands->count; ++i) {
      EXPECT_EQ(commands->commands[i].offset, again->commands[i].offset);
    }
    return content;
  }
  static Bytes acknowledgementOf(std::uint16_t sequence, std::uint8_t channel = kReliableChannel) {
    return acknowledgeContent(7, sequence, channel);
  }

  Port port_;
  EnetScope scope_{port_, std::chrono::seconds(1000)};
  std::unique_ptr<ENetHost, void (*)(ENetHost*)> host_;
  ENetPeer* peer_ = nullptr;
};

TEST_F(EnetOutstandingTest, AcknowledgementsOfWhatWasSentStay) {
  const Bytes both = joinedContents({acknowledgementOf(2), acknowledgementOf(1)});
  EXPECT_EQ(remainder(both), both);
}

TEST_F(EnetOutstandingTest, AcknowledgementsOfAnythingElseAreRemoved) {
  for (const Bytes& content : {acknowledgementOf(40000), acknowledgementOf(0), acknowledgementOf(3),
                               acknowledgementOf(1, kTickChannel), acknowledgementOf(2, 0xff)}) {
    EXPECT_EQ(remainder(content).size(), kCommandAt);
  }
}

TEST_F(EnetOutstandingTest, ARepeatedAcknowledgementCountsOnce) {
  EXPECT_EQ(remainder(joinedContents(std::vector<Bytes>(10, acknowledgementOf(1)))), acknowledgementOf(1));
}

TEST_F(EnetOutstandingTest, WhatStandsBesideAFalseAcknowledgementStays) {
  const Bytes message = reliableContent(7, 1, Bytes{1, 2, 3});
  const Bytes all = joinedContents({acknowledgementOf(9), message, acknowledgementOf(9), pingContent(7)});
  EXPECT_EQ(remainder(all), joinedContents({message, pingContent(7)}));
}

// ENet has moved it to the commands that wait until they are sent.
TEST_F(EnetOutstandingTest, WhatIsAboutToBeSentAgainIsOutstanding) {
  ENetOutgoingCommand* const first =
      reinterpret_cast<ENetOutgoingCommand*>(enet_list_front(&peer_->sentReliableCommands));
  enet_list_insert(enet_list_begin(&peer_->outgoingCommands), enet_list_remove(&first->outgoingCommandList));
  EXPECT_EQ(remainder(acknowledgementOf(1)), acknowledgementOf(1));
}

}  // namespace
}  // namespace platon::enet_layer_test
