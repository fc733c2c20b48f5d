#include "server/program/config_check.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <algorithm>

#include "protocol/program_error.h"
#include "protocol/transport/server_identity.h"
#include "protocol/transport/udp_socket.h"
#include "server/admin/console_socket.h"
#include "server/admin/metrics.h"
#include "tests/support/files.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/test_levels.h"

namespace platon::config_check_test {
namespace {

class ConfigCheckTest : public testing::Test {
 protected:
  ConfigCheck check(const std::string& config, std::vector<const char*> arguments = {}) const {
    writeText(folder_ / "server.toml", config);
    const std::string file = folder_ / "server.toml";
    arguments.insert(arguments.begin(), {"platon-server", "--check-config", "--config", file.c_str()});
    return checkConfig(readCommandLine(static_cast<int>(arguments.size()), arguments.data()).value());
  }

  void write(const std::string& name, const std::string& text) const { writeText(folder_ / name, text); }
  std::string at(const std::string& name) const { return folder_ / name; }

  const TemporaryFolder folder_ = TemporaryFolder::forSockets();
};

TEST_F(ConfigCheckTest, AcceptsAValidConfiguration) {
  write("a.level", farGoalText());
  write("bans.txt", "192.0.2.7\n# x\n192.0.2.8\n");
  write("best", "0123456789abcdef 6 743 2026-12-01T18:00:00Z Ann\n");
  const ConfigCheck check =
      this->check("port = 0\nlevels = [\"a.level\", \"a.level\"]\nban-file = \"bans.txt\"\nbest-times = \"best\"\n");
  EXPECT_EQ(check.exitCode, 0);
  EXPECT_EQ(check.errors, std::vector<std::string>{});
  EXPECT_EQ(check.summary, "levels: 2, bans: 2, best times: 1");
}

TEST_F(ConfigCheckTest, WithoutLevelsItChecksThoseOfTheGame) {
  const ConfigCheck check = this->check("");
  EXPECT_EQ(check.exitCode, 0);
  EXPECT_EQ(check.summary, "levels: " + std::to_string(shippedLevels().size()));
}

TEST_F(ConfigCheckTest, ReportsEveryErrorOfEveryFile) {
  write("bad.level", "CUBE\n");
  write("bans.txt", "Ann\n192.0.2.7/24\n");
  const ConfigCheck check =
      this->check("levels = [\"missing.level\", \"bad.level\"]\nport = 70000\nban-file = \"bans.txt\"\ncolour = 1\n");
  EXPECT_EQ(check.exitCode, ProgramError::kUsage);
  std::vector<std::string> starts{at("server.toml") + ":2:8: error: port must be",
                                  at("server.toml") + ":4:1: error: 'colour' is not a key",
                                  "cannot read the level '" + at("missing.level") + "': No such file",
                                  at("bad.level") + ":1:1: error: ",
                                  at("bans.txt") + ":1:1: error: 'Ann' is not",
                                  at("bans.txt") + ":2:1: error: '192.0.2.7/24' has bits"};
  for (const std::string& start : starts) {
    EXPECT_TRUE(std::any_of(check.errors.begin(), check.errors.end(), [&start](const std::string& error) {
      return error.starts_with(start);
    })) << start;
  }
}

TEST_F(ConfigCheckTest, OnlyInvalidLevelsGiveTheExitCodeOfLevels) {
  write("bad.level", "CUBE\n");
  EXPECT_EQ(check("levels = [\"bad.level\"]\n").exitCode, ProgramError::kInvalid);
  EXPECT_EQ(check("levels = [\"bad.level\", \"missing.level\"]\n").exitCode, ProgramError::kUsage);
  EXPECT_EQ(check("levels = [\"missing.level\", \"bad.level\"]\n").exitCode, ProgramError::kUsage);
  EXPECT_EQ(check("levels = [\"bad.level\"]\nport = -1\n").exitCode, ProgramError::kUsage);
}

TEST_F(ConfigCheckTest, ChecksWhatTheCommandLineNames) {
  write("bans.txt", "Ann\n");
  const std::string bans = at("bans.txt");
  EXPECT_EQ(check("", {"--ban-file", bans.c_str()}).exitCode, ProgramError::kUsage);
  EXPECT_EQ(check("", {"--best-times", bans.c_str()}).exitCode, ProgramError::kUsage);
}

TEST_F(ConfigCheckTest, AMissingBanFileIsAnError) {
  const ConfigCheck check = this->check("port = 0\nban-file = \"bans.txt\"\n");
  EXPECT_EQ(check.exitCode, ProgramError::kUsage);
  EXPECT_EQ(check.errors,
            std::vector<std::string>{at("bans.txt") + ": error: No such file or directory; name a readable "
                                                      "ban file; it may be empty"});
}

TEST_F(ConfigCheckTest, AcceptsAKeyAndAPassword) {
  readKeyFile(at("key"));
  write("password", "sesame\n");
  const ConfigCheck check = this->check("port = 0\nkey-file = \"key\"\npassword-file = \"password\"\n");
  EXPECT_EQ(check.exitCode, 0);
  EXPECT_EQ(check.errors, std::vector<std::string>{});
  EXPECT_EQ(check.summary, "levels: " + std::to_string(shippedLevels().size()));
}

TEST_F(ConfigCheckTest, WarnsOfAKeyThatOthersMayOpen) {
  readKeyFile(at("key"));
  ASSERT_EQ(chmod(at("key").c_str(), 0644), 0);
  const ConfigCheck check = this->check("port = 0\nkey-file = \"key\"\n");
  EXPECT_EQ(check.exitCode, 0);
  EXPECT_EQ(
      check.errors,
      std::vector<std::string>{
          at("key") +
          ": warning: others may open the file, and anyone who has the key can pose as the server; run chmod 600 " +
          at("key")});
}

TEST_F(ConfigCheckTest, AMissingKeyIsNotMade) {
  const ConfigCheck check = this->check("key-file = \"key\"\n");
  EXPECT_EQ(check.exitCode, 0);
  EXPECT_TRUE(check.summary.ends_with(", a key will be made in " + at("key"))) << check.summary;
  EXPECT_FALSE(std::filesystem::exists(at("key")));
}

TEST_F(ConfigCheckTest, ReportsAKeyAndAPasswordThatTheServerWouldRefuse) {
  write("key", "not a key\n");
  write("password", "\n");
  const std::vector<std::string> both{
      at("key") + ": error: not a key of platon-server; for a new key, name a file that does not exist",
      at("password") + ": error: the first line is empty; write the password there"};
  const ConfigCheck check = this->check("port = 0\nkey-file = \"key\"\npassword-file = \"password\"\n");
  EXPECT_EQ(check.exitCode, ProgramError::kUsage);
  EXPECT_EQ(check.errors, both);
  const std::vector<std::string> missing{
      at("missing/key") + ": error: cannot be created: No such file or directory; name a file in a writable folder",
      at("missing/password") + ": error: No such file or directory; name a readable file"};
  EXPECT_EQ(this->check("port = 0\nkey-file = \"missing/key\"\npassword-file = \"missing/password\"\n").errors,
            missing);
}

// 198.51.100.1 is an address for documents.
TEST_F(ConfigCheckTest, ReportsAddressesThatTheMachineDoesNotHave) {
  const ConfigCheck check =
      this->check("bind = \"198.51.100.1\"\nmetrics = \"198.51.100.1:19777\"\nsocket = \"missing/console\"\n");
  EXPECT_EQ(check.exitCode, ProgramError::kUsage);
  const std::vector<std::string> errors{
      "cannot listen on 198.51.100.1: Cannot assign requested address; choose an address of this machine after --bind, "
      "or :: for "
      "all",
      "cannot serve metrics on 198.51.100.1: Cannot assign requested address; choose an address of this machine after "
      "--metrics",
      "cannot open the console at '" + at("missing/console") +
          "': No such file or directory; name another path after --socket"};
  EXPECT_EQ(check.errors, errors);
}

TEST_F(ConfigCheckTest, APortAndAConsoleThatAreInUseAreNoErrors) {
  const UdpSocket used("127.0.0.1", 0);
  const MetricsServer metrics(*parseSocketAddress("127.0.0.1:0"));
  const ConsoleSocket console(at("console"));
  const ConfigCheck check = this->check("bind = \"127.0.0.1\"\nport = " + std::to_string(used.address().port) +
                                        "\nmetrics = \"" + metrics.address().text() + "\"\nsocket = \"console\"\n");
  EXPECT_EQ(check.exitCode, 0);
  EXPECT_EQ(check.errors, std::vector<std::string>{});
  EXPECT_TRUE(std::filesystem::exists(at("console")));
}

// The check said that all was well, and the server did not start.
TEST_F(ConfigCheckTest, WarnsOfPortsInUseWhenNoServerAnswersAtTheConsole) {
  const UdpSocket used("127.0.0.1", 0);
  const MetricsServer metrics(*parseSocketAddress("127.0.0.1:0"));
  const ConfigCheck check = this->check("bind = \"127.0.0.1\"\nport = " + std::to_string(used.address().port) +
                                        "\nmetrics = \"" + metrics.address().text() + "\"\nsocket = \"console\"\n");
  EXPECT_EQ(check.exitCode, 0);
  const std::string remedy = ": Address already in use; stop the program that uses it or choose another port after --";
  const std::string note = "; ignore this if that program is this server, started with another --socket";
  EXPECT_EQ(check.errors,
            (std::vector<std::string>{
                "warning: cannot listen on " + used.address().text() + remedy + "port" + note,
                "warning: cannot serve metrics on " + metrics.address().text() + remedy + "metrics" + note}));
  EXPECT_FALSE(std::filesystem::exists(at("console")));
}

TEST_F(ConfigCheckTest, APipeInPlaceOfAnyFileIsNamedAndNotWaitedFor) {
  for (const char* name : {"a.level", "key", "password", "bans", "best", "list"})
    ASSERT_EQ(mkfifo(at(name).c_str(), 0600), 0);
  const ConfigCheck check = this->check(
      "port = 0\nlevels = [\"a.level\"]\nkey-file = \"key\"\npassword-file = \"password\"\nban-file = \"bans\"\n"
      "best-times = \"best\"\nannounce = \"list\"\nannounce-as = \"a.example\"\n");
  EXPECT_EQ(check.exitCode, ProgramError::kUsage);
  const std::string fault = "it is a pipe, not a regular file; ";
  const std::string remedy = "name a file that can be read and written, in a folder that exists";
  EXPECT_EQ(check.errors,
            (std::vector<std::string>{
                "cannot read the level '" + at("a.level") + "': " + fault + "name a readable level file",
                at("bans") + ": error: " + fault + "name a readable ban file; it may be empty",
                at("best") + ": error: " + fault + remedy, at("key") + ": error: " + fault + "name a readable file",
                at("password") + ": error: the first line is empty; write the password there",
                "cannot announce the server in '" + at("list") + "': " + fault + remedy}));
}

}  // namespace
}  // namespace platon::config_check_test
