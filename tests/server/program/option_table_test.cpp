#include "server/program/option_table.h"

#include <gtest/gtest.h>

#include <regex>
#include <set>

#include "server/program/config_file.h"
#include "tests/support/files.h"

namespace platon::option_table_test {
namespace {

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

}  // namespace
}  // namespace platon::option_table_test
