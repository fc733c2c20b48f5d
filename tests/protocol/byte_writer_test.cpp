#include "protocol/byte_writer.h"

#include <gtest/gtest.h>

#include "protocol/bytes.h"

namespace platon::byte_writer_test {
namespace {

Bytes varint(std::uint32_t value) {
  ByteWriter out;
  out.varint(value);
  return out.take();
}

TEST(ByteWriter, WritesVarintsLeastSignificantBitsFirst) {
  EXPECT_EQ(varint(0), Bytes({0}));
  EXPECT_EQ(varint(127), Bytes({127}));
  EXPECT_EQ(varint(128), Bytes({0x80, 0x01}));
  EXPECT_EQ(varint(300), Bytes({0xac, 0x02}));
  EXPECT_EQ(varint(UINT32_MAX), Bytes({0xff, 0xff, 0xff, 0xff, 0x0f}));
}

TEST(ByteWriter, WritesFixed32LeastSignificantByteFirst) {
  ByteWriter out;
  out.fixed32(0x01020304);
  EXPECT_EQ(out.take(), Bytes({4, 3, 2, 1}));
}

TEST(ByteWriter, AppendsInOrder) {
  ByteWriter out;
  out.byte(1);
  out.raw(Bytes{2, 3});
  out.varint(4);
  EXPECT_EQ(out.take(), Bytes({1, 2, 3, 4}));
}

}  // namespace
}  // namespace platon::byte_writer_test
