#include "protocol/transport/server_gate.h"

#include <gtest/gtest.h>

#include "protocol/limits.h"
#include "protocol/transport/client_gate.h"
#include "tests/net/support/server_gate_fixture.h"

namespace platon::server_gate_test {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

TEST_F(ServerGateTest, AClientJoinsAndContentsPassBothWays) {
  start();
  ClientGate client = join(clientAt(1));
  ASSERT_EQ(client.state(), ClientGate::State::kOpen);
  EXPECT_EQ(client.identity(), identity_.publicKey());
  const SessionId session = sessionOf(client);
  EXPECT_TRUE(gate_->isOpen(session));
  EXPECT_EQ(gate_->addressOf(session), clientAt(1).ip);
  gate_->send(session, Bytes{42}, now_);
  EXPECT_EQ(client.receive(now_), Bytes{42});
  gate_->close(session);
  client.send(kContent, now_);
  EXPECT_TRUE(receive().empty());
  EXPECT_EQ(gate_->rejections().seal, 1u);
}

// The session after number 2^32 - 1 had the number of no session: it passed contents and could not be closed.
TEST_F(ServerGateTest, NumbersOfSessionsOverflow) {
  GateSettings settings{4, 2, {}, false};
  settings.firstNumber = UINT32_MAX;
  start(settings);
  ClientGate last = join(clientAt(1));
  ClientGate first = join(clientAt(2));
  EXPECT_EQ(sessionOf(last).number, UINT32_MAX);
  EXPECT_EQ(sessionOf(first).number, 1u);
}

TEST_F(ServerGateTest, UntilACookieIsReturnedNothingIsKeptAndNoMoreIsSentThanCame) {
  start();
  std::size_t knocked = 0;
  for (int i = 1; i < 200; ++i) {
    const Bytes knock = encode(Knock{static_cast<std::uint16_t>(kProtocolVersion), KeyPair::random().publicKey});
    network_.inject(clientAt(i), kServer, knock);
    knocked += knock.size();
  }
  EXPECT_TRUE(receive().empty());
  std::size_t answered = 0;
  for (const auto& each : network_.sent()) answered += each.bytes.size();
  EXPECT_GT(answered, 0u);
  EXPECT_LE(answered, knocked);
  EXPECT_EQ(join(clientAt(201)).state(), ClientGate::State::kOpen);
}

TEST_F(ServerGateTest, AClientOfAnotherVersionIsToldTheServers) {
  start();
  const CryptoKey key = KeyPair::random().publicKey;
  network_.inject(clientAt(1), kServer, encode(Knock{99, key}));
  receive();
  const auto answers = sent(kServer, clientAt(1));
  ASSERT_EQ(answers.size(), 1u);
  const auto refusal = decodeRefusal(answers[0]);
  ASSERT_TRUE(refusal);
  EXPECT_EQ(refusal->reason, RefusalReason::kWrongVersion);
  EXPECT_EQ(refusal->version, kProtocolVersion);
  EXPECT_EQ(refusal->echo, echoOf(key));
  EXPECT_EQ(gate_->rejections().version, 1u);
}

TEST_F(ServerGateTest, ACookieOfAnotherAddressIsWorthless) {
  start();
  ClientGate client = join(clientAt(1));
  const Bytes open = sent(clientAt(1), kServer)[1];
  ASSERT_TRUE(decodeOpen(open));
  const std::size_t before = network_.sent().size();
  network_.inject(clientAt(2), kServer, open);
  receive();
  EXPECT_EQ(network_.sent().size(), before);
  EXPECT_EQ(gate_->rejections().cookie, 1u);
}

TEST_F(ServerGateTest, ARepeatedOpenGetsTheSameAcceptAndNoSecondSession) {
  start();
  ClientGate client = join(clientAt(1));
  const Bytes open = sent(clientAt(1), kServer)[1];
  const Bytes accept = sent(kServer, clientAt(1))[1];
  network_.inject(clientAt(1), kServer, open);
  receive();
  EXPECT_EQ(sent(kServer, clientAt(1)).back(), accept);
  const SessionId session = sessionOf(client);
  network_.inject(clientAt(1), kServer, open);
  receive();
  EXPECT_EQ(sent(kServer, clientAt(1)).size(), 3u);  // the client is using the session: it needs no Accept
  gate_->close(session);
  network_.inject(clientAt(1), kServer, open);
  receive();
  EXPECT_EQ(sent(kServer, clientAt(1)).size(), 3u);  // a recorded handshake opens no session
  EXPECT_EQ(gate_->rejections().cookie, 1u);
}

TEST_F(ServerGateTest, OnlyWhoKnowsThePasswordJoins) {
  GateSettings settings{4, 4, presharedKeyOf("sesame", identity_.publicKey()), true};
  start(settings);
  EXPECT_EQ(join(clientAt(1)).state(), ClientGate::State::kNoPassword);
  ClientGate wrong = join(clientAt(2), "Sesame");
  ASSERT_EQ(wrong.state(), ClientGate::State::kRefused);
  EXPECT_EQ(wrong.refusal()->reason, RefusalReason::kPassword);
  EXPECT_EQ(join(clientAt(3), "sesame").state(), ClientGate::State::kOpen);
  EXPECT_EQ(gate_->rejections().password, 1u);
}

TEST_F(ServerGateTest, AClientWithAPasswordDoesNotJoinAServerThatAsksForNone) {
  start();
  EXPECT_EQ(join(clientAt(1), "sesame").state(), ClientGate::State::kNoPasswordAsked);
}

TEST_F(ServerGateTest, ASessionIsChallengedAtMostTenTimesASecond) {
  start();
  ClientGate client = join(clientAt(1));
  sessionOf(client);
  network_.setFilter([](const auto& each) { return each.to != kServer; });
  const std::size_t before = sent(kServer, clientAt(1)).size();
  std::size_t challenges = 0;
  for (int i = 0; i < 1000; ++i) {
    const SocketAddress moved = addressAt("203.0.113.9", static_cast<std::uint16_t>(1000 + i));
    client.send(kContent, now_);
    network_.inject(moved, kServer, network_.sent().back().bytes);
    receive();
    challenges += sent(kServer, moved).size();
    now_ += milliseconds(1);
  }
  EXPECT_EQ(challenges, 10u);
  EXPECT_EQ(sent(kServer, clientAt(1)).size(), before + 5) << "after half a second it is asked too";
}

TEST_F(ServerGateTest, ABannedAddressIsToldWhy) {
  start();
  std::vector<IpAddress> noticed;
  rules_.ban = [](const IpAddress& ip) {
    return ip == clientAt(1).ip ? std::optional<std::string>("until tomorrow") : std::nullopt;
  };
  rules_.banned = [&noticed](const IpAddress& ip) { noticed.push_back(ip); };
  ClientGate client = join(clientAt(1));
  ASSERT_EQ(client.state(), ClientGate::State::kRefused);
  EXPECT_EQ(client.refusal()->reason, RefusalReason::kBanned);
  EXPECT_EQ(client.refusal()->text, "until tomorrow");
  EXPECT_EQ(join(clientAt(2)).state(), ClientGate::State::kOpen);
  EXPECT_EQ(noticed, std::vector{clientAt(1).ip});
  EXPECT_EQ(gate_->rejections().banned, 1u);
}

// Anybody can write the address of somebody else into a datagram.
TEST_F(ServerGateTest, AForgedBannedAddressCausesNoNotice) {
  start();
  std::size_t notices = 0;
  ClientGate client = join(clientAt(1));
  sessionOf(client);
  const SocketAddress banned = addressAt("203.0.113.9", 999);
  rules_.ban = [&](const IpAddress& ip) {
    return ip == banned.ip ? std::optional<std::string>("until tomorrow") : std::nullopt;
  };
  rules_.banned = [&notices](const IpAddress&) { ++notices; };
  network_.setFilter([](const auto& each) { return each.to != kServer; });
  client.send(kContent, now_);
  network_.inject(banned, kServer, network_.sent().back().bytes);
  EXPECT_EQ(receive().size(), 1u);
  ClientGate other(network_.socket(clientAt(2)), {kServer}, {}, KeyPair::random());
  other.update(now_);
  network_.inject(banned, kServer, network_.sent().back().bytes);  // its Knock
  receive();
  EXPECT_EQ(sent(kServer, banned).size(), 1u);  // a cookie, and no challenge
  EXPECT_EQ(notices, 0u);
  EXPECT_EQ(gate_->rejections().banned, 0u);
}

// Routers give a connection another port from time to time.
TEST_F(ServerGateTest, AClientThatMovesIsFollowedOnceItHasAnsweredThere) {
  start();
  ClientGate client = join(clientAt(1));
  const SessionId session = sessionOf(client);
  const SocketAddress moved = addressAt("203.0.113.9", 999);
  client.send(kContent, now_);
  const Bytes datagram = network_.sent().back().bytes;
  receive();  // from the old address
  client.send(kContent, now_);
  const Bytes fromElsewhere = network_.sent().back().bytes;
  receive();
  // Both were received; one that was not is delivered from the new address only.
  network_.setFilter([](const auto& each) { return each.to != kServer; });
  client.send(kContent, now_);
  network_.inject(moved, kServer, network_.sent().back().bytes);
  EXPECT_EQ(receive().size(), 1u);
  EXPECT_EQ(gate_->addressOf(session), clientAt(1).ip);
  const auto challenges = sent(kServer, moved);
  ASSERT_EQ(challenges.size(), 1u);
  EXPECT_LE(challenges[0].size(), network_.sent().back().bytes.size() + 20);
  network_.inject(kServer, clientAt(1), challenges[0]);  // the client receives at both
  client.receive(now_);
  network_.inject(moved, kServer, network_.sent().back().bytes);
  receive();
  EXPECT_EQ(gate_->addressOf(session), moved.ip);
  gate_->send(session, Bytes{3}, now_);
  EXPECT_EQ(network_.sent().back().to, moved);
}

TEST_F(ServerGateTest, AClientIsNotFollowedToAnAddressThatIsBannedSinceTheChallenge) {
  start();
  ClientGate client = join(clientAt(1));
  const SessionId session = sessionOf(client);
  const SocketAddress moved = addressAt("203.0.113.9", 999);
  network_.setFilter([](const auto& each) { return each.to != kServer; });
  client.send(kContent, now_);
  network_.inject(moved, kServer, network_.sent().back().bytes);
  EXPECT_EQ(receive().size(), 1u);
  rules_.ban = [&](const IpAddress& ip) {
    return ip == moved.ip ? std::optional<std::string>("until tomorrow") : std::nullopt;
  };
  network_.inject(kServer, clientAt(1), sent(kServer, moved).at(0));
  client.receive(now_);
  network_.inject(moved, kServer, network_.sent().back().bytes);
  receive();
  EXPECT_EQ(gate_->addressOf(session), clientAt(1).ip);
  EXPECT_EQ(gate_->rejections().banned, 1u);
}

TEST_F(ServerGateTest, ADatagramFromElsewhereDoesNotDirectTheServerThere) {
  start();
  ClientGate client = join(clientAt(1));
  const SessionId session = sessionOf(client);
  network_.setFilter([](const auto& each) { return each.to != kServer; });
  const SocketAddress victim = addressAt("203.0.113.9", 999);
  std::size_t injected = 0;
  for (int i = 0; i < 100; ++i) {
    client.send(kContent, now_);
    const Bytes datagram = network_.sent().back().bytes;
    network_.inject(victim, kServer, datagram);
    injected += datagram.size();
    receive();
    gate_->send(session, Bytes(500), now_);
    now_ += milliseconds(20);
  }
  EXPECT_GT(network_.bytesTo(victim), 0u);
  EXPECT_LE(network_.bytesTo(victim), injected);
  EXPECT_EQ(gate_->addressOf(session), clientAt(1).ip);
}

TEST_F(ServerGateTest, AWrongAnswerToAChallengeMovesNothing) {
  start();
  ClientGate client = join(clientAt(1));
  const SessionId session = sessionOf(client);
  network_.setFilter([](const auto& each) { return each.to != kServer; });
  const SocketAddress moved = addressAt("203.0.113.9", 999);
  client.send(kContent, now_);
  network_.inject(moved, kServer, network_.sent().back().bytes);
  EXPECT_EQ(receive().size(), 1u);
  ASSERT_EQ(sent(kServer, moved).size(), 1u);
  client.sendControl(Bytes{2, 0, 0, 0, 0, 0, 0, 0, 0}, now_);
  network_.inject(moved, kServer, network_.sent().back().bytes);
  receive();
  EXPECT_EQ(gate_->addressOf(session), clientAt(1).ip);
}

TEST_F(ServerGateTest, AnswersQueries) {
  start();
  Info info;
  info.players = 3;
  info.maxPlayers = 16;
  info.name = "Here";
  info.program = "1.0";
  gate_->setInfo(info);
  network_.inject(clientAt(1), kServer, encode(Query{99}));
  receive();
  const auto answers = sent(kServer, clientAt(1));
  ASSERT_EQ(answers.size(), 1u);
  info.version = kProtocolVersion;
  info.nonce = 99;
  info.identity = identity_.publicKey();
  EXPECT_EQ(decodeInfo(answers[0]), info);
}

TEST_F(ServerGateTest, AddressesThatCannotBeAnsweredAreIgnored) {
  start();
  const Bytes knock = encode(Knock{static_cast<std::uint16_t>(kProtocolVersion), {}});
  const SocketAddress senders[] = {addressAt("192.0.2.1", 0),       addressAt("0.0.0.0", 5), addressAt("224.0.0.1", 5),
                                   addressAt("255.255.255.255", 5), addressAt("ff02::1", 5), addressAt("::", 5)};
  for (const SocketAddress& sender : senders) network_.inject(sender, kServer, knock);
  receive();
  EXPECT_TRUE(network_.sent().empty());
  EXPECT_EQ(gate_->rejections().malformed, 6u);
}

TEST_F(ServerGateTest, SealedDatagramsThatWereChangedRepeatedOrMadeUpAreRefused) {
  start();
  ClientGate client = join(clientAt(1));
  sessionOf(client);
  const Bytes sealed = network_.sent().back().bytes;
  for (std::size_t bit = 0; bit < 8 * sealed.size(); ++bit) {
    Bytes damaged = sealed;
    damaged[bit / 8] ^= static_cast<std::uint8_t>(1 << bit % 8);
    network_.inject(clientAt(1), kServer, damaged);
  }
  network_.inject(clientAt(1), kServer, sealed);
  network_.inject(clientAt(1), kServer, Bytes(40, 0xff));
  EXPECT_TRUE(receive().empty());
}

}  // namespace
}  // namespace platon::server_gate_test
