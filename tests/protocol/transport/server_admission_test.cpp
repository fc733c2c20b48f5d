#include "protocol/transport/server_admission.h"

#include <array>
#include <cstdio>
#include <vector>

#include <gtest/gtest.h>

#include "protocol/limits.h"
#include "protocol/transport/client_gate.h"
#include "protocol/transport/server_gate.h"
#include "tests/net/support/datagram_network.h"
#include "tests/net/support/server_gate_fixture.h"

namespace platon::server_admission_test {
namespace {

using std::chrono::seconds;

const SocketAddress kClient = addressAt("192.0.2.1", 4000);
constexpr CryptoKey kClientKey{5};
constexpr Time kNow = seconds(1000);

TEST(CookieJar, ACookieIsValidForTheSameClientOnly) {
  const CookieJar jar(CryptoKey{1});
  const Cookie cookie = jar.make(kClient, kClientKey, kNow);
  EXPECT_TRUE(jar.isValid(cookie, kClient, kClientKey, kNow));
  EXPECT_FALSE(jar.isValid(cookie, addressAt("192.0.2.1", 4001), kClientKey, kNow));
  EXPECT_FALSE(jar.isValid(cookie, addressAt("192.0.2.2", 4000), kClientKey, kNow));
  EXPECT_FALSE(jar.isValid(cookie, kClient, CryptoKey{6}, kNow));
  EXPECT_FALSE(CookieJar(CryptoKey{2}).isValid(cookie, kClient, kClientKey, kNow));
}

TEST(CookieJar, EveryFlippedBitIsInvalid) {
  const CookieJar jar(CryptoKey{1});
  const Cookie cookie = jar.make(kClient, kClientKey, kNow);
  for (std::size_t bit = 0; bit < 8 * cookie.size(); ++bit) {
    Cookie damaged = cookie;
    damaged[bit / 8] ^= static_cast<std::uint8_t>(1 << bit % 8);
    EXPECT_FALSE(jar.isValid(damaged, kClient, kClientKey, kNow)) << "bit " << bit;
  }
}

TEST(CookieJar, ACookieIsValidInItsEpochAndTheNext) {
  const CookieJar jar(CryptoKey{1});
  const Time begin = 20 * CookieJar::kEpoch;
  const Cookie cookie = jar.make(kClient, kClientKey, begin);
  EXPECT_TRUE(jar.isValid(cookie, kClient, kClientKey, begin + 2 * CookieJar::kEpoch - seconds(1)));
  EXPECT_FALSE(jar.isValid(cookie, kClient, kClientKey, begin + 2 * CookieJar::kEpoch));
  EXPECT_FALSE(jar.isValid(cookie, kClient, kClientKey, begin + 256 * CookieJar::kEpoch));
}

using std::chrono::seconds;

TEST(RecentKeys, RemembersAKeyInItsEpochAndTheNextOne) {
  RecentKeys keys(seconds(10));
  EXPECT_FALSE(keys.contains(CryptoKey{1}, seconds(25)));
  keys.add(CryptoKey{1}, seconds(25));
  EXPECT_TRUE(keys.contains(CryptoKey{1}, seconds(25)));
  EXPECT_FALSE(keys.contains(CryptoKey{2}, seconds(25)));
  EXPECT_TRUE(keys.contains(CryptoKey{1}, seconds(39)));
  EXPECT_FALSE(keys.contains(CryptoKey{1}, seconds(40)));
}

TEST(RecentKeys, ForgetsAllWhenNothingWasAskedForAWholeEpoch) {
  RecentKeys keys(seconds(10));
  keys.add(CryptoKey{1}, seconds(25));
  EXPECT_FALSE(keys.contains(CryptoKey{1}, seconds(45)));
}

// A list of 4 096 keys forgot the oldest while their cookies were still valid.
TEST(RecentKeys, ForgetsNoneHoweverManyThereAre) {
  RecentKeys keys(seconds(60));
  const auto keyOf = [](std::uint32_t number) {
    CryptoKey key{};
    for (std::size_t i = 0; i < 4; ++i) key[i] = static_cast<std::uint8_t>(number >> (8 * i));
    return key;
  };
  for (std::uint32_t number = 0; number < 60'000; ++number) keys.add(keyOf(number), seconds(60 + number / 500));
  for (std::uint32_t number = 30'000; number < 60'000; ++number)
    ASSERT_TRUE(keys.contains(keyOf(number), seconds(179)));
  EXPECT_TRUE(keys.contains(keyOf(0), seconds(179)));
}

using std::chrono::milliseconds;

constexpr Time kStart = std::chrono::seconds(1000);
constexpr CryptoKey kKey{1, 2, 3};
constexpr double kPerSecond = 2;
constexpr int kLimit = 8;
constexpr std::uint64_t kAttacker = 77;

NetworkBudgets budgets(const CryptoKey& key = kKey) { return {kPerSecond, kLimit, key, kStart}; }

TEST(NetworkBudgetsTest, ANetworkHasItsLimitAtOnceAndThenItsRate) {
  NetworkBudgets some = budgets();
  for (int i = 0; i < kLimit; ++i) EXPECT_TRUE(some.take(5, kStart)) << i;
  EXPECT_FALSE(some.take(5, kStart));
  EXPECT_FALSE(some.take(5, kStart + milliseconds(499)));
  EXPECT_TRUE(some.take(5, kStart + milliseconds(500)));
  EXPECT_FALSE(some.take(5, kStart + milliseconds(500)));
}

TEST(NetworkBudgetsTest, HoldsWhatCanBeTaken) {
  NetworkBudgets some = budgets();
  for (int i = 0; i < 100; ++i) EXPECT_TRUE(some.holds(5, kStart)) << "it takes nothing";
  while (some.take(5, kStart)) {
  }
  EXPECT_FALSE(some.holds(5, kStart));
  EXPECT_FALSE(some.holds(5, kStart + milliseconds(499)));
  EXPECT_TRUE(some.holds(5, kStart + milliseconds(500)));
}

// With one bucket each, several of these newcomers would share that of the attacker.
TEST(NetworkBudgetsTest, AnAttackerKeepsNoNewcomerOut) {
  NetworkBudgets attacked = budgets();
  for (int i = 0; i < 1000; ++i) attacked.take(kAttacker, kStart);
  for (std::uint64_t newcomer = 1000; newcomer < 11000; ++newcomer) {
    NetworkBudgets left = attacked;
    ASSERT_TRUE(left.take(newcomer, kStart)) << newcomer;
  }
}

TEST(NetworkBudgetsTest, TheKeyDecidesWhoShares) {
  // They use up an eighth of the buckets, so that one newcomer in 64 finds both of its own empty.
  constexpr int kAttackers = 64;
  const auto keptOut = [](const CryptoKey& key) {
    NetworkBudgets attacked = budgets(key);
    for (std::uint64_t attacker = 0; attacker < kAttackers; ++attacker) {
      for (int i = 0; i < kLimit; ++i) attacked.take(attacker, kStart);
    }
    std::vector<std::uint64_t> refused;
    for (std::uint64_t newcomer = 1000; newcomer < 2000; ++newcomer) {
      NetworkBudgets left = attacked;
      if (!left.take(newcomer, kStart)) refused.push_back(newcomer);
    }
    return refused;
  };
  const std::vector<std::uint64_t> some = keptOut(kKey);
  EXPECT_GT(some.size(), 5U);
  EXPECT_LT(some.size(), 40U);
  EXPECT_EQ(keptOut(kKey), some);
  EXPECT_NE(keptOut({3, 2, 1}), some);
}

TEST_F(ServerGateTest, AHouseholdHasALimitedNumberOfSessions) {
  start();
  EXPECT_EQ(join(addressAt("192.0.2.1", 1)).state(), ClientGate::State::kOpen);
  EXPECT_EQ(join(addressAt("192.0.2.1", 2)).state(), ClientGate::State::kOpen);
  ClientGate third = join(addressAt("192.0.2.1", 3));
  ASSERT_EQ(third.state(), ClientGate::State::kRefused);
  EXPECT_EQ(third.refusal()->reason, RefusalReason::kAddress);
  EXPECT_EQ(join(addressAt("192.0.2.2", 1)).state(), ClientGate::State::kOpen);
}

TEST_F(ServerGateTest, WhenAllPlacesAreTakenTheOldestUnconfirmedSessionMakesRoom) {
  start({2, 2, {}, false});
  ClientGate first = join(clientAt(1));
  ClientGate second = join(clientAt(2));
  const SessionId confirmed = sessionOf(first);
  EXPECT_EQ(join(clientAt(3)).state(), ClientGate::State::kOpen);
  EXPECT_TRUE(gate_->isOpen(confirmed));
  second.send(kContent, now_);
  EXPECT_TRUE(receive().empty());
}

TEST_F(ServerGateTest, AFullServerSaysSo) {
  start({1, 2, {}, false});
  ClientGate first = join(clientAt(1));
  sessionOf(first);
  ClientGate second = join(clientAt(2));
  ASSERT_EQ(second.state(), ClientGate::State::kRefused);
  EXPECT_EQ(second.refusal()->reason, RefusalReason::kFull);
}

TEST_F(ServerGateTest, ASessionThatIsNotConfirmedExpires) {
  start();
  ClientGate client = join(clientAt(1));
  gate_->expire(now_ + ServerSessions::kConfirmTime);
  EXPECT_EQ(gate_->rejections().unconfirmed, 1u);
  client.send(kContent, now_);
  EXPECT_TRUE(receive().empty());
}

TEST_F(ServerGateTest, AConfirmedSessionExpiresNever) {
  start();
  ClientGate client = join(clientAt(1));
  const SessionId session = sessionOf(client);
  gate_->expire(now_ + std::chrono::hours(24));
  EXPECT_TRUE(gate_->isOpen(session));
  EXPECT_EQ(gate_->rejections().unconfirmed, 0u);
}

TEST_F(ServerGateTest, HandshakesOfAHouseholdAreLimited) {
  start({100, 100, {}, false});
  for (int i = 0; i < 40; ++i) {
    ClientGate client(network_.socket(addressAt("192.0.2.1", static_cast<std::uint16_t>(1 + i))), {kServer}, {},
                      KeyPair::random());
    client.update(now_);
    receive();
    client.receive(now_);
    receive();
  }
  EXPECT_EQ(gate_->rejections().handshakes, 32u);
  EXPECT_EQ(join(clientAt(7)).state(), ClientGate::State::kOpen);
}

// A connection to the internet by IPv6 has hundreds of households: their budgets together were more than the server's.
TEST_F(ServerGateTest, HandshakesAndSessionsOfASiteAreLimited) {
  start({100, 2, {}, false});
  const auto householdAt = [](int number) { return addressAt("2001:db8:1:" + std::to_string(number) + "::1", 4000); };
  int joined = 0;
  for (int i = 0; i < 20; ++i) joined += join(householdAt(i)).state() == ClientGate::State::kOpen ? 1 : 0;
  EXPECT_EQ(joined, 8);
  ClientGate other = join(addressAt("2001:db8:2::1", 4000));
  EXPECT_EQ(other.state(), ClientGate::State::kOpen);
  const std::uint64_t before = gate_->rejections().handshakes;
  for (int i = 0; i < 60; ++i) {
    ClientGate client(network_.socket(householdAt(100 + i)), {kServer}, {}, KeyPair::random());
    client.update(now_);
    receive();
    client.receive(now_);
    receive();
  }
  EXPECT_EQ(gate_->rejections().handshakes - before, 28u);
}

// What its site refused was charged to its households all the same: requests from so many of them emptied all buckets,
// and nobody else could join.
TEST_F(ServerGateTest, ASiteDrainsNoBudgetsOfOtherHouseholds) {
  start({100, 100, {}, false});
  const KeyPair keys = KeyPair::random();
  for (int i = 0; i < 20000; ++i) {
    std::array<char, 32> household{};
    std::snprintf(household.data(), household.size(), "2001:db8:1:%x::1", i);
    const SocketAddress own = addressAt(household.data(), 4000);
    gate_->beginRound();
    network_.inject(own, kServer, encode(Knock{static_cast<std::uint16_t>(kProtocolVersion), keys.publicKey}));
    receive();
    Open open{decodeCookieReply(network_.sent().back().bytes)->cookie, {}};  // with a wrong exchange
    std::copy(keys.publicKey.begin(), keys.publicKey.end(), open.exchange.begin());
    network_.inject(own, kServer, encode(open));
    receive();
    network_.forgetSent();
  }
  EXPECT_EQ(gate_->rejections().password, 32u);
  EXPECT_EQ(gate_->rejections().handshakes, 20000u - 32);
  for (int i = 0; i < 32; ++i) EXPECT_EQ(join(clientAt(i)).state(), ClientGate::State::kOpen) << i;
}

TEST_F(ServerGateTest, AHouseholdDrainsNoBudgetOfItsSite) {
  start({100, 100, {}, false});
  const auto join = [this](const SocketAddress& own) {
    ClientGate client(network_.socket(own), {kServer}, {}, KeyPair::random());
    client.update(now_);
    receive();
    client.receive(now_);
    receive();
    client.receive(now_);
    return client.state();
  };
  for (std::uint16_t i = 0; i < 40; ++i) join(addressAt("2001:db8:1:1::1", static_cast<std::uint16_t>(1 + i)));
  EXPECT_EQ(gate_->rejections().handshakes, 32u);
  EXPECT_EQ(join(addressAt("2001:db8:1:2::1", 1)), ClientGate::State::kOpen);
}

// It was taken for a client that had joined: it got no answer and was not counted.
TEST_F(ServerGateTest, AWrongPasswordIsRefusedAlsoWhenAllPlacesAreTaken) {
  start({1, 4, presharedKeyOf("sesame", identity_.publicKey()), true});
  ClientGate first = join(clientAt(1), "sesame");
  ClientGate wrong = join(clientAt(2), "Sesame");
  ASSERT_EQ(wrong.state(), ClientGate::State::kRefused);
  EXPECT_EQ(wrong.refusal()->reason, RefusalReason::kPassword);
  EXPECT_EQ(gate_->rejections().password, 1u);
  EXPECT_TRUE(gate_->isOpen(sessionOf(first)));
}

TEST_F(ServerGateTest, TheLargestContentPassesInBothDirectionsAndNoLargerOne) {
  start();
  ClientGate client = join(clientAt(1));
  const SessionId session = sessionOf(client);
  const Bytes largest(kMaxDatagramBytes - SealedChannel::kOverhead, 7);
  client.send(largest, now_);
  EXPECT_EQ(network_.sent().back().bytes.size(), kMaxDatagramBytes);
  const auto received = receive();
  ASSERT_EQ(received.size(), 1u);
  EXPECT_EQ(received[0].bytes, largest);
  gate_->send(session, largest, now_);
  EXPECT_EQ(client.receive(now_), largest);
  const std::size_t before = network_.sent().size();
  gate_->send(session, Bytes(largest.size() + 1), now_);
  client.send(Bytes(largest.size() + 1), now_);
  EXPECT_EQ(network_.sent().size(), before);
}

TEST_F(ServerGateTest, TheIdOfASessionThatHasEndedIsNotThatOfTheNextInItsPlace) {
  start({1, 2, {}, false});
  ClientGate first = join(clientAt(1));
  const SessionId ended = sessionOf(first);
  gate_->close(ended);
  ClientGate second = join(clientAt(2));
  const SessionId session = sessionOf(second);
  ASSERT_EQ(session.slot, ended.slot);
  gate_->close(ended);
  EXPECT_FALSE(gate_->isOpen(ended));
  EXPECT_TRUE(gate_->isOpen(session));
  EXPECT_EQ(gate_->addressOf(ended), IpAddress());
  const std::size_t before = network_.sent().size();
  gate_->send(ended, kContent, now_);
  EXPECT_EQ(network_.sent().size(), before);
}

// They were skipped unseen: a flood of them had no end in one round, and no trace in the log.
TEST_F(ServerGateTest, EmptyAndOversizedDatagramsCount) {
  start();
  for (std::size_t i = 0; i < ServerGate::kMaxDatagramsPerRound + 10; ++i) {
    network_.inject(clientAt(1), kServer, Bytes(i % 2 == 0 ? 0 : kMaxDatagramBytes + 1, 0xff));
  }
  gate_->beginRound();
  EXPECT_TRUE(receive().empty());
  EXPECT_EQ(gate_->rejections().malformed, ServerGate::kMaxDatagramsPerRound);
  EXPECT_EQ(gate_->traffic().receivedPackets, ServerGate::kMaxDatagramsPerRound);
}

}  // namespace
}  // namespace platon::server_admission_test
