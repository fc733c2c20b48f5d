#include "levels/solve/recorded_way.h"

#include <gtest/gtest.h>

#include "tests/shared/game/played_game.h"

namespace platon::recorded_way_test {
namespace {

// To the right, to a goal on the floor.
Solution run() { return Solution(100, {Input{Input::kPresent | Input::kRight}}); }

TEST(RecordedWayTest, IsReadAsItWasRecorded) {
  const auto level = cubeLevel("0 0 -180 0", {"-240 -200 240 -200\n"}, "0 100 -184");
  const auto bytes = recordWay(level, run());
  const RecordedWay way = readRecordedWay(bytes);
  EXPECT_EQ(way.fault, "");
  ASSERT_TRUE(way.level);
  EXPECT_EQ(way.level->hash, level->hash);
  EXPECT_EQ(way.inputs, run());
}

TEST(RecordedWayTest, IsRefusedWhenItIsDamagedOrCutOff) {
  const auto level = cubeLevel("0 0 -180 0", {"-240 -200 240 -200\n"}, "0 100 -184");
  auto bytes = recordWay(level, run());
  for (const std::size_t length : {std::size_t{0}, std::size_t{10}, bytes.size() / 2, bytes.size() - 1}) {
    const RecordedWay way = readRecordedWay(std::span(bytes).first(length));
    EXPECT_NE(way.fault, "") << length << " bytes";
    EXPECT_FALSE(way.level);
  }
  bytes[bytes.size() / 2] ^= 1;
  EXPECT_NE(readRecordedWay(bytes).fault, "");
}

}  // namespace
}  // namespace platon::recorded_way_test
