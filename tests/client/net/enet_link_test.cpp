#include "client/net/enet_link.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "protocol/limits.h"
#include "protocol/transport/server_identity.h"
#include "protocol/version_text.h"
#include "server/net/host.h"
#include "tests/net/support/datagram_network.h"

namespace platon::enet_link_test {
namespace {

using std::chrono::milliseconds;

const SocketAddress kServer = addressAt("198.51.100.1", 7777);
const SocketAddress kClient = addressAt("192.0.2.1", 4000);

/// A client's connection and the server's host, in memory and in virtual time.
class EnetLinkTest : public testing::Test {
 protected:
  // One millisecond of both sides.
  void step() {
    now_ += milliseconds(1);
    stepServer();
    link_.service(now_, [this](std::span<const std::uint8_t> message) {
      received_.emplace_back(message.begin(), message.end());
    });
    link_.flush(now_);
  }

  void stepServer() {
    for (const HostEvent& event : host_.service(now_)) {
      client_ = event.client;
      if (event.disconnected) ++disconnects_;
      if (!event.disconnected) atServer_.emplace_back(event.bytes.begin(), event.bytes.end());
    }
    host_.flush(now_);
  }

  template <class Done>
  bool stepUntil(Done done) {
    for (int ms = 0; ms < 5000 && !done(); ++ms) step();
    return done();
  }

  // Connects and sends a first message, so that the server knows the client's number.
  void connect() {
    ASSERT_TRUE(stepUntil([this] { return link_.state() == EnetLink::State::kConnected; }));
    link_.send(Bytes{1, 2, 3}, true);
    ASSERT_TRUE(stepUntil([this] { return !atServer_.empty(); }));
    host_.admit(client_);
  }

