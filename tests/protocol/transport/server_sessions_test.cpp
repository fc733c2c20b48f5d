// Clients whose address changes, and attackers who forge that.
#include "protocol/transport/server_sessions.h"

#include <gtest/gtest.h>

#include "protocol/transport/client_gate.h"
#include "protocol/transport/sealed_channel.h"
#include "protocol/transport/server_gate.h"
#include "tests/net/support/server_gate_fixture.h"

namespace platon::server_sessions_test {
namespace {

using namespace std::chrono_literals;

const SocketAddress kMoved = addressAt("203.0.113.9", 999);
const SocketAddress kMovedAgain = addressAt("203.0.113.9", 1000);

/// A client with a session. Nothing that it sends arrives by itself.
class ServerGatePathsTest : public ServerGateTest {
 protected:
  ServerGatePathsTest() {
    start();
    client_.emplace(join(clientAt(1)));
    session_ = sessionOf(*client_);
    network_.setFilter([](const auto& each) { return each.to != kServer; });
  }

  Bytes sealed(ByteSpan content) {
    client_->send(content, now_);
    return network_.sent().back().bytes;
  }
  // The gate takes one content, which comes from this address.
  void deliver(const SocketAddress& from, ByteSpan datagram) {
    network_.inject(from, kServer, datagram);
    EXPECT_EQ(receive().size(), 1u);
  }
  std::size_t challengesTo(const SocketAddress& address) const { return sent(kServer, address).size(); }
  // The client receives the last challenge to this address. Returns its answer.
  Bytes answerTo(const SocketAddress& address) {
    while (client_->receive(now_)) {
    }
    network_.inject(kServer, clientAt(1), sent(kServer, address).back());
    client_->receive(now_);
    return network_.sent().back().bytes;
  }
  void answer(const SocketAddress& from, ByteSpan datagram) {
    network_.inject(from, kServer, datagram);
    EXPECT_TRUE(receive().empty());
  }
  // Where the gate sends to.
  // Where content is sent to; nobody's address: nowhere.
  SocketAddress receiver() {
    const std::size_t before = network_.sent().size();
    gate_->send(session_, kContent, now_);
    return network_.sent().size() == before ? SocketAddress() : network_.sent().back().to;
  }

