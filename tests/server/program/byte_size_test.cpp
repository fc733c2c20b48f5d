#include "server/program/byte_size.h"

#include <gtest/gtest.h>

namespace platon::byte_size_test {
namespace {

TEST(ByteSize, ANumberMayHaveAUnit) {
  EXPECT_EQ(parseByteSize("1"), 1u);
  EXPECT_EQ(parseByteSize("700"), 700u);
  EXPECT_EQ(parseByteSize("3K"), 3u * 1024);
  EXPECT_EQ(parseByteSize("64M"), 64u << 20);
  EXPECT_EQ(parseByteSize("10G"), std::uint64_t{10} << 30);
  EXPECT_EQ(parseByteSize("18446744073709551615"), UINT64_MAX);
  EXPECT_EQ(parseByteSize("17179869183G"), UINT64_MAX >> 30 << 30);
}

TEST(ByteSize, AnythingElseIsRefused) {
  for (const char* text : {"", "0", "0G", "-1", "+1", "K", "10 G", "10g", "10GB", "1.5G", "1e3", "0x10", " 1", "1 ",
                           "18446744073709551616", "17179869184G"}) {
    EXPECT_EQ(parseByteSize(text), std::nullopt) << text;
  }
}

}  // namespace
}  // namespace platon::byte_size_test
