#include "protocol/transport/sealed_channel.h"

#include <algorithm>
#include <optional>
#include <random>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace platon::sealed_channel_test {
namespace {

constexpr std::uint64_t kSeed = 20261122;

struct Ends {
  SessionKeys keys{CryptoKey{1}, CryptoKey{2}};
  SealedChannel client{SealedChannel::Side::kClient, keys, 0x1234};
  SealedChannel server{SealedChannel::Side::kServer, keys, 0x1234};
};

// Whether the memory of an object holds a part of this key.
template <class Object>
bool holds(const Object& object, const CryptoKey& key) {
  const auto* const begin = reinterpret_cast<const volatile std::uint8_t*>(&object);
  const std::vector<std::uint8_t> bytes(begin, begin + sizeof object);
  const auto part = key.begin() + 8;
  return std::search(bytes.begin(), bytes.end(), part, part + 8) != bytes.end();
}

Bytes content(std::size_t size, std::uint8_t value = 7) { return Bytes(size, value); }

TEST(SealedChannel, OpensWhatTheOtherEndSealed) {
  Ends ends;
  for (const std::size_t size : {1u, 2u, 100u, 1180u}) {
    EXPECT_EQ(ends.server.open(ends.client.seal(content(size)))->bytes, content(size));
    EXPECT_EQ(ends.client.open(ends.server.seal(content(size)))->bytes, content(size));
  }
}

TEST(SealedChannel, AddsTwentyBytesToTheServerAndEighteenToTheClient) {
  Ends ends;
  EXPECT_EQ(ends.client.seal(content(100)).size(), 120u);
  EXPECT_EQ(ends.server.seal(content(100)).size(), 118u);
  EXPECT_EQ(SealedChannel::slotOf(ends.client.seal(content(1))), 0x1234);
}

// A key that stays in memory opens a session that was recorded, whenever the memory is read.
TEST(SealedChannel, ForgetsItsKeysAtItsEnd) {
  std::mt19937_64 random(kSeed);
  SessionKeys keys;
  for (CryptoKey* key : {&keys.toServer, &keys.toClient}) {
    for (std::uint8_t& byte : *key) byte = static_cast<std::uint8_t>(random());
  }
  std::optional<SealedChannel> closed(std::in_place, SealedChannel::Side::kServer, keys, std::uint16_t{1});
  std::optional<SealedChannel> replaced = closed;
  for (const CryptoKey& key : {keys.toServer, keys.toClient}) EXPECT_TRUE(holds(closed, key) && holds(replaced, key));
  closed.reset();
  replaced = std::optional<SealedChannel>();
  for (const CryptoKey& key : {keys.toServer, keys.toClient}) EXPECT_FALSE(holds(closed, key) || holds(replaced, key));
}

TEST(SealedChannel, EqualContentsGiveDifferentDatagrams) {
  Ends ends;
  const Bytes first = ends.client.seal(content(64));
  const Bytes second = ends.client.seal(content(64));
  EXPECT_FALSE(std::equal(first.begin() + 4, first.end(), second.begin() + 4));
  const Bytes back = ends.server.seal(content(64));
  EXPECT_FALSE(std::equal(first.begin() + 4, first.end(), back.begin() + 2));
}

TEST(SealedChannel, EveryFlippedBitIsRefused) {
  Ends ends;
  for (const bool isControl : {false, true}) {
    const Bytes sealed = ends.client.seal(content(9), isControl);
    for (std::size_t bit = 0; bit < 8 * sealed.size(); ++bit) {
      Bytes damaged = sealed;
      damaged[bit / 8] ^= static_cast<std::uint8_t>(1 << bit % 8);
      EXPECT_FALSE(ends.server.open(damaged)) << "bit " << bit;
    }
    EXPECT_EQ(ends.server.open(sealed)->isControl, isControl);
  }
}

TEST(SealedChannel, EveryTruncationIsRefused) {
  Ends ends;
  const Bytes sealed = ends.client.seal(content(40));
  for (std::size_t size = 0; size < sealed.size(); ++size) EXPECT_FALSE(ends.server.open(ByteSpan(sealed).first(size)));
}

TEST(SealedChannel, ARepeatedDatagramIsRefused) {
  Ends ends;
  const Bytes sealed = ends.client.seal(content(5));
  EXPECT_TRUE(ends.server.open(sealed));
  EXPECT_FALSE(ends.server.open(sealed));
}

TEST(SealedChannel, ADatagramOfTheOtherDirectionIsRefused) {
  Ends ends;
  const Bytes sealed = ends.client.seal(content(50));
  EXPECT_FALSE(ends.client.open(sealed));
}

TEST(SealedChannel, OpensAnyOrderWithinTheWindowOnce) {
  SCOPED_TRACE("seed " + std::to_string(kSeed));
  std::mt19937_64 random(kSeed);
  Ends ends;
  for (int round = 0; round < 20; ++round) {
    std::vector<Bytes> sealed;
    for (std::size_t i = 0; i < ReplayWindow::kSize; ++i) sealed.push_back(ends.client.seal(content(3)));
    std::shuffle(sealed.begin(), sealed.end(), random);
    for (const Bytes& each : sealed) EXPECT_TRUE(ends.server.open(each));
    for (const Bytes& each : sealed) EXPECT_FALSE(ends.server.open(each));
  }
}

TEST(SealedChannel, OnlyTheNewestDatagramIsNewest) {
  Ends ends;
  const Bytes first = ends.client.seal(content(1));
  const Bytes second = ends.client.seal(content(1));
  EXPECT_TRUE(ends.server.open(second)->isNewest);
  EXPECT_FALSE(ends.server.open(first)->isNewest);
  EXPECT_TRUE(ends.server.open(ends.client.seal(content(1)))->isNewest);
}

// The datagram that has its place in the window after it was lost, too.
TEST(SealedChannel, ADatagramOlderThanTheWindowIsRefused) {
  Ends ends;
  const Bytes old = ends.client.seal(content(1));
  for (std::size_t i = 1; i < ReplayWindow::kSize; ++i) ends.server.open(ends.client.seal(content(1)));
  ends.client.seal(content(1));
  EXPECT_TRUE(ends.server.open(ends.client.seal(content(1))));
  EXPECT_FALSE(ends.server.open(old));
}

// Only 14 bits of the number are sent.
TEST(SealedChannel, NumbersGoOnAfterLongLosses) {
  SCOPED_TRACE("seed " + std::to_string(kSeed));
  std::mt19937_64 random(kSeed);
  Ends ends;
  std::uint64_t sealed = 0;
  while (sealed < 200'000) {
    const std::uint64_t lost = random() % 8000;
    for (std::uint64_t i = 0; i < lost; ++i) ends.client.seal(content(1));
    ASSERT_TRUE(ends.server.open(ends.client.seal(content(2)))) << sealed;
    sealed += lost + 1;
  }
}

// The bits of the next number expected are less than half of their range, more than half, and again less.
TEST(SealedChannel, OfTwoNumbersThatAreEquallyNearTheHigherIsTaken) {
  for (const int received : {1, 10000, (1 << 14) + 1}) {
    Ends ends;
    for (int i = 0; i < received; ++i) ASSERT_TRUE(ends.server.open(ends.client.seal(content(1))));
    for (int lost = 0; lost < 1 << 13; ++lost) ends.client.seal(content(1));
    EXPECT_TRUE(ends.server.open(ends.client.seal(content(2)))) << received;
  }
}

// Of the first numbers, none is negative.
TEST(SealedChannel, AnyOfTheFirstDatagramsMayBeTheFirstThatArrives) {
  for (const int lost : {0, (1 << 13) - 1, 1 << 13, (1 << 13) + 1, (1 << 14) - 1}) {
    Ends ends;
    for (int i = 0; i < lost; ++i) ends.client.seal(content(1));
    EXPECT_TRUE(ends.server.open(ends.client.seal(content(2)))) << lost;
  }
}

// Its low bits are the largest, those of the newest one are the smallest.
TEST(SealedChannel, OpensALateDatagramFromBeforeTheLowBitsOverflowed) {
  Ends ends;
  for (int i = 0; i < (1 << 14) - 1; ++i) ends.server.open(ends.client.seal(content(1)));
  const Bytes late = ends.client.seal(content(3));
  ASSERT_TRUE(ends.server.open(ends.client.seal(content(2))));
  const auto opened = ends.server.open(late);
  ASSERT_TRUE(opened);
  EXPECT_EQ(opened->bytes, content(3));
  EXPECT_FALSE(opened->isNewest);
  EXPECT_FALSE(ends.server.open(late));
}

// Every place of the window holds a number that has arrived before the jump.
TEST(ReplayWindow, AfterAJumpOfItsSizeNothingOldIsFreshAndAllThatIsNewIs) {
  for (const std::uint64_t jump : {ReplayWindow::kSize - 1, ReplayWindow::kSize, ReplayWindow::kSize + 1}) {
    ReplayWindow window;
    for (std::uint64_t sequence = 0; sequence < ReplayWindow::kSize; ++sequence) window.mark(sequence);
    const std::uint64_t last = window.next() - 1 + jump;
    window.mark(last);
    for (std::uint64_t sequence = 0; sequence <= last + 1; ++sequence) {
      const bool isNew = sequence >= ReplayWindow::kSize && sequence != last;
      const bool isRemembered = sequence + ReplayWindow::kSize > last;
      EXPECT_EQ(window.isFresh(sequence), isNew && isRemembered) << sequence << " after a jump by " << jump;
    }
  }
}

TEST(ReplayWindow, RemembersWhatHasArrived) {
  ReplayWindow window;
  EXPECT_TRUE(window.isFresh(0));
  window.mark(0);
  EXPECT_FALSE(window.isFresh(0));
  window.mark(2);
  EXPECT_TRUE(window.isFresh(1));
  EXPECT_EQ(window.next(), 3u);
  window.mark(2 + ReplayWindow::kSize);
  EXPECT_FALSE(window.isFresh(2));
  EXPECT_TRUE(window.isFresh(3));
  window.mark(10 * ReplayWindow::kSize);
  EXPECT_FALSE(window.isFresh(10 * ReplayWindow::kSize));
  EXPECT_TRUE(window.isFresh(10 * ReplayWindow::kSize - 1));
  EXPECT_FALSE(window.isFresh(3));
}

}  // namespace
}  // namespace platon::sealed_channel_test
