#include "server/base/line_buffer.h"

#include <gtest/gtest.h>

namespace platon::line_buffer_test {
namespace {

TEST(LineBuffer, CutsAStreamIntoLines) {
  LineBuffer buffer(10);
  buffer.add("one\ntw");
  EXPECT_TRUE(buffer.ready());
  EXPECT_EQ(buffer.next(), "one");
  EXPECT_FALSE(buffer.ready());
  EXPECT_EQ(buffer.next(), std::nullopt);
  buffer.add("o\r\n\nx\n");
  EXPECT_EQ(buffer.next(), "two");
  EXPECT_EQ(buffer.next(), "");
  EXPECT_EQ(buffer.next(), "x");
  EXPECT_EQ(buffer.next(), std::nullopt);
}

TEST(LineBuffer, ALineMayHaveTheLongestLength) {
  LineBuffer buffer(3);
  buffer.add("abc");
  EXPECT_FALSE(buffer.tooLong());
  buffer.add("\n");
  EXPECT_FALSE(buffer.tooLong());
  EXPECT_EQ(buffer.next(), "abc");
}

TEST(LineBuffer, ALineThatIsTooLongIsReportedBeforeItEnds) {
  LineBuffer buffer(3);
  buffer.add("ab\nabcd");
  EXPECT_FALSE(buffer.tooLong());
  EXPECT_EQ(buffer.next(), "ab");
  EXPECT_TRUE(buffer.tooLong());
  EXPECT_EQ(buffer.next(), std::nullopt);
  buffer.add("\nx\n");
  EXPECT_TRUE(buffer.tooLong());
  EXPECT_FALSE(buffer.ready());
  EXPECT_EQ(buffer.next(), std::nullopt);
}

}  // namespace
}  // namespace platon::line_buffer_test
