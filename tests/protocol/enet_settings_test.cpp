#include "protocol/enet_settings.h"

#include <gtest/gtest.h>

#include <memory>

namespace platon {
namespace {

/// A connection that begins, to a loopback port without a server.
class EnetSettingsTest : public testing::Test {
 protected:
  EnetSettingsTest() : host_(enet_host_create(nullptr, 1, kChannels, 0, 0), enet_host_destroy) {
    setEnetTime(std::chrono::seconds(1000));
    ENetAddress address{};
    enet_address_set_host_ip(&address, "127.0.0.1");
    address.port = 1;
    peer_ = enet_host_connect(host_.get(), &address, kChannels, 0);
  }

  std::unique_ptr<ENetHost, void (*)(ENetHost*)> host_;
  ENetPeer* peer_ = nullptr;
};

TEST_F(EnetSettingsTest, EnetsClockIsTheGivenTimeInMilliseconds) {
  setEnetTime(std::chrono::microseconds(5'000'999));
  EXPECT_EQ(enet_time_get(), 5000u);
}

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
  unthrottle(*peer_);
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
}  // namespace platon
