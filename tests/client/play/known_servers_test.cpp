#include "client/play/known_servers.h"

#include <gtest/gtest.h>

#include "protocol/transport/server_identity.h"
#include "tests/support/files.h"
#include "tests/support/temporary_folder.h"

namespace platon {
namespace {

const ServerAddress kHere{"example.org", 7777};
const ServerAddress kThere{"2001:db8::1", 7778};

TEST(KnownServers, RemembersTheKeyOfEachServer) {
  const TemporaryFolder folder;
  const KnownServers servers(folder / "platon/known_servers");
  EXPECT_EQ(servers.find(kHere), std::nullopt);
  servers.remember(kHere, CryptoKey{1});
  servers.remember(kThere, CryptoKey{2});
  EXPECT_EQ(servers.find(kHere), CryptoKey{1});
  EXPECT_EQ(servers.find(kThere), CryptoKey{2});
  EXPECT_EQ(servers.find({"example.org", 7778}), std::nullopt);
  EXPECT_EQ(readText(servers.file()),
            "example.org:7777 " + textOf(CryptoKey{1}) + "\n[2001:db8::1]:7778 " + textOf(CryptoKey{2}) + "\n");
}

TEST(KnownServers, TheFirstKeyStaysAndOtherLinesAreKept) {
  const TemporaryFolder folder;
  writeText(folder / "known_servers", "# mine\nexample.org:7777 " + textOf(CryptoKey{5}) + "\nnonsense\n");
  const KnownServers servers(folder / "known_servers");
  servers.remember(kHere, CryptoKey{6});
  EXPECT_EQ(servers.find(kHere), CryptoKey{5});
  servers.remember(kThere, CryptoKey{7});
  EXPECT_TRUE(readText(servers.file()).starts_with("# mine\n"));
  EXPECT_EQ(servers.find(kThere), CryptoKey{7});
}

TEST(KnownServers, WithoutAFileNothingIsRemembered) {
  const KnownServers servers{std::filesystem::path()};
  servers.remember(kHere, CryptoKey{1});
  EXPECT_EQ(servers.find(kHere), std::nullopt);
}

}  // namespace
}  // namespace platon
