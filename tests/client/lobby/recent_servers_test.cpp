#include "client/lobby/recent_servers.h"

#include <filesystem>
#include <string>

#include <gtest/gtest.h>

#include "tests/support/files.h"
#include "tests/support/temporary_folder.h"

namespace platon::recent_servers_test {
namespace {

std::string textOf(const RecentServers& servers) {
  std::string text;
  for (const ServerAddress& server : servers.list()) text += server.text() + " ";
  return text;
}

TEST(RecentServers, TheNewestIsFirstAndNoneIsTwice) {
  const TemporaryFolder folder;
  const RecentServers servers(folder / "platon/recent_servers");
  EXPECT_EQ(textOf(servers), "");
  servers.remember({"first.example", 7777});
  servers.remember({"::1", 7778});
  servers.remember({"first.example", 7777});
  EXPECT_EQ(textOf(servers), "first.example:7777 [::1]:7778 ");
}

TEST(RecentServers, TheOldestAreForgotten) {
  const TemporaryFolder folder;
  const RecentServers servers(folder / "recent_servers");
  for (std::uint16_t port = 1; port <= 20; ++port) servers.remember({"host", port});
  EXPECT_EQ(servers.list().size(), RecentServers::kMaxServers);
  EXPECT_EQ(servers.list().front().port, 20);
}

TEST(RecentServers, AFileThatCannotBeReadIsNotReplaced) {
  const TemporaryFolder folder;
  std::filesystem::create_symlink(folder / "recent_servers", folder / "recent_servers");
  const RecentServers servers(folder / "recent_servers");
  servers.remember({"host", 1});
  EXPECT_EQ(textOf(servers), "");
  EXPECT_TRUE(std::filesystem::is_symlink(folder / "recent_servers"));
}

TEST(RecentServers, DamagedLinesAreIgnored) {
  const TemporaryFolder folder;
  writeText(folder / "recent_servers", "no address!\n\nhost:70000\nhost:1\n\xff\n");
  const RecentServers servers(folder / "recent_servers");
  EXPECT_EQ(textOf(servers), "host:1 ");
  RecentServers("").remember({"host", 1});
  EXPECT_EQ(textOf(RecentServers("")), "");
}

}  // namespace
}  // namespace platon::recent_servers_test
