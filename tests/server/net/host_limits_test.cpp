// What clients can use up, and those who try.
#include <gtest/gtest.h>

#include "protocol/limits.h"
#include "server/net/host.h"
#include "tests/server/net/host_fixture.h"

namespace platon::host_limits_test {
namespace {

using namespace std::chrono_literals;

class HostLimitsTest : public HostTest {};

/// A host with a hostile client that plays.
class UnacknowledgedTest : public HostTest {
 protected:
  UnacknowledgedTest() {
    eve_.connect(host_, now_);
    eve_.send(reliableContent(eve_.peer(), 1, 5), now_);
    player_ = host_.service(now_).front().client;
    host_.admit(player_);
  }

  // Reliable messages of 1 000 bytes.
  void say(int messages) {
    for (int i = 0; i < messages; ++i) host_.send(player_, true, Bytes(1000));
    host_.flush(now_);
  }
  void acknowledge(std::uint16_t sequence) {
    eve_.send(acknowledgeContent(eve_.peer(), sequence, kReliableChannel, time()), now_);
  }
  // Sends the content a hundred times a second for nine seconds, and counts the messages that are sent meanwhile.
  template <class Content>
  std::size_t messagesSentDuring(Content content) {
    const std::size_t before = bytesToEve();
    say(40);
    for (const Time end = now_ + 9s; now_ < end; now_ += 10ms) {
      eve_.send(content(), now_);
      host_.service(now_);
      host_.flush(now_);
    }
    return (bytesToEve() - before) / 1000;
  }
  Bytes acknowledgementOfAll(std::uint16_t time) const {
    std::vector<Bytes> contents;
    for (std::uint16_t sequence = 1; sequence <= 4; ++sequence) {
      contents.push_back(acknowledgeContent(eve_.peer(), sequence, kReliableChannel, time));
    }
    return joinedContents(contents);
  }
  std::size_t bytesToEve() const { return network_.bytesTo(kEve); }
  std::uint16_t time() const { return static_cast<std::uint16_t>(now_ / 1ms); }

