#include "shared/exact/hash.h"

#include <gtest/gtest.h>

#include <initializer_list>
#include <set>

namespace platon::hash_test {
namespace {

std::uint64_t hashOf(std::initializer_list<std::uint64_t> values) {
  Hash hash;
  for (const std::uint64_t value : values) hash.add(value);
  return hash.value();
}

TEST(HashTest, MatchesKnownValues) {
  EXPECT_EQ(hashOf({}), 0xcbf29ce484222325U);
  EXPECT_EQ(hashOf({0}), 0xf8bb92c91b3f5cc0U);
  EXPECT_EQ(hashOf({1, 2, 3}), 0xc07b167c3203d34U);
}

TEST(HashTest, HashesValuesNotTypes) {
  Hash narrow;
  narrow.add(std::int8_t{-5});
  narrow.add(std::uint16_t{70});
  narrow.add(std::uint8_t{1});
  Hash wide;
  wide.add(std::int64_t{-5});
  wide.add(70);
  wide.add(1U);
  EXPECT_EQ(narrow.value(), wide.value());
}

struct Record {
  std::uint16_t small = 0;
  std::int32_t number = 0;
  Point point;
  Angle angle;
  std::uint8_t last = 0;

  template <class Self, class Visitor>
  static void visit(Self& self, Visitor&& visitor) {
    visitor("small", self.small);
    visitor("number", self.number);
    visitor("point", self.point);
    visitor("angle", self.angle);
    visitor("last", self.last);
  }
};

// The fields in words of at most 64 bits: 16 + 32, 64, 32 + 8.
TEST(RecordHashTest, JoinsFieldsThatFitAWord) {
  const Record record{0xfffe, -3, Point(-1, 7), Angle(90), 200};
  EXPECT_EQ(hashOfRecord(record), hashOf({0xfffffffdfffeU, 0x7ffffffffU, 0xc80000005aU}));
}

TEST(RecordHashTest, EveryFieldChangesTheHash) {
  const Record record;
  std::set<std::uint64_t> seen{hashOfRecord(record)};
  const auto isNew = [&](auto change) {
    Record other;
    change(other);
    return seen.insert(hashOfRecord(other)).second;
  };
  EXPECT_TRUE(isNew([](Record& r) { r.small = 1; }));
  EXPECT_TRUE(isNew([](Record& r) { r.number = 1; }));
  EXPECT_TRUE(isNew([](Record& r) { r.number = -1; }));
  EXPECT_TRUE(isNew([](Record& r) { r.point.x = 1; }));
  EXPECT_TRUE(isNew([](Record& r) { r.point.y = 1; }));
  EXPECT_TRUE(isNew([](Record& r) { r.angle = Angle(1); }));
  EXPECT_TRUE(isNew([](Record& r) { r.last = 1; }));
}

template <class Value>
concept Hashed = requires(Hash hash, Value value) {
  hash.add(value);
};

// Only types that are the same on every platform can be hashed; `char` is signed on some of them.
static_assert(!Hashed<bool> && !Hashed<char> && !Hashed<wchar_t> && !Hashed<const void*> && !Hashed<float>);
static_assert(Hashed<std::int8_t> && Hashed<std::uint64_t>);

TEST(HashTest, EveryBitChangesTheHash) {
  std::set<std::uint64_t> seen{hashOf({0, 0, 0})};
  for (int place = 0; place < 3; ++place) {
    for (int bit = 0; bit < 64; ++bit) {
      std::uint64_t values[3] = {};
      values[place] = std::uint64_t{1} << bit;
      EXPECT_TRUE(seen.insert(hashOf({values[0], values[1], values[2]})).second) << place << " " << bit;
    }
  }
}

TEST(HashTest, OrderAndLengthChangeTheHash) {
  EXPECT_NE(hashOf({1, 2}), hashOf({2, 1}));
  EXPECT_NE(hashOf({0}), hashOf({0, 0}));
  Hash ab;
  ab.add(Point(1, -2));
  Hash ba;
  ba.add(Point(-2, 1));
  EXPECT_NE(ab.value(), ba.value());
  Hash angle;
  angle.add(Angle(1234));
  EXPECT_EQ(angle.value(), hashOf({1234}));
}

}  // namespace
}  // namespace platon::hash_test
