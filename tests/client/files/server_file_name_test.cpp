#include "client/files/server_file_name.h"

#include <gtest/gtest.h>

namespace platon::server_file_name_test {
namespace {

TEST(ServerFileName, IsHostAndPort) { EXPECT_EQ(serverFileName({"play.example.org", 7777}), "play.example.org_7777"); }

TEST(ServerFileName, CannotFormAPath) {
  EXPECT_EQ(serverFileName({"../a b", 1}), "..%2fa%20b_1");
  EXPECT_EQ(serverFileName({"2001:db8::1", 65535}), "2001%3adb8%3a%3a1_65535");
  EXPECT_EQ(serverFileName({"\xc5\x81", 1}), "%c5%81_1");
}

}  // namespace
}  // namespace platon::server_file_name_test
