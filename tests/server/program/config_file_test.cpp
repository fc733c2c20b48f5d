#include "server/program/config_file.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>

#include "tests/support/files.h"
#include "tests/support/temporary_folder.h"

namespace platon::config_file_test {
namespace {

class ConfigFileTest : public testing::Test {
 protected:
  ServerOptions read(const std::string& text, ServerOptions options = {}) const {
    writeText(file_, text);
    EXPECT_EQ(readConfigFile(file_, options), std::vector<std::string>{});
    return options;
  }

  // The one error message after the file's name.
  static std::string errorOf(const std::string& text) {
    ServerOptions options;
    const std::vector<std::string> errors = readConfig(text, "file", options);
    EXPECT_EQ(errors.size(), 1u);
    EXPECT_EQ(options, ServerOptions{});
    return errors.empty() ? "none" : errors.front().substr(4);
  }

  const TemporaryFolder folder_;
  const std::string file_ = folder_ / "server.toml";
};

TEST_F(ConfigFileTest, ReadsEveryKey) {
  const ServerOptions expected{{folder_ / "a.level", "/b.level"},
                               "127.0.0.1",
                               1234,
                               5,
                               6,
                               "Ours",
                               LogFormat::kJson,
                               folder_ / "games",
                               folder_ / "bans.txt",
                               "/run/s",
                               "[::1]:19777"};
  EXPECT_EQ(read("levels = [\"a.level\", \"/b.level\"]\nport = 1234\nmax-players = 5\nmax-per-address = 6\n"
                 "bind = \"127.0.0.1\"\nname = \"Ours\"\nlog-format = \"json\"\nrecord = \"games\"\n"
                 "ban-file = \"bans.txt\"\nsocket = \"/run/s\"\nmetrics = \"[::1]:19777\"\n"),
            expected);
}

TEST_F(ConfigFileTest, KeysThatAreMissingKeepTheirValues) {
  ServerOptions before;
  before.port = 1;
  before.name = "Before";
  ServerOptions after = before;
  after.port = 2;
  EXPECT_EQ(read("port = 2\n", before), after);
  EXPECT_EQ(read("", before), before);
}

// And is not the folder of the file.
TEST_F(ConfigFileTest, AnEmptyPathStaysEmpty) {
  EXPECT_EQ(read("record = \"\"\nban-file = \"\"\nsocket = \"\"\n"), ServerOptions{});
}

TEST_F(ConfigFileTest, TextIsTheDefaultAndANamedLogFormat) {
  ServerOptions json;
  json.logFormat = LogFormat::kJson;
  EXPECT_EQ(read("log-format = \"text\"\n", json).logFormat, LogFormat::kText);
}

TEST_F(ConfigFileTest, ErrorsHaveALineAndAColumn) {
  EXPECT_EQ(
      errorOf("port = 7777\n  colour = 2\n"),
      ":2:3: error: 'colour' is not a key of the configuration; the keys are levels, bind, port, max-players, "
      "max-per-address, name, chat, log-format, record, record-limit, key-file, password-file, ban-file, best-times, "
      "socket, metrics, drain, drain-to, announce and announce-as");
  EXPECT_EQ(errorOf("port = 65536"), ":1:8: error: port must be a whole number from 0 to 65535");
  EXPECT_EQ(errorOf("port = 1.5"), ":1:8: error: port must be a whole number from 0 to 65535");
  EXPECT_EQ(errorOf("max-players = 0"), ":1:15: error: max-players must be a whole number from 1 to 256");
  EXPECT_EQ(errorOf("max-players = 257"), ":1:15: error: max-players must be a whole number from 1 to 256");
  EXPECT_EQ(errorOf("max-per-address = 4001"), ":1:19: error: max-per-address must be a whole number from 1 to 4000");
  EXPECT_EQ(errorOf("name = 3"), ":1:8: error: name must be a string in quotes");
  EXPECT_EQ(errorOf("name = \"\\u0007\""),
            ":1:8: error: name must be a text of at most 32 bytes without control characters");
  EXPECT_EQ(errorOf("levels = \"a\""), ":1:10: error: levels must be a list of files: [\"a.level\", \"b.level\"]");
  EXPECT_EQ(errorOf("levels = [1]"), ":1:11: error: levels must be a string in quotes");
  EXPECT_EQ(errorOf("record = true"), ":1:10: error: record must be a string in quotes");
  EXPECT_EQ(errorOf("log-format = \"xml\""), ":1:14: error: log-format must be \"text\" or \"json\"");
  EXPECT_EQ(errorOf("port = ").substr(0, 13), ":1:8: error: ");
  EXPECT_EQ(errorOf("port = [1]"), ":1:8: error: port must be a whole number from 0 to 65535");
  EXPECT_EQ(errorOf("name = [\"a\"]"), ":1:8: error: name must be a string in quotes");
  EXPECT_EQ(errorOf("bind = \"here\""),
            ":1:8: error: bind must be an IP address of this machine, such as 127.0.0.1 or ::, without a zone such as "
            "%eth0");
  EXPECT_EQ(errorOf("metrics = \"19777\""),
            ":1:11: error: metrics must be an address and a port, such as 127.0.0.1:19777 or [::1]:19777");
  EXPECT_EQ(errorOf("[port]\n"), ":1:1: error: port must be a whole number from 0 to 65535");
}

TEST_F(ConfigFileTest, ReportsAllErrorsInTheOrderOfTheText) {
  ServerOptions options;
  EXPECT_EQ(readConfig("port = 65536\nname = 3\ncolour = 1\nmax-players = 5\nbind = 4\n", "f", options),
            (std::vector<std::string>{"f:1:8: error: port must be a whole number from 0 to 65535",
                                      "f:2:8: error: name must be a string in quotes",
                                      "f:3:1: error: 'colour' is not a key of the configuration; the keys are levels, "
                                      "bind, port, max-players, max-per-address, name, chat, log-format, record, "
                                      "record-limit, key-file, password-file, ban-file, best-times, "
                                      "socket, metrics, drain, drain-to, announce and announce-as",
                                      "f:5:8: error: bind must be a string in quotes"}));
  EXPECT_EQ(options.maxPlayers, 5u);
}

TEST_F(ConfigFileTest, ErrorsAreLinesOfPrintableCharacters) {
  for (const std::string text :
       {"\"a\\nb\" = 1", "\"\\u202e\" = 1", "x = \x01", "\xff\xfe = 3", "a = \"\n", "\x1b[2J"}) {
    ServerOptions options;
    const std::vector<std::string> errors = readConfig(text, "file", options);
    ASSERT_EQ(errors.size(), 1u);
    for (const char byte : errors.front()) EXPECT_TRUE(byte >= ' ' && byte <= '~') << errors.front();
  }
}

TEST_F(ConfigFileTest, AFileThatCannotBeReadIsNamed) {
  ServerOptions options;
  EXPECT_EQ(
      readConfigFile("/no/such/file", options),
      std::vector<std::string>{"/no/such/file: error: No such file or directory; name a readable file after --config"});
  writeText(file_, std::string(1024 * 1024 + 1, '\n'));
  EXPECT_EQ(readConfigFile(file_, options),
            std::vector<std::string>{file_ + ": error: the file has more than 1048576 bytes"});
}

TEST_F(ConfigFileTest, WhatIsNoRegularFileIsRefused) {
  const auto errorOfFile = [this] {
    ServerOptions options;
    const std::vector<std::string> errors = readConfigFile(file_, options);
    std::filesystem::remove(file_);
    return errors.size() == 1 ? errors.front() : "not one error";
  };
  ASSERT_EQ(mkfifo(file_.c_str(), 0600), 0);
  EXPECT_EQ(errorOfFile(), file_ + ": error: it is a pipe, not a regular file; name a readable file after --config");
  std::filesystem::create_symlink("/dev/zero", file_);
  EXPECT_EQ(errorOfFile(), file_ + ": error: it is a device, not a regular file; name a readable file after --config");
}

std::string keyOf(std::size_t parts, const std::string& part = "a") {
  std::string key = part;
  for (std::size_t i = 1; i < parts; ++i) key += "." + part;
  return key;
}

constexpr const char* kTooManyParts = " error: more than 8 parts are joined by dots; a key has one part";
constexpr const char* kTooDeep = " error: more than 8 lists and tables are in each other; a value is at most a list";

// The parser makes a table in a table for each part, and a running server that reads the file again would end when it
// destroys them.
TEST_F(ConfigFileTest, AKeyOfTooManyPartsIsRefused) {
  for (const std::size_t parts : {9u, 1000u, 100'000u}) {
    const std::string key = keyOf(parts);
    EXPECT_EQ(errorOf(key + " = 1\n"), ":1:16:" + std::string(kTooManyParts));
    EXPECT_EQ(errorOf("port = 1\n[" + key + "]\n"), ":2:17:" + std::string(kTooManyParts));
    EXPECT_EQ(errorOf("[[" + key + "]]\n"), ":1:18:" + std::string(kTooManyParts));
    EXPECT_EQ(errorOf("x = {" + key + " = 1}"), ":1:21:" + std::string(kTooManyParts));
    EXPECT_EQ(errorOf("x = {y = 1, " + key + " = 1}"), ":1:28:" + std::string(kTooManyParts));
  }
  EXPECT_EQ(errorOf(keyOf(9, "\"a.'\"") + " = 1"), ":1:48:" + std::string(kTooManyParts));
  EXPECT_EQ(errorOf(keyOf(9, "'\"'") + " = 1"), ":1:32:" + std::string(kTooManyParts));
  EXPECT_EQ(errorOf(keyOf(9, " a\t") + " = 1"), ":1:32:" + std::string(kTooManyParts));
  EXPECT_TRUE(errorOf(keyOf(8) + " = 1").starts_with(":1:1: error: 'a' is not a key"));
}

// Dots and brackets mean nothing in strings and comments, and something again behind them.
TEST_F(ConfigFileTest, PartsAreCountedBehindEveryKindOfString) {
  const std::string dots = keyOf(20, "[");
  for (const std::string& text :
       {"\"" + dots + "\"", "'" + dots + "'", "\"\"\"\n" + dots + "\n\"\"\"", "'''" + dots + "\n'''",
        "\"\\\"" + dots + "\"", "\"\"\"" + dots + "\\\"\"\"\"\"\"", "'''" + dots + "'''''", "\"\" # \" " + dots}) {
    ServerOptions options;
    EXPECT_EQ(readConfig("record = " + text + "\n", "file", options), std::vector<std::string>{}) << text;
    const std::string error = errorOf("record = " + text + "\n" + keyOf(9) + " = 1");
    EXPECT_TRUE(error.ends_with(kTooManyParts)) << error;
  }
  // The last two quotes before the comma belong to the string.
  const std::string error = errorOf("x = {a = \"\"\"y\"\"\"\"\", " + keyOf(9) + " = 1}");
  EXPECT_TRUE(error.ends_with(kTooManyParts)) << error;
}

TEST_F(ConfigFileTest, ListsAndTablesThatAreNestedTooDeeplyAreRefused) {
  for (const std::size_t depth : {9u, 300u, 100'000u}) {
    EXPECT_EQ(errorOf("x = " + std::string(depth, '[') + std::string(depth, ']')), ":1:13:" + std::string(kTooDeep));
    std::string tables;
    for (std::size_t i = 0; i < depth; ++i) tables += "{a=";
    EXPECT_EQ(errorOf("x = " + tables + "1" + std::string(depth, '}')), ":1:29:" + std::string(kTooDeep));
  }
  EXPECT_TRUE(errorOf("x = " + std::string(8, '[') + std::string(8, ']')).starts_with(":1:1: error: 'x' is not a key"));
}

// The brackets of a name are no lists.
TEST_F(ConfigFileTest, ManyTablesBesideEachOtherAreNotNested) {
  std::string tables;
  for (int i = 0; i < 20; ++i) tables += "[[x]]\n";
  EXPECT_TRUE(errorOf(tables).starts_with(":1:3: error: 'x' is not a key")) << errorOf(tables);
  std::string unclosed;
  for (int i = 0; i < 20; ++i) unclosed += "[x\n";
  EXPECT_TRUE(errorOf(unclosed).starts_with(":1:")) << errorOf(unclosed);
}

}  // namespace
}  // namespace platon::config_file_test