  DatagramNetwork network_;
  Time now_ = std::chrono::seconds(1000);
  ServerIdentity identity_ = ServerIdentity::random();
  std::optional<std::string> ban_;  // why nobody may join
  Host host_{network_.socket(kServer), identity_, {}, now_, {.ban = [this](const IpAddress&) { return ban_; }}};
  EnetLink link_{network_.socket(kClient), {kServer}, {}};
  ClientId client_ = 0;
  int disconnects_ = 0;
  std::vector<Bytes> atServer_;
  std::vector<Bytes> received_;
};

TEST_F(EnetLinkTest, DeliversMessagesBothWays) {
  EXPECT_EQ(link_.state(), EnetLink::State::kConnecting);
  connect();
  EXPECT_EQ(atServer_.front(), (Bytes{1, 2, 3}));
  host_.send(client_, true, Bytes{4});
  host_.send(client_, false, Bytes{5, 6});
  ASSERT_TRUE(stepUntil([this] { return received_.size() == 2; }));
  std::sort(received_.begin(), received_.end());
  EXPECT_EQ(received_, (std::vector<Bytes>{{4}, {5, 6}}));
}

TEST_F(EnetLinkTest, KnowsTheServersIdentity) {
  EXPECT_FALSE(link_.identity());
  connect();
  EXPECT_EQ(link_.identity(), identity_.publicKey());
}

// A kick, as everybody could forge it while ENet's ids were the only secret.
TEST_F(EnetLinkTest, NothingFromOutsideEndsIt) {
  connect();
  for (const auto& each : network_.sent()) network_.inject(each.from, each.to, each.bytes);
  network_.inject(kServer, kClient, Bytes(40, 0xff));
  network_.inject(kServer, kClient, encode(Refusal{3, {}, RefusalReason::kBanned, ""}));
  for (int ms = 0; ms < 100; ++ms) step();
  EXPECT_EQ(link_.state(), EnetLink::State::kConnected);
  EXPECT_EQ(disconnects_, 0);
}

TEST_F(EnetLinkTest, SaysWhyTheServerRefusesIt) {
  ban_ = "banned for a day";
  ASSERT_TRUE(stepUntil([this] { return link_.state() == EnetLink::State::kClosed; }));
  ASSERT_TRUE(link_.refused());
  EXPECT_EQ(link_.refused()->reason, "banned for a day");
  EXPECT_TRUE(link_.refused()->permanent);
}

TEST_F(EnetLinkTest, SendsNothingUntilConnected) {
  link_.send(Bytes{9}, true);
  connect();
  EXPECT_EQ(atServer_, (std::vector<Bytes>{{1, 2, 3}}));
}

TEST_F(EnetLinkTest, ClosesAfterQueuedMessagesHaveArrived) {
  connect();
  link_.send(Bytes(500, 7), true);
  link_.close();
  ASSERT_TRUE(stepUntil([this] { return link_.state() == EnetLink::State::kClosed; }));
  EXPECT_EQ(atServer_.back(), Bytes(500, 7));
  EXPECT_TRUE(stepUntil([this] { return disconnects_ == 1; }));
}

TEST_F(EnetLinkTest, CountsItsTraffic) {
  connect();
  const Traffic before = link_.traffic();
  EXPECT_GT(before.sentPackets, 1u);
  EXPECT_GT(before.receivedPackets, 0u);
  host_.send(client_, false, Bytes(1000, 3));
  ASSERT_TRUE(stepUntil([this] { return !received_.empty(); }));
  EXPECT_GT((link_.traffic() - before).receivedBytes, 1000u);
  EXPECT_GT(link_.traffic().longestDatagram, 1000u);
}

// A server that sends faster than the client handles messages must not stop the client.
TEST_F(EnetLinkTest, ServiceDeliversABoundedNumberOfMessages) {
  constexpr std::size_t kMessages = 3 * EnetLink::kMaxMessagesPerService;
  connect();
  for (std::size_t i = 0; i < kMessages; ++i) {
    host_.send(client_, false, Bytes{static_cast<std::uint8_t>(i), static_cast<std::uint8_t>(i >> 8)});
    if (i % 16 == 0) stepServer();
  }
  std::size_t largest = 0;
  ASSERT_TRUE(stepUntil([&] {
    const std::size_t before = received_.size();
    step();
    largest = std::max(largest, received_.size() - before);
    return received_.size() == kMessages;
  }));
  EXPECT_EQ(largest, EnetLink::kMaxMessagesPerService);
  for (std::size_t i = 0; i < kMessages; ++i) {
    ASSERT_EQ(received_[i], (Bytes{static_cast<std::uint8_t>(i), static_cast<std::uint8_t>(i >> 8)}));
  }
}

// What a client says whose handshake is answered with this refusal.
EnetLink::Refused refusedWith(std::uint32_t version, RefusalReason reason, const std::string& text = "") {
  DatagramNetwork network;
  const KeyPair keys = KeyPair::random();
  ClientGate gate(network.socket(kClient), {kServer}, {}, keys);
  gate.update(Time{});
  network.inject(kServer, kClient,
                 encode(Refusal{static_cast<std::uint16_t>(version), echoOf(keys.publicKey), reason, text}));
  gate.receive(Time{});
  return refusalOf(gate);
}

TEST(RefusalText, SaysWhichProgramToUpdate) {
  const EnetLink::Refused newer = refusedWith(kProtocolVersion + 1, RefusalReason::kWrongVersion);
  EXPECT_TRUE(newer.permanent);
  EXPECT_EQ(newer.reason, otherVersionText("protocol", kProtocolVersion + 1, kProtocolVersion));
  const EnetLink::Refused older = refusedWith(kProtocolVersion - 1, RefusalReason::kWrongVersion);
  EXPECT_EQ(older.reason, otherVersionText("protocol", kProtocolVersion - 1, kProtocolVersion));
}

TEST(RefusalText, EveryReasonHasItsSentence) {
  EXPECT_EQ(refusedWith(kProtocolVersion, RefusalReason::kPassword).reason, "the password is wrong");
  EXPECT_EQ(refusedWith(kProtocolVersion, RefusalReason::kBanned, "banned for a day").reason, "banned for a day");
  EXPECT_EQ(refusedWith(kProtocolVersion, RefusalReason::kBanned).reason, "you are banned from this server");
  EXPECT_EQ(refusedWith(kProtocolVersion, RefusalReason::kBanned, "\u200b").reason, "you are banned from this server");
  EXPECT_FALSE(refusedWith(kProtocolVersion, RefusalReason::kFull).permanent);
  EXPECT_FALSE(refusedWith(kProtocolVersion, RefusalReason::kAddress).permanent);
}

TEST(RefusalText, SaysThatAPasswordOrTheKnownServerIsMissing) {
  DatagramNetwork network;
  const KeyPair keys = KeyPair::random();
  const CryptoKey identity = ServerIdentity::random().publicKey();
  const auto textFor = [&](const ServerKnowledge& knowledge, bool needsPassword = true) {
    ClientGate gate(network.socket(kClient), {kServer}, knowledge, keys);
    gate.update(Time{});
    network.inject(kServer, kClient, encode(CookieReply{echoOf(keys.publicKey), needsPassword, identity, {}}));
    gate.receive(Time{});
    return refusalOf(gate).reason;
  };
  EXPECT_NE(textFor({}).find("--password-file"), std::string::npos);
  EXPECT_NE(textFor({CryptoKey{1}}).find("known_servers"), std::string::npos);
  EXPECT_EQ(textFor({std::nullopt, Password("sesame")}, false),
            "the server needs no password: join without one if that is right");
}

}  // namespace
}  // namespace platon::enet_link_test
