#include "protocol/transport/client_gate.h"

#include <gtest/gtest.h>

#include "protocol/limits.h"
#include "protocol/transport/server_gate.h"
#include "tests/net/support/datagram_network.h"

namespace platon::client_gate_test {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

const SocketAddress kServer = addressAt("198.51.100.1", 7777);
const SocketAddress kOther = addressAt("2001:db8::1", 7777);
const SocketAddress kClient = addressAt("192.0.2.1", 4000);

class ClientGateTest : public testing::Test {
 protected:
  ClientGate client(const ServerKnowledge& knowledge = {}, std::vector<SocketAddress> servers = {kServer}) {
    return ClientGate(network_.socket(kClient), std::move(servers), knowledge, ephemeral_);
  }

  void exchange(ClientGate& client, int rounds = 3) {
    for (int i = 0; i < rounds; ++i) {
      client.update(now_);
      while (server_.receive(now_)) {
      }
      client.receive(now_);
      now_ += milliseconds(100);
    }
  }

  DatagramNetwork network_;
  KeyPair ephemeral_ = KeyPair::random();
  ServerIdentity identity_ = ServerIdentity::random();
  Time now_ = seconds(50);
  ServerGate server_{network_.socket(kServer), identity_, {4, 4, {}, false}, now_};
};

TEST_F(ClientGateTest, RepeatsItsRequestUntilItIsAnswered) {
  ClientGate gate = client();
  for (int ms = 0; ms <= 1000; ms += 10) gate.update(now_ + milliseconds(ms));
  EXPECT_EQ(network_.sent().size(), 5u);
  exchange(gate);
  EXPECT_EQ(gate.state(), ClientGate::State::kOpen);
}

TEST_F(ClientGateTest, JoinsInSpiteOfLosses) {
  int datagrams = 0;
  network_.setFilter([&](const auto&) { return ++datagrams % 3 != 1; });
  ClientGate gate = client();
  exchange(gate, 40);
  EXPECT_EQ(gate.state(), ClientGate::State::kOpen);
}

TEST_F(ClientGateTest, KnocksAtAllAddressesAndUsesTheOneThatAnswers) {
  ClientGate gate = client({}, {kOther, kServer});
  exchange(gate);
  EXPECT_EQ(gate.state(), ClientGate::State::kOpen);
  EXPECT_EQ(gate.server(), kServer);
}

TEST_F(ClientGateTest, RefusesAnotherIdentityThanTheOneItKnows) {
  ClientGate known = client({identity_.publicKey()});
  exchange(known);
  EXPECT_EQ(known.state(), ClientGate::State::kOpen);
  ephemeral_ = KeyPair::random();
  ClientGate stranger = client({ServerIdentity::random().publicKey()});
  exchange(stranger);
  EXPECT_EQ(stranger.state(), ClientGate::State::kAnotherIdentity);
}

// Somebody who answers with the identity of another server does not have its secret key.
TEST_F(ClientGateTest, AnIdentityMustBeProved) {
  const ServerIdentity thief(ServerIdentity::random());
  ClientGate gate = client();
  network_.setFilter([&](const auto& each) { return each.from != kServer; });
  gate.update(now_);
  ServerGate fake(network_.socket(kServer), thief, {4, 4, {}, false}, now_);
  fake.receive(now_);
  auto reply = decodeCookieReply(network_.sent().back().bytes);
  ASSERT_TRUE(reply);
  reply->identity = identity_.publicKey();
  network_.inject(kServer, kClient, encode(*reply));
  gate.receive(now_);
  fake.receive(now_);
  EXPECT_EQ(fake.rejections().password, 1u);  // it cannot read what the client sends
  network_.inject(kServer, kClient, encode(Accept{echoOf(ephemeral_.publicKey), {}}));
  gate.receive(now_);
  EXPECT_EQ(gate.state(), ClientGate::State::kHandshake);
}

TEST_F(ClientGateTest, AnswersWithoutTheEchoOfItsKeyAreIgnored) {
  ClientGate gate = client();
  gate.update(now_);
  network_.inject(kServer, kClient, encode(Refusal{1, Echo{}, RefusalReason::kFull, ""}));
  network_.inject(kServer, kClient, encode(CookieReply{Echo{}, false, identity_.publicKey(), {}}));
  network_.inject(kServer, kClient, encode(Accept{}));
  gate.receive(now_);
  EXPECT_EQ(gate.state(), ClientGate::State::kHandshake);
  EXPECT_EQ(network_.sent().size(), 1u);
}

TEST_F(ClientGateTest, DatagramsOfOthersAreIgnored) {
  ClientGate gate = client();
  gate.update(now_);
  network_.inject(kOther, kClient, encode(Refusal{1, echoOf(ephemeral_.publicKey), RefusalReason::kFull, ""}));
  gate.receive(now_);
  EXPECT_EQ(gate.state(), ClientGate::State::kHandshake);
}

TEST_F(ClientGateTest, AnOpenGateCannotBeClosedFromOutside) {
  ClientGate gate = client();
  exchange(gate);
  ASSERT_EQ(gate.state(), ClientGate::State::kOpen);
  network_.inject(kServer, kClient, encode(Refusal{1, echoOf(ephemeral_.publicKey), RefusalReason::kFull, ""}));
  network_.inject(kServer, kClient, Bytes(60, 0xff));
  network_.inject(kServer, kClient, Bytes(1, 0x80));
  EXPECT_FALSE(gate.receive(now_));
  EXPECT_EQ(gate.state(), ClientGate::State::kOpen);
}

// A flood that comes faster than it is read held the client in its loop.
TEST_F(ClientGateTest, ARoundTakesALimitedNumberOfDatagrams) {
  ClientGate gate = client();
  gate.beginRound();
  for (std::size_t i = 0; i < ClientGate::kMaxDatagramsPerRound + 10; ++i) {
    network_.inject(i % 2 == 0 ? kServer : kOther, kClient, Bytes(i % 3 == 0 ? 0 : kMaxDatagramBytes + 1));
  }
  EXPECT_FALSE(gate.receive(now_));
  EXPECT_EQ(gate.traffic().receivedPackets, ClientGate::kMaxDatagramsPerRound);
  gate.beginRound();
  EXPECT_FALSE(gate.receive(now_));
  EXPECT_EQ(gate.traffic().receivedPackets, ClientGate::kMaxDatagramsPerRound + 10);
}

TEST_F(ClientGateTest, ContentsThatDoNotFitAreNotSent) {
  ClientGate gate = client();
  exchange(gate);
  const std::size_t before = network_.sent().size();
  gate.send(Bytes(kMaxDatagramBytes - SealedChannel::kOverhead + 1), now_);
  EXPECT_EQ(network_.sent().size(), before);
  gate.send(Bytes(kMaxDatagramBytes - SealedChannel::kOverhead), now_);
  EXPECT_EQ(network_.sent().back().bytes.size(), kMaxDatagramBytes);
}

}  // namespace
}  // namespace platon::client_gate_test
