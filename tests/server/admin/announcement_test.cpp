#include "server/admin/announcement.h"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <thread>

#include "protocol/files/descriptor.h"
#include "protocol/program_error.h"
#include "tests/support/files.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/wait_until.h"

namespace platon::announcement_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

using Outcome = Announcement::Outcome;

// Make a change at once, and return why it failed.
std::string enter(Announcement& announcement, std::string_view name) {
  announcement.enter(name);
  const auto outcome = announcement.finish();
  EXPECT_TRUE(outcome && outcome->enters);
  return outcome ? outcome->fault : "no outcome";
}
std::string leave(Announcement& announcement) {
  announcement.leave();
  const auto outcome = announcement.finish();
  EXPECT_TRUE(outcome && !outcome->enters);
  return outcome ? outcome->fault : "no outcome";
}

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
  EXPECT_EQ(enter(ann, "Ann"), "");
  EXPECT_EQ(enter(bob, "Bob"), "");
  EXPECT_THAT(listed(), ElementsAre("Ann a.example:1", "Bob b.example:1"));
  EXPECT_EQ(enter(ann, "Anna"), "") << "a new name";
  EXPECT_THAT(listed(), ElementsAre("Bob b.example:1", "Anna a.example:1"));
  EXPECT_EQ(leave(bob), "");
  EXPECT_EQ(leave(bob), "");
  EXPECT_THAT(listed(), ElementsAre("Anna a.example:1"));
}

TEST_F(AnnouncementTest, ARestartedServerReplacesTheEntryOfItsAddress) {
  Announcement old = announcement(first_, "a.example:1");
  EXPECT_EQ(enter(old, "old key"), "");
  Announcement fresh = announcement(second_, "a.example:1");
  EXPECT_EQ(enter(fresh, "new key"), "");
  EXPECT_THAT(listed(), ElementsAre("new key a.example:1"));
}

TEST_F(AnnouncementTest, ServersThatShareAKeyShareAFile) {
  Announcement one = announcement(first_, "a.example:1");
  Announcement two = announcement(first_, "b.example:1");
  EXPECT_EQ(enter(one, "One"), "");
  EXPECT_EQ(enter(two, "Two"), "");
  EXPECT_THAT(listed(), ElementsAre("One a.example:1", "Two b.example:1"));
  EXPECT_EQ(leave(one), "");
  EXPECT_THAT(listed(), ElementsAre("Two b.example:1"));
}

