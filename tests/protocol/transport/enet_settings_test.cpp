#include "protocol/transport/enet_settings.h"

#include <gtest/gtest.h>

#include <memory>
#include <vector>

#include "protocol/transport/enet_calls.h"

namespace platon::enet_settings_test {
namespace {

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
  const auto serviceAt = [&](Moment now, bool may) {
    const EnetScope scope(port_, now);
    int asked = 0;
    limitRetransmissionTimeout(*peer_, 70);
    postponeRetransmissions(*peer_, enet_time_get(), [&](const ENetOutgoingCommand&) { return ++asked > 0 && may; });
    ENetEvent event{};
    serviceEnet(*host_, event);
    return asked;
  };
  using std::chrono::milliseconds;
  const Moment sent = std::chrono::seconds(1000);
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

}  // namespace
}  // namespace platon::enet_settings_test
