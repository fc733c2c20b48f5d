#include "platon/game/state_bytes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace platon::state_bytes_test {
namespace {

using testing::ElementsAre;

TEST(StateBytesTest, IntegersAreLittleEndian) {
  StateWriter writer;
  writer.add(std::uint8_t{0x12});
  writer.add(std::uint16_t{0x3456});
  writer.add(std::int32_t{-2});
  writer.add(Point(1, -1));
  writer.add(Angle(0x1234));
  EXPECT_THAT(writer.take(), ElementsAre(0x12, 0x56, 0x34, 0xfe, 0xff, 0xff, 0xff, 1, 0, 0, 0, 0xff, 0xff, 0xff, 0xff,
                                         0x34, 0x12, 0, 0));
}

TEST(StateBytesTest, ReadsBackWhatWasWritten) {
  StateWriter writer;
  writer.add(std::uint64_t{0xfedcba9876543210U});
  writer.add(INT64_MIN);
  writer.add(std::int16_t{-300});
  writer.add(Point(INT32_MIN, INT32_MAX));
  writer.add(Angle(35999));
  const auto bytes = writer.take();
  StateReader reader(bytes);
  std::uint64_t large = 0;
  std::int64_t least = 0;
  std::int16_t small = 0;
  Point point;
  Angle angle;
  reader.read(large);
  reader.read(least);
  reader.read(small);
  EXPECT_EQ(reader.remaining(), 12u);
  EXPECT_FALSE(reader.finished());
  reader.read(point);
  reader.read(angle);
  EXPECT_TRUE(reader.finished());
  EXPECT_EQ(large, 0xfedcba9876543210U);
  EXPECT_EQ(least, INT64_MIN);
  EXPECT_EQ(small, -300);
  EXPECT_EQ(point, Point(INT32_MIN, INT32_MAX));
  EXPECT_EQ(angle, Angle(35999));
}

TEST(StateBytesTest, ReadingPastTheEndGivesZeroAndAnError) {
  const std::vector<std::uint8_t> bytes{1, 2, 3};
  StateReader reader(bytes);
  std::uint32_t value = 7;
  reader.read(value);
  EXPECT_EQ(value, 0u);
  EXPECT_FALSE(reader.ok());
  EXPECT_FALSE(reader.finished());
  std::uint8_t byte = 7;
  reader.read(byte);
  EXPECT_EQ(byte, 0) << "nothing is read after an error";
  EXPECT_FALSE(reader.finished());
}

TEST(StateBytesTest, RefusesAnglesOutOfRange) {
  for (const std::int32_t wrong : {-1, 36000, INT32_MAX, INT32_MIN}) {
    StateWriter writer;
    writer.add(wrong);
    const auto bytes = writer.take();
    StateReader reader(bytes);
    Angle angle(5);
    reader.read(angle);
    EXPECT_EQ(angle, Angle());
    EXPECT_FALSE(reader.ok());
    EXPECT_EQ(reader.remaining(), 0u);
  }
}

TEST(StateBytesTest, IsNotFinishedWhileBytesRemain) {
  const std::vector<std::uint8_t> bytes{1, 2};
  StateReader reader(bytes);
  std::uint8_t byte = 0;
  reader.read(byte);
  EXPECT_TRUE(reader.ok());
  EXPECT_FALSE(reader.finished());
}

TEST(StateBytesTest, ReadingFromNoBytesIsAnError) {
  StateReader reader({});
  EXPECT_TRUE(reader.finished());
  std::uint8_t byte = 0;
  reader.read(byte);
  EXPECT_FALSE(reader.finished());
}

}  // namespace
}  // namespace platon::state_bytes_test
