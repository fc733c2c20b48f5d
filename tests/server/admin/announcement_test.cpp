#include "server/admin/announcement.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <thread>

#include "protocol/program_error.h"
#include "tests/support/files.h"
#include "tests/support/temporary_folder.h"

namespace platon {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class AnnouncementTest : public testing::Test {
 protected:
  Announcement announcement(const ServerIdentity& identity, const std::string& address) const {
    return Announcement(file_, identity, parseServerAddress(address));
  }

  std::vector<std::string> listed() const {
    const auto read = readServerList(readText(file_));
    EXPECT_THAT(std::get<ServerList>(read).faults, IsEmpty());
    std::vector<std::string> servers;
    for (const ListedServer& server : std::get<ServerList>(read).servers)
      servers.push_back(server.name + " " + server.address.text());
    return servers;
  }

  std::string refusal() const {
    try {
      announcement(first_, "a.example:1");
    } catch (const ProgramError& error) {
      EXPECT_EQ(error.exitCode(), ProgramError::kUsage);
      return error.what();
    }
    return "";
  }

  TemporaryFolder folder_;
  std::string file_ = folder_ / "servers.json";
  ServerIdentity first_ = ServerIdentity::random();
  ServerIdentity second_ = ServerIdentity::random();
};

TEST_F(AnnouncementTest, ServersShareAFile) {
  Announcement ann = announcement(first_, "a.example:1");
  Announcement bob = announcement(second_, "b.example:1");
  EXPECT_EQ(ann.enter("Ann"), "");
  EXPECT_EQ(bob.enter("Bob"), "");
  EXPECT_THAT(listed(), ElementsAre("Ann a.example:1", "Bob b.example:1"));
  EXPECT_EQ(ann.enter("Anna"), "") << "a new name";
  EXPECT_THAT(listed(), ElementsAre("Bob b.example:1", "Anna a.example:1"));
  EXPECT_EQ(bob.leave(), "");
  EXPECT_EQ(bob.leave(), "");
  EXPECT_THAT(listed(), ElementsAre("Anna a.example:1"));
}

TEST_F(AnnouncementTest, TheKeyAndTheAddressOfARestartedServerReplaceTheOldOnes) {
  EXPECT_EQ(announcement(first_, "a.example:1").enter("moved from"), "");
  EXPECT_EQ(announcement(first_, "a.example:2").enter("moved to"), "");
  EXPECT_THAT(listed(), ElementsAre("moved to a.example:2"));
  EXPECT_EQ(announcement(second_, "a.example:2").enter("new key"), "");
  EXPECT_THAT(listed(), ElementsAre("new key a.example:2"));
}

TEST_F(AnnouncementTest, RefusesAFileThatIsSomethingElse) {
  writeText(file_, "my notes");
  EXPECT_EQ(refusal(),
            "cannot announce the server in '" + file_ +
                "': it is no list of servers: JSON of at most 512 KiB with the key \"platonServers\"; correct "
                "the file or name another one after --announce");
  writeText(file_, "{\"platonServers\": [{}]}");
  EXPECT_THAT(refusal(), HasSubstr("server 1 of the list: \"address\" must be a text"));
  EXPECT_EQ(readText(file_), "{\"platonServers\": [{}]}");
}

TEST_F(AnnouncementTest, AFileThatIsDamagedMeanwhileStaysAsItIs) {
  Announcement ann = announcement(first_, "a.example:1");
  EXPECT_EQ(ann.enter("Ann"), "");
  writeText(file_, "damaged");
  EXPECT_THAT(ann.enter("Ann"), HasSubstr("no list of servers"));
  EXPECT_THAT(ann.leave(), HasSubstr("no list of servers"));
  EXPECT_EQ(readText(file_), "damaged");
}

TEST_F(AnnouncementTest, AFolderThatIsMissingIsNamedByTheSystem) {
  Announcement ann(folder_ / "none/servers.json", first_, parseServerAddress("a.example:1"));
  EXPECT_EQ(ann.enter("Ann"), "No such file or directory");
}

// Without the lock, servers that start at the same time would lose entries.
TEST_F(AnnouncementTest, ManyServersEnterAtTheSameTime) {
  {
    std::vector<std::jthread> servers;
    for (int i = 0; i < 8; ++i) {
      servers.emplace_back([this, i] {
        EXPECT_EQ(announcement(ServerIdentity::random(), "s" + std::to_string(i) + ".example").enter("S"), "");
      });
    }
  }
  EXPECT_EQ(listed().size(), 8u);
}

TEST_F(AnnouncementTest, NeedsAnAddressIfThereIsAFile) {
  EXPECT_FALSE(announcementOf("", "", first_));
  EXPECT_FALSE(announcementOf("", "play.example.org", first_));
  EXPECT_THROW(announcementOf(file_, "", first_), ProgramError);
  EXPECT_EQ(announcementOf(file_, "play.example.org", first_)->enter("Example"), "");
  EXPECT_THAT(listed(), ElementsAre("Example play.example.org:7777"));
}

}  // namespace
}  // namespace platon