// The service of systemd runs with such a mask, and a web server is another user.
TEST_F(AnnouncementTest, AWebServerMayReadANewFile) {
  const mode_t before = umask(0077);
  Announcement ann = announcement(first_, "a.example:1");
  EXPECT_EQ(enter(ann, "Ann"), "");
  umask(before);
  struct stat status {};
  ASSERT_EQ(stat(file_.c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 0777u, 0644u);
}

TEST_F(AnnouncementTest, AFileThatHoldsTheEntryIsNotWrittenAgain) {
  Announcement ann = announcement(first_, "a.example:1");
  EXPECT_EQ(leave(ann), "");
  EXPECT_FALSE(std::filesystem::exists(file_));
  EXPECT_EQ(enter(ann, "Ann"), "");
  Announcement bob = announcement(second_, "b.example:1");
  EXPECT_EQ(enter(bob, "Bob"), "");
  struct stat first {};
  ASSERT_EQ(stat(file_.c_str(), &first), 0);
  const Descriptor open(::open(file_.c_str(), O_RDONLY | O_CLOEXEC));  // keeps the number of the file from being reused
  EXPECT_EQ(enter(ann, "Ann"), "");
  struct stat second {};
  ASSERT_EQ(stat(file_.c_str(), &second), 0);
  EXPECT_EQ(first.st_ino, second.st_ino);
}

TEST_F(AnnouncementTest, TellsOnceHowAChangeEnded) {
  Announcement ann = announcement(first_, "a.example:1");
  const FileWriter::Time now{};
  EXPECT_EQ(ann.poll(now), std::nullopt);
  ann.enter("Ann");
  std::optional<Outcome> outcome;
  EXPECT_TRUE(waitUntil([&] { return (outcome = ann.poll(now)).has_value(); }));
  EXPECT_EQ(outcome, (Outcome{true, ""}));
  EXPECT_EQ(ann.poll(now), std::nullopt);
  EXPECT_EQ(ann.finish(), std::nullopt);
}

// Ticks call these functions, so none of them may wait for a lock that another program keeps.
TEST_F(AnnouncementTest, AStuckLockDelaysNobodyAndIsTriedAgain) {
  Announcement ann = announcement(first_, "a.example:1");
  Descriptor lock(open((file_ + ".lock").c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644));
  ASSERT_EQ(flock(lock.number(), LOCK_EX), 0);
  const FileWriter::Time now{};
  ann.enter("Ann");
  EXPECT_EQ(ann.poll(now), std::nullopt);
  EXPECT_EQ(ann.poll(now), std::nullopt) << "whoever had waited for the lock would know by now";
  std::optional<Outcome> outcome;
  EXPECT_TRUE(waitUntil([&] { return (outcome = ann.poll(now)).has_value(); }));
  EXPECT_EQ(outcome, (Outcome{true, "another program holds the lock on '" + file_ + ".lock'; end that program"}));
  lock = Descriptor();
  EXPECT_TRUE(waitUntil([&] { return (outcome = ann.poll(now + FileWriter::kRetryInterval)).has_value(); }));
  EXPECT_EQ(outcome, (Outcome{true, ""}));
  EXPECT_THAT(listed(), ElementsAre("Ann a.example:1"));
}

TEST_F(AnnouncementTest, RefusesAFileThatIsSomethingElse) {
  writeText(file_, "my notes");
  EXPECT_EQ(
      refusal(),
      "cannot announce the server in '" + file_ +
          "': it is not a list of servers, which is JSON of at most 512 KiB with the key \"platonServers\"; correct "
          "the file or name another one after --announce");
  writeText(file_, "{\"platonServers\": [{}]}");
  EXPECT_THAT(refusal(), HasSubstr("server 1 of the list: \"address\" must be a string"));
  EXPECT_EQ(readText(file_), "{\"platonServers\": [{}]}");
}

TEST_F(AnnouncementTest, AFileThatIsDamagedMeanwhileStaysAsItIs) {
  Announcement ann = announcement(first_, "a.example:1");
  EXPECT_EQ(enter(ann, "Ann"), "");
  writeText(file_, "damaged");
  EXPECT_THAT(enter(ann, "Ann"), HasSubstr("not a list of servers"));
  EXPECT_THAT(leave(ann), HasSubstr("not a list of servers"));
  EXPECT_EQ(readText(file_), "damaged");
}

TEST_F(AnnouncementTest, AFileThatCannotBeReachedIsRefused) {
  file_ = folder_ / ("sub" + std::string(300, 'x') + "/servers.json");
  EXPECT_THAT(refusal(), HasSubstr("File name too long"));
}

TEST_F(AnnouncementTest, AFolderThatIsMissingIsRefused) {
  file_ = folder_ / "none/servers.json";
  EXPECT_EQ(refusal(), "cannot announce the server in '" + file_ +
                           "': No such file or directory; name a file that can be read and written, in a folder that "
                           "exists");
}

// Without the lock, servers that start at the same time would lose entries.
TEST_F(AnnouncementTest, ManyServersEnterAtTheSameTime) {
  {
    std::vector<std::jthread> servers;
    for (int i = 0; i < 8; ++i) {
      servers.emplace_back([this, i] {
        Announcement each = announcement(ServerIdentity::random(), "s" + std::to_string(i) + ".example");
        EXPECT_EQ(enter(each, "S"), "");
      });
    }
  }
  EXPECT_EQ(listed().size(), 8u);
}

TEST_F(AnnouncementTest, NeedsAnAddressIfThereIsAFile) {
  EXPECT_FALSE(announcementOf("", "", first_));
  EXPECT_FALSE(announcementOf("", "play.example.org", first_));
  EXPECT_THROW(announcementOf(file_, "", first_), ProgramError);
  std::optional<Announcement> ann = announcementOf(file_, "play.example.org", first_);
  EXPECT_EQ(enter(*ann, "Example"), "");
  EXPECT_THAT(listed(), ElementsAre("Example play.example.org:7777"));
}

}  // namespace
}  // namespace platon::announcement_test