  ClientId player_ = 0;
};

// 0.26 kB/s of them made the server send 50 kB/s for ever.
TEST_F(UnacknowledgedTest, AcknowledgementsOfWhatWasNeverSentKeepNoConnectionOpen) {
  say(1);
  host_.service(now_);
  const Time said = now_;
  for (now_ += 250ms; now_ < said + 10s; now_ += 250ms) {
    acknowledge(40000);
    ASSERT_TRUE(host_.service(now_).empty()) << (now_ - said) / 1ms << " ms";
  }
  acknowledge(40000);
  ASSERT_EQ(host_.service(said + 10s).size(), 1u);
  EXPECT_TRUE(host_.empty());
  EXPECT_EQ(host_.rejections().slow, 1u);
}

TEST_F(UnacknowledgedTest, TheTimeInAnAcknowledgementOfWhatWasNeverSentIsNotBelieved) {
  now_ += 5s;
  const std::uint32_t before = host_.roundTripMs(player_);
  eve_.send(acknowledgeContent(eve_.peer(), 40000, kReliableChannel, static_cast<std::uint16_t>(time() - 4000)), now_);
  host_.service(now_);
  EXPECT_EQ(host_.roundTripMs(player_), before);
}

TEST_F(UnacknowledgedTest, WhatStandsBesideAFalseAcknowledgementArrives) {
  eve_.send(joinedContents({acknowledgeContent(eve_.peer(), 40000, kReliableChannel),
                            reliableContent(eve_.peer(), 2, Bytes{7, 8})}),
            now_);
  const std::span<const HostEvent> events = host_.service(now_);
  ASSERT_EQ(events.size(), 1u);
  EXPECT_EQ(Bytes(events[0].bytes.begin(), events[0].bytes.end()), (Bytes{7, 8}));
}

// The first message stays, however fast the later ones are acknowledged.
TEST_F(UnacknowledgedTest, AConnectionEndsTenSecondsAfterItsOldestMessageWasSent) {
  say(1);
  host_.service(now_);
  const Time said = now_;
  for (std::uint16_t sequence = 2; (now_ += 250ms) < said + 10s; ++sequence) {
    host_.send(player_, true, Bytes(10));
    host_.flush(now_);
    acknowledge(sequence);
    ASSERT_TRUE(host_.service(now_).empty()) << (now_ - said) / 1ms << " ms";
  }
  ASSERT_EQ(host_.service(said + 10s).size(), 1u);
  EXPECT_EQ(host_.rejections().slow, 1u);
}

// 4 096 bytes, then 384 a second, 1 536 of them at once, each message with 26 bytes more.
TEST_F(UnacknowledgedTest, WhoAcknowledgesNothingIsSentFourMessagesAndFewOfThemAgain) {
  const std::size_t before = bytesToEve();
  say(40);
  for (const Time end = now_ + 9s; now_ < end; now_ += 10ms) {
    if (now_ / 1ms % 250 == 0) acknowledge(40000);
    host_.service(now_);
  }
  EXPECT_EQ((bytesToEve() - before) / 1000, 4u + (1536 + 9 * 384) / 1026);
}

TEST_F(UnacknowledgedTest, WhoAcknowledgesIsSentThreeTimesAsMuchAtOnce) {
  const std::size_t before = bytesToEve();
  say(40);
  EXPECT_EQ((bytesToEve() - before) / 1000, 4u);
  for (std::uint16_t sequence = 1; sequence <= 4; ++sequence) acknowledge(sequence);
  host_.service(now_);  // the window grows after it
  host_.flush(now_);
  EXPECT_EQ((bytesToEve() - before) / 1000, 4u + 12);
}

// ENet ignores them, so that each could be repeated without end, and each let the server send more again.
TEST_F(UnacknowledgedTest, AcknowledgementsWithATimeInTheFutureEarnNothing) {
  const auto content = [this] { return acknowledgementOfAll(static_cast<std::uint16_t>(time() + 1)); };
  EXPECT_EQ(messagesSentDuring(content), 4u + (1536 + 9 * 384) / 1026);
}

// A ping without a time ends what ENet reads of a datagram.
TEST_F(UnacknowledgedTest, AcknowledgementsThatEnetDoesNotReadEarnNothing) {
  const auto content = [this] {
    Bytes untimed = joinedContents({pingContent(eve_.peer()), acknowledgementOfAll(time())});
    untimed[0] &= 0x7f;
    untimed.erase(untimed.begin() + 2, untimed.begin() + kCommandAt);
    return untimed;
  };
  EXPECT_EQ(messagesSentDuring(content), 4u + (1536 + 9 * 384) / 1026);
}

TEST_F(HostLimitsTest, AfterAnInterruptionOfFourSecondsAllMessagesArrive) {
  const ClientId client = connect();
  host_.admit(client);
  for (int i = 0; i < 100; ++i) host_.send(client, true, Bytes(1000, static_cast<std::uint8_t>(i)));
  ASSERT_TRUE(run([this] { return received_.size() >= 10; }));
  const Time interrupted = now_;
  network_.setFilter([this, interrupted](const auto&) { return now_ - interrupted >= 4s; });
  EXPECT_TRUE(run([this] { return received_.size() == 100; }));
  EXPECT_LE(now_ - interrupted, 8s);
  EXPECT_TRUE(host_.isOpen(client));
}

// 10 800 connections a second were free: ENet ends one that is not confirmed without an event.
TEST_F(HostLimitsTest, ASessionWhoseConnectionHasEndedGetsNoOther) {
  eve_.join(host_, now_);
  eve_.send(connectContent(77), now_);
  eve_.step(host_, now_);
  for (std::uint32_t id = 100; id < 110; ++id) {
    eve_.send(disconnectContent(eve_.peer()), now_);
    eve_.send(connectContent(id), now_);
  }
  host_.service(now_);
  EXPECT_EQ(host_.rejections().content, 10u);
  EXPECT_TRUE(host_.empty());
  const std::uint64_t before = host_.rejections().seal;
  eve_.send(connectContent(200), now_);
  host_.service(now_);
  EXPECT_EQ(host_.rejections().seal, before + 1) << "the session has ended too";
}

TEST_F(HostLimitsTest, ARequestToConnectIsChargedToItsConnection) {
  eve_.join(host_, now_);
  for (int i = 0; i < 301; ++i) eve_.send(connectContent(77), now_);
  host_.service(now_);
  EXPECT_EQ(host_.rejections().excess, 1u);
}

// It began with the budget that the one before had used up.
TEST_F(HostLimitsTest, AConnectionInheritsNothingOfTheOneBeforeInItsPlace) {
  HostileClient mallory(network_, addressAt("192.0.2.67", 4000), kServer);
  mallory.join(host_, now_);
  eve_.join(host_, now_);
  eve_.send(connectContent(77), now_);
  eve_.step(host_, now_);
  for (int i = 0; i < 299; ++i) eve_.send(pingContent(eve_.peer()), now_);
  host_.service(now_);
  EXPECT_EQ(host_.rejections().excess, 0u);
  now_ += 10ms;
  eve_.send(disconnectContent(eve_.peer()), now_);
  mallory.send(connectContent(78), now_);
  mallory.step(host_, now_);
  for (int i = 0; i < 290; ++i) mallory.send(pingContent(mallory.peer()), now_);
  host_.service(now_);
  EXPECT_EQ(host_.rejections().excess, 0u);
  EXPECT_EQ(mallory.peer() & ENET_PROTOCOL_MAXIMUM_PEER_ID, eve_.peer() & ENET_PROTOCOL_MAXIMUM_PEER_ID);
  const std::uint64_t before = host_.rejections().seal;
  eve_.send(pingContent(eve_.peer()), now_);
  host_.service(now_);
  EXPECT_EQ(host_.rejections().seal, before + 1) << "the session before has ended";
}

}  // namespace
}  // namespace platon::host_limits_test
