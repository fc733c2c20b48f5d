#include "protocol/bytes.h"

#include <gtest/gtest.h>

namespace platon::bytes_test {
namespace {

TEST(ByteReader, ReadsWhatByteWriterWrites) {
  for (int bit = 0; bit < 32; ++bit) {
    for (const std::uint32_t value : {1u << bit, (1u << bit) - 1, ~0u >> bit}) {
      ByteWriter out;
      out.varint(value);
      out.fixed32(value);
      out.byte(0x5a);
      const Bytes bytes = out.take();
      ByteReader in(bytes);
      EXPECT_EQ(in.varint(), value);
      EXPECT_EQ(in.fixed32(), value);
      EXPECT_EQ(in.byte(), 0x5a);
      EXPECT_TRUE(in.ok() && in.atEnd());
    }
  }
}

TEST(ByteReader, RefusesVarintsThatAreTruncatedTooLongOrTooLarge) {
  for (const Bytes& bytes : {Bytes{}, Bytes{0x80}, Bytes{0x80, 0x00}, Bytes{0xff, 0xff, 0xff, 0xff, 0x10},
                             Bytes{0xff, 0xff, 0xff, 0xff, 0x8f, 0x01}}) {
    ByteReader in(bytes);
    EXPECT_EQ(in.varint(), 0u);
    EXPECT_FALSE(in.ok());
  }
}

TEST(ByteReader, StaysBadAfterReadingPastTheEnd) {
  const Bytes bytes{1, 2, 3};
  ByteReader in(bytes);
  EXPECT_EQ(in.fixed32(), 0u);
  EXPECT_FALSE(in.ok());
  EXPECT_EQ(in.byte(), 0u);
  EXPECT_FALSE(in.ok());
}

TEST(ByteReader, RemainingStartsAfterTheBytesRead) {
  const Bytes bytes{1, 2, 3};
  ByteReader in(bytes);
  in.byte();
  EXPECT_EQ(Bytes(in.remaining().begin(), in.remaining().end()), Bytes({2, 3}));
}

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
}  // namespace platon::bytes_test