  std::optional<ClientGate> client_;
  SessionId session_;
};

// It does not show where the client is now.
TEST_F(ServerGatePathsTest, ALateDatagramFromElsewhereBringsNoChallenge) {
  const Bytes late = sealed(kContent);
  deliver(clientAt(1), sealed(kContent));
  deliver(kMoved, late);
  EXPECT_EQ(challengesTo(kMoved), 0u);
  deliver(kMoved, sealed(kContent));
  EXPECT_EQ(challengesTo(kMoved), 1u) << "the newest brings one";
}

TEST_F(ServerGatePathsTest, ADatagramFromTheSameAddressBringsNoChallenge) {
  const std::size_t before = challengesTo(clientAt(1));
  deliver(clientAt(1), sealed(kContent));
  EXPECT_EQ(challengesTo(clientAt(1)), before);
}

// Whoever forges its sender would make the gate send more than it was sent.
TEST_F(ServerGatePathsTest, ADatagramShorterThanTheChallengeBringsNone) {
  std::size_t size = 0;
  while (challengesTo(kMoved) == 0) {
    ASSERT_LT(size, kContent.size());
    const Bytes datagram = sealed(ByteSpan(kContent).first(++size));
    deliver(kMoved, datagram);
    EXPECT_EQ(challengesTo(kMoved), datagram.size() < kPathChallengeBytes ? 0u : 1u) << datagram.size() << " bytes";
  }
  EXPECT_EQ(sent(kServer, kMoved)[0].size(), kPathChallengeBytes);
}

TEST_F(ServerGatePathsTest, AClientThatMovesAgainBeforeItAnswersIsFollowed) {
  deliver(kMoved, sealed(kContent));
  now_ += std::chrono::milliseconds(100);
  deliver(kMovedAgain, sealed(kContent));
  ASSERT_EQ(challengesTo(kMovedAgain), 1u);
  answer(kMovedAgain, answerTo(kMovedAgain));
  EXPECT_EQ(receiver(), kMovedAgain);
}

TEST_F(ServerGatePathsTest, AnAnswerFromAnotherAddressThanTheChallengedMovesNothing) {
  deliver(kMoved, sealed(kContent));
  const Bytes response = answerTo(kMoved);
  answer(kMovedAgain, response);
  EXPECT_EQ(receiver(), clientAt(1));
  answer(kMoved, response);
  EXPECT_EQ(receiver(), clientAt(1)) << "it was the same datagram";
}

// A household's limit would be worth nothing if sessions could begin elsewhere.
TEST_F(ServerGatePathsTest, NobodyMovesIntoAFullHousehold) {
  network_.setFilter({});
  join(addressAt("203.0.113.9", 1));
  join(addressAt("203.0.113.9", 2));
  network_.setFilter([](const auto& each) { return each.to != kServer; });
  deliver(kMoved, sealed(kContent));
  EXPECT_EQ(challengesTo(kMoved), 0u);
  EXPECT_EQ(receiver(), clientAt(1));
}

TEST_F(ServerGatePathsTest, NobodyMovesIntoAHouseholdThatHasFilledSinceTheChallenge) {
  deliver(kMoved, sealed(kContent));
  const Bytes response = answerTo(kMoved);
  network_.setFilter({});
  join(addressAt("203.0.113.9", 1));
  join(addressAt("203.0.113.9", 2));
  answer(kMoved, response);
  EXPECT_EQ(gate_->addressOf(session_), clientAt(1).ip);
  EXPECT_EQ(gate_->rejections().full, 1u);
}

// A router gives a client another port.
TEST_F(ServerGatePathsTest, AClientMovesWithinAFullHousehold) {
  network_.setFilter({});
  join(addressAt("192.0.2.1", 4001));
  network_.setFilter([](const auto& each) { return each.to != kServer; });
  const SocketAddress moved = addressAt("192.0.2.1", 4002);
  deliver(moved, sealed(kContent));
  answer(moved, answerTo(moved));
  EXPECT_EQ(receiver(), moved);
  EXPECT_EQ(gate_->rejections().full, 0u);
}

// It counts there already.
TEST_F(ServerGatePathsTest, ASessionOfAFullSiteMovesWithinIt) {
  start({12, 2, {}, false});
  network_.setFilter({});
  const auto inHousehold = [](int number) { return addressAt("2001:db8:1:" + std::to_string(number) + "::1", 4000); };
  std::vector<ClientGate> others;
  for (int i = 0; i < 7; ++i) others.push_back(join(inHousehold(i)));
  client_.emplace(join(inHousehold(7)));
  session_ = sessionOf(*client_);
  EXPECT_EQ(join(inHousehold(8)).state(), ClientGate::State::kRefused) << "the site is full";
  network_.setFilter([](const auto& each) { return each.to != kServer; });
  deliver(inHousehold(9), sealed(kContent));
  EXPECT_EQ(challengesTo(inHousehold(9)), 1u);
}

TEST_F(ServerGatePathsTest, WhoeverChecksMovesMayRefuseOne) {
  bool may = false;
  std::vector<IpAddress> asked;
  rules_.mayMove = [&](SessionId session, const IpAddress& address) {
    EXPECT_EQ(session, session_);
    asked.push_back(address);
    return may;
  };
  deliver(kMoved, sealed(kContent));
  EXPECT_TRUE(asked.empty()) << "the sender may be forged";
  answer(kMoved, answerTo(kMoved));
  EXPECT_EQ(gate_->addressOf(session_), clientAt(1).ip);
  EXPECT_EQ(gate_->rejections().full, 1u);
  may = true;
  now_ += 100ms;
  deliver(kMoved, sealed(kContent));
  answer(kMoved, answerTo(kMoved));
  EXPECT_EQ(receiver(), kMoved);
  EXPECT_EQ(asked, (std::vector{kMoved.ip, kMoved.ip}));
}

// As long as it stayed, it was challenged, and counted as refused, with each datagram.
TEST_F(ServerGatePathsTest, AClientWhoseMoveIsRefusedIsChallengedTenTimesASecond) {
  rules_.mayMove = [](SessionId, const IpAddress&) { return false; };
  deliver(kMoved, sealed(kContent));
  answer(kMoved, answerTo(kMoved));
  deliver(kMoved, sealed(kContent));
  EXPECT_EQ(challengesTo(kMoved), 1u);
  now_ += 99ms;
  deliver(kMoved, sealed(kContent));
  EXPECT_EQ(challengesTo(kMoved), 1u);
  now_ += 1ms;
  deliver(kMoved, sealed(kContent));
  EXPECT_EQ(challengesTo(kMoved), 2u);
}

// Two challenges before the first answer are the same.
TEST_F(ServerGatePathsTest, AChallengeIsAnsweredOnce) {
  rules_.mayMove = [](SessionId, const IpAddress&) { return false; };
  deliver(kMoved, sealed(kContent));
  const Bytes response = answerTo(kMoved);
  now_ += 100ms;
  deliver(kMoved, sealed(kContent));
  answer(kMoved, answerTo(kMoved));
  answer(kMoved, response);
  EXPECT_EQ(gate_->rejections().full, 1u);
}

// It does not receive at its old address, and may not receive here.
TEST_F(ServerGatePathsTest, AClientWhoseMoveIsRefusedIsSentNothingButChallengesAfterASecond) {
  rules_.mayMove = [](SessionId, const IpAddress&) { return false; };
  for (Time passed{}; passed < ServerSessions::kUnconfirmedPathTime; passed += 100ms, now_ += 100ms) {
    deliver(kMoved, sealed(kContent));
    if (challengesTo(kMoved) > gate_->rejections().full) answer(kMoved, answerTo(kMoved));
    EXPECT_EQ(receiver(), clientAt(1));
  }
  EXPECT_GE(gate_->rejections().full, 5u);
  deliver(kMoved, sealed(kContent));
  const std::size_t before = network_.sent().size();
  gate_->send(session_, kContent, now_);
  EXPECT_EQ(network_.sent().size(), before);
  deliver(clientAt(1), sealed(kContent));
  EXPECT_EQ(receiver(), clientAt(1)) << "it has come back";
}

TEST_F(ServerGatePathsTest, AClientBetweenTwoAddressesIsChallengedTenTimesASecond) {
  for (int i = 0; i < 100; ++i, now_ += 10ms) {
    deliver(kMoved, sealed(kContent));
    deliver(clientAt(1), sealed(kContent));
  }
  EXPECT_EQ(challengesTo(kMoved), 10u);
}

// The server went on sending to an address that the client had left, 326 kB/s of it.
TEST_F(ServerGatePathsTest, NothingButChallengesGoesToAnAddressThatTheClientDoesNotAnswerAt) {
  deliver(kMoved, sealed(kContent));
  now_ += ServerSessions::kUnconfirmedPathTime - 1ms;
  deliver(kMoved, sealed(kContent));
  EXPECT_EQ(receiver(), clientAt(1));
  now_ += 1ms;
  deliver(kMoved, sealed(kContent));
  const std::size_t before = network_.sent().size();
  gate_->send(session_, kContent, now_);
  EXPECT_EQ(network_.sent().size(), before);
  answer(kMoved, answerTo(kMoved));
  EXPECT_EQ(receiver(), kMoved);
}

// Somebody on the wire sends copies of what it sends, which arrive before, from elsewhere.
TEST_F(ServerGatePathsTest, AClientThatIsOvertakenAnswersWhereItIsAndMissesNothing) {
  deliver(kMoved, sealed(kContent));
  for (int second = 0; second < 10; ++second) {
    now_ += ServerSessions::kUnconfirmedPathTime / 2;
    const std::size_t before = challengesTo(clientAt(1));
    deliver(kMoved, sealed(kContent));
    deliver(kMoved, sealed(kContent));
    ASSERT_EQ(challengesTo(clientAt(1)), before + 1);
    answer(kMoved, answerTo(clientAt(1)));
    now_ += ServerSessions::kUnconfirmedPathTime / 2;
    EXPECT_EQ(receiver(), clientAt(1));
  }
}

TEST_F(ServerGatePathsTest, AnAnswerFromTheOldAddressCountsOnce) {
  deliver(kMoved, sealed(kContent));
  now_ += ServerSessions::kUnconfirmedPathTime / 2;
  deliver(kMoved, sealed(kContent));
  const Bytes first = answerTo(clientAt(1));
  now_ += 100ms;
  deliver(kMoved, sealed(kContent));  // asks the new address
  deliver(kMoved, sealed(kContent));
  const Bytes second = answerTo(clientAt(1));
  answer(kMoved, first);
  now_ += ServerSessions::kUnconfirmedPathTime - 1ms;
  EXPECT_EQ(receiver(), clientAt(1));
  answer(kMoved, second);
  now_ += 1ms;
  const std::size_t before = network_.sent().size();
  gate_->send(session_, kContent, now_);
  EXPECT_EQ(network_.sent().size(), before) << "it was the same challenge";
}

TEST_F(ServerGatePathsTest, ADatagramFromTheOldAddressEndsTheDoubt) {
  deliver(kMoved, sealed(kContent));
  now_ += 10 * ServerSessions::kUnconfirmedPathTime;
  deliver(clientAt(1), sealed(kContent));
  EXPECT_EQ(receiver(), clientAt(1));
  now_ += 2 * ServerSessions::kUnconfirmedPathTime;
  EXPECT_EQ(receiver(), clientAt(1)) << "as long as to a client of which nothing came from elsewhere";
}

TEST_F(ServerGatePathsTest, ALateDatagramFromTheOldAddressDoesNot) {
  const Bytes late = sealed(kContent);
  deliver(kMoved, sealed(kContent));
  now_ += 10 * ServerSessions::kUnconfirmedPathTime;
  deliver(clientAt(1), late);
  const std::size_t before = network_.sent().size();
  gate_->send(session_, kContent, now_);
  EXPECT_EQ(network_.sent().size(), before);
}

// Such a datagram tells as much about the old address as any other.
TEST_F(ServerGatePathsTest, ADatagramThatIsTooShortForAChallengePutsTheOldAddressInDoubtToo) {
  deliver(kMoved, sealed(Bytes{1}));
  now_ += ServerSessions::kUnconfirmedPathTime;
  const std::size_t before = network_.sent().size();
  gate_->send(session_, kContent, now_);
  EXPECT_EQ(network_.sent().size(), before);
}

// The server does not follow it there, but asks whether it still receives where it was.
TEST_F(ServerGatePathsTest, ADatagramFromABannedAddressPutsTheOldAddressInDoubtToo) {
  rules_.ban = [](const IpAddress& ip) { return ip == kMoved.ip ? std::optional<std::string>("") : std::nullopt; };
  deliver(kMoved, sealed(kContent));
  now_ += ServerSessions::kUnconfirmedPathTime;
  const std::size_t before = challengesTo(clientAt(1));
  deliver(kMoved, sealed(kContent));
  EXPECT_EQ(challengesTo(kMoved), 0u);
  EXPECT_EQ(challengesTo(clientAt(1)), before + 1);
  answer(kMoved, answerTo(clientAt(1)));
  EXPECT_EQ(receiver(), clientAt(1));
}

// Its datagrams alone do not show where it is: it may have left its address, and forge it as their sender to have the
// server send there without end.
TEST_F(ServerGatePathsTest, NothingButChallengesGoesToAnAddressWhoseClientAnswersNoneForFifteenSeconds) {
  const Time joined = now_;
  for (; now_ < joined + 20s; now_ += 100ms) {
    deliver(clientAt(1), sealed(kContent));
    const std::size_t all = network_.sent().size();
    gate_->send(session_, kContent, now_);
    const bool served = now_ + 600ms < joined + ServerSessions::kShownAddressTime;  // it joined 600 ms before
    EXPECT_EQ(network_.sent().size(), all + (served ? 1 : 0)) << (now_ - joined) / 1ms << " ms";
  }
  network_.forgetSent();
  deliver(clientAt(1), sealed(kContent));
  answer(clientAt(1), answerTo(clientAt(1)));
  EXPECT_EQ(receiver(), clientAt(1));
}

TEST_F(ServerGatePathsTest, AClientThatStaysIsAskedEveryTenSeconds) {
  network_.forgetSent();
  for (const Time end = now_ + 60s; now_ < end; now_ += 50ms) {
    const std::size_t before = challengesTo(clientAt(1));
    deliver(clientAt(1), sealed(kContent));
    if (challengesTo(clientAt(1)) > before) answer(clientAt(1), answerTo(clientAt(1)));
  }
  EXPECT_EQ(challengesTo(clientAt(1)), 6u);
}

// A path that begins anew does not excuse it.
TEST_F(ServerGatePathsTest, WhoGoesBackAndForthWithoutAnAnswerIsAskedToo) {
  const Time joined = now_;
  for (; now_ < joined + 15s; now_ += 100ms) {
    deliver(kMoved, sealed(kContent));
    deliver(clientAt(1), sealed(kContent));
  }
  const std::size_t before = network_.sent().size();
  gate_->send(session_, kContent, now_);
  EXPECT_EQ(network_.sent().size(), before);
}

// Each datagram has one answer at most, and none keeps the other waiting for long.
TEST_F(ServerGatePathsTest, BothAddressesAreAskedInTurn) {
  deliver(kMoved, sealed(kContent));
  now_ += ServerSessions::kUnconfirmedPathTime / 2;
  const std::size_t before = challengesTo(clientAt(1));
  for (int i = 0; i < 10; ++i, now_ += 250ms) {
    const std::size_t all = network_.sent().size();
    deliver(kMoved, sealed(kContent));
    EXPECT_EQ(network_.sent().size(), all + 2) << "the datagram itself, and a challenge";
  }
  EXPECT_EQ(challengesTo(clientAt(1)), before + 5);
  EXPECT_EQ(challengesTo(kMoved), 1u + 5);
}

}  // namespace
}  // namespace platon::server_sessions_test
