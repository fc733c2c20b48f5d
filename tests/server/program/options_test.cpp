#include "server/program/options.h"

#include <sys/stat.h>

#include <filesystem>
#include <regex>
#include <set>

#include <gtest/gtest.h>

#include "tests/support/files.h"
#include "tests/support/temporary_folder.h"

namespace platon::options_test {
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

const ServerOption& optionOf(std::string_view name) {
  for (const ServerOption& option : serverOptions()) {
    if (option.name == name) return option;
  }
  throw std::runtime_error("no option " + std::string(name));
}

// The fenced block of a page that follows this text.
std::string blockAfter(const std::string& page, const std::string& text) {
  const std::size_t begin = page.find('\n', page.find("```", page.find(text))) + 1;
  return page.substr(begin, page.find("```", begin) - begin);
}

TEST(OptionTable, NamesAreUniqueAndDescribed) {
  std::set<std::string_view> names;
  for (const ServerOption& option : serverOptions()) {
    EXPECT_TRUE(names.insert(option.name).second) << option.name;
    EXPECT_FALSE(option.help.empty()) << option.name;
    EXPECT_FALSE(option.help.ends_with('.')) << option.name;
    EXPECT_FALSE(option.placeholder.empty()) << option.name;
    EXPECT_EQ(option.accepts != nullptr, !option.mustBe.empty()) << option.name;
  }
}

TEST(OptionTable, EveryDefaultIsAValueOfItsOption) {
  const ServerOptions defaults;
  for (const ServerOption& option : serverOptions()) {
    ServerOptions options;
    EXPECT_EQ(setOption(option, valueOf(option, defaults), options), std::nullopt) << option.name;
    EXPECT_EQ(options, defaults) << option.name;
  }
}

TEST(OptionTable, EveryOptionSetsAMemberOfItsOwn) {
  std::set<std::string> changed;
  for (const ServerOption& option : serverOptions()) {
    ServerOptions options;
    OptionValue value = std::string("x");
    if (option.most != 0) value = option.least;
    if (option.isList()) value = std::vector<std::string>{"x"};
    if (option.name == "bind") value = std::string("127.0.0.1");
    if (option.name == "chat") value = std::string("off");
    if (option.name == "log-format") value = std::string("json");
    if (option.name == "drain") value = std::int64_t{600};
    if (option.name == "metrics") value = std::string("[::1]:1");
    if (option.name == "record-limit") value = std::string("5M");
    EXPECT_EQ(setOption(option, value, options), std::nullopt) << option.name;
    EXPECT_EQ(valueOf(option, options), value) << option.name;
    for (const ServerOption& other : serverOptions()) {
      const bool differs = valueOf(other, options) != valueOf(other, ServerOptions{});
      EXPECT_EQ(differs, &other == &option) << option.name << " changes " << other.name;
    }
  }
}

TEST(OptionTable, NumbersHaveARange) {
  const ServerOption& players = optionOf("max-players");
  ServerOptions options;
  const ParseError error{"must be a whole number from 1 to 256"};
  for (const char* text : {"0", "257", "-1", "1.5", "", "x", "1x", " 1", "99999999999999999999"}) {
    EXPECT_EQ(setOption(players, std::string(text), options), error) << text;
  }
  EXPECT_EQ(setOption(players, OptionValue(std::int64_t{-1}), options), error);
  EXPECT_EQ(setOption(players, OptionValue(std::int64_t{4294967297}), options), error);
  EXPECT_EQ(options, ServerOptions{});
  EXPECT_EQ(setOption(players, std::string("256"), options), std::nullopt);
  EXPECT_EQ(options.maxPlayers, 256u);
}

TEST(OptionTable, TextsAreChecked) {
  ServerOptions options;
  EXPECT_EQ(setOption(optionOf("name"), std::string(32, 'x'), options), std::nullopt);
  EXPECT_EQ(setOption(optionOf("name"), std::string(33, 'x'), options),
            ParseError{"must be a text of at most 32 bytes without control characters"});
  EXPECT_EQ(setOption(optionOf("bind"), std::string("::1"), options), std::nullopt);
  EXPECT_TRUE(setOption(optionOf("bind"), std::string("localhost"), options));
  EXPECT_TRUE(setOption(optionOf("bind"), std::string(), options));
  EXPECT_TRUE(setOption(optionOf("log-format"), std::string(), options));
  EXPECT_EQ(setOption(optionOf("metrics"), std::string(), options), std::nullopt);
  EXPECT_EQ(setOption(optionOf("record-limit"), std::string("500M"), options), std::nullopt);
  EXPECT_EQ(setOption(optionOf("record-limit"), std::string("5 MB"), options),
            ParseError{"must be a number of bytes, or one with K, M or G, such as 500M"});
}

TEST(PrintedConfig, GivesTheDefaults) {
  ServerOptions options{{"x"}, "::", 1, 2, 3, "x", LogFormat::kJson, "x", "x", "x", "x", "x", "x", "x", "x", "off"};
  EXPECT_EQ(readConfig(printedConfig(), "server.toml", options), std::vector<std::string>{});
  EXPECT_EQ(options, ServerOptions{});
}

TEST(PrintedConfig, ExplainsEveryKey) {
  const std::string text = "\n" + printedConfig();
  for (const ServerOption& option : serverOptions()) {
    const std::size_t key = text.find("\n" + std::string(option.name) + " = ");
    ASSERT_NE(key, std::string::npos) << option.name;
    const std::size_t comment = text.rfind('\n', key - 1) + 1;
    EXPECT_EQ(text.substr(comment, option.help.size() + 2), "# " + std::string(option.help));
  }
}

TEST(HostingPage, ShowsThePrintedConfiguration) {
  EXPECT_EQ(blockAfter(readText("docs/hosting.md"), "## Configuration file"), printedConfig());
}

TEST(HostingPage, ShowsEveryOptionOfTheCommandLineAndNoOther) {
  const std::string usage = blockAfter(readText("docs/hosting.md"), "# Hosting");
  std::set<std::string> expected{"[--config FILE]", "--console [--socket PATH] [--config FILE]", "--print-config",
                                 "--check-config [--config FILE]"};
  for (const ServerOption& option : serverOptions()) {
    const std::string placeholder(option.placeholder);
    expected.insert(option.name == kLevelsOption ? "[" + placeholder + "…]"
                                                 : "[--" + std::string(option.name) + " " + placeholder + "]");
  }
  for (const std::string& one : expected) EXPECT_NE(usage.find(one), std::string::npos) << one;
  const std::regex word("--([a-z-]+)");
  for (auto found = std::sregex_iterator(usage.begin(), usage.end(), word); found != std::sregex_iterator(); ++found) {
    const std::string name = (*found)[1];
    const std::set<std::string> others{"config", "console", "print-config", "check-config"};
    EXPECT_TRUE(others.contains(name) || optionOf(name).name == name);
  }
}

// Which options a reload changes, as the row of SIGHUP says.
TEST(HostingPage, SaysWhichOptionsNeedNoRestart) {
  const std::string page = readText("docs/hosting.md");
  const std::size_t begin = page.find("| SIGHUP |");
  const std::string row = page.substr(begin, page.find('\n', begin) - begin);
  std::string atOnce;
  for (const ServerOption& option : serverOptions()) {
    if (!option.needsRestart) atOnce += (atOnce.empty() ? "`" : ", `") + std::string(option.name) + "`";
  }
  EXPECT_NE(row.find("takes over " + atOnce), std::string::npos) << atOnce;
}

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
            std::vector<std::string>{
                file_ + ": error: the file has more than 1048576 bytes; name a configuration file after --config"});
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
constexpr const char* kTooDeep = " error: lists and tables are nested more than 8 deep; a value is at most a list";

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
}  // namespace platon::options_test
