#include "server/admin/console_command.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "protocol/label.h"
#include "protocol/limits.h"
#include "server/admin/ban_list.h"
#include "server/base/utc_time.h"
#include "tests/support/files.h"

namespace platon::console_command_test {
namespace {

using namespace std::chrono_literals;
using namespace std::string_literals;

AddressRange range(const std::string& text) { return std::get<AddressRange>(AddressRange::parse(text)); }

ConsoleCommand commandOf(const std::string& line) {
  auto parsed = parseConsoleCommand(line);
  if (const auto* error = std::get_if<ParseError>(&parsed)) ADD_FAILURE() << line << ": " << error->what;
  return std::get<ConsoleCommand>(std::move(parsed));
}

std::string errorOf(const std::string& line) {
  const auto parsed = parseConsoleCommand(line);
  const auto* error = std::get_if<ParseError>(&parsed);
  return error ? error->what : "none";
}

const std::string kPlayerMissing =
    "name a player: its number or its name, in quotes if it contains spaces (see the command players)";

TEST(ConsoleCommand, CommandsWithoutArguments) {
  EXPECT_EQ(commandOf("status"), ConsoleCommand(StatusCommand{}));
  EXPECT_EQ(commandOf("  players  "), ConsoleCommand(PlayersCommand{}));
  EXPECT_EQ(commandOf("bans"), ConsoleCommand(BansCommand{}));
  EXPECT_EQ(commandOf("next"), ConsoleCommand(NextCommand{}));
  EXPECT_EQ(commandOf("reload"), ConsoleCommand(ReloadCommand{}));
  EXPECT_EQ(commandOf("stop"), ConsoleCommand(StopCommand{}));
  EXPECT_EQ(commandOf("help"), ConsoleCommand(HelpCommand{}));
  EXPECT_EQ(errorOf("stop now"), "the command takes no arguments");
}

TEST(ConsoleCommand, Kick) {
  EXPECT_EQ(commandOf("kick 3"), ConsoleCommand(KickCommand{{"3"}, ""}));
  EXPECT_EQ(commandOf("kick Ann  too loud "), ConsoleCommand(KickCommand{{"Ann"}, "too loud"}));
  EXPECT_EQ(commandOf("kick \"Ann  B\" too loud"), ConsoleCommand(KickCommand{{"Ann  B"}, "too loud"}));
  EXPECT_EQ(commandOf("kick \"Ann\"loud"), ConsoleCommand(KickCommand{{"Ann"}, "loud"}));
  EXPECT_EQ(commandOf("kick Zoë"), ConsoleCommand(KickCommand{{"Zoë"}, ""}));
  for (const char* line : {"kick", "kick \"Ann", "kick \"\"", "kick \""})
    EXPECT_EQ(errorOf(line), kPlayerMissing) << line;
  EXPECT_EQ(errorOf("kick 3 " + std::string(100, 'x')), "none");
  EXPECT_EQ(errorOf("kick 3 " + std::string(101, 'x')), "the reason must have at most 100 bytes");
}

TEST(ConsoleCommand, Ban) {
  const auto ban = [](auto target, std::optional<std::chrono::seconds> duration, const std::string& reason) {
    return ConsoleCommand(BanCommand{target, duration, reason});
  };
  EXPECT_EQ(commandOf("ban 3"), ban(PlayerWord{"3"}, {}, ""));
  EXPECT_EQ(commandOf("ban Ann 2h too loud"), ban(PlayerWord{"Ann"}, 2h, "too loud"));
  EXPECT_EQ(commandOf("ban Ann too loud 2h"), ban(PlayerWord{"Ann"}, {}, "too loud 2h"));
  EXPECT_EQ(commandOf("ban 192.0.2.7"), ban(range("192.0.2.7"), {}, ""));
  EXPECT_EQ(commandOf("ban 192.0.2.0/24 7d proxies"), ban(range("192.0.2.0/24"), 168h, "proxies"));
  EXPECT_EQ(commandOf("ban 2001:db8::/32 4w"), ban(range("2001:db8::/32"), 672h, ""));
  EXPECT_EQ(commandOf("ban \"192.0.2.7\""), ban(PlayerWord{"192.0.2.7"}, {}, ""));  // a name in quotes
  EXPECT_EQ(commandOf("ban \"a/b:c\""), ban(PlayerWord{"a/b:c"}, {}, ""));
  EXPECT_EQ(errorOf("ban"), kPlayerMissing);
  EXPECT_EQ(errorOf("ban 192.0.2.7/24"), "'192.0.2.7/24' has bits after its first 24: write 192.0.2.0/24");
  EXPECT_TRUE(errorOf("ban 999.1.1.1").starts_with("'999.1.1.1' is not an address")) << "it was taken for a name";
  EXPECT_TRUE(errorOf("ban 192.0.2.x/24").ends_with("such as 192.0.2.7 or 2001:db8::/32"));
  EXPECT_TRUE(errorOf("ban 3 until tomorrow").starts_with("the reason must"));
  EXPECT_TRUE(errorOf("ban 3 2h # x").starts_with("the reason must"));
}

TEST(ConsoleCommand, Unban) {
  EXPECT_EQ(commandOf("unban 192.0.2.0/24"), ConsoleCommand(UnbanCommand{range("192.0.2.0/24")}));
  EXPECT_TRUE(errorOf("unban").starts_with("'' is not an address"));
  EXPECT_EQ(errorOf("unban 192.0.2.7 192.0.2.8"), "name one address or range (see the command bans)");
}

TEST(ConsoleCommand, MuteAndUnmute) {
  EXPECT_EQ(commandOf("mute 3"), ConsoleCommand(MuteCommand{{"3"}, true}));
  EXPECT_EQ(commandOf("unmute \"Ann B\""), ConsoleCommand(MuteCommand{{"Ann B"}, false}));
  EXPECT_EQ(errorOf("mute"), kPlayerMissing);
  EXPECT_EQ(errorOf("mute Ann B"), kPlayerMissing);
}

TEST(ConsoleCommand, SayTakesTheRestOfTheLineAsItIs) {
  EXPECT_EQ(commandOf("say  \"hi\"  # all, 2h "), ConsoleCommand(SayCommand{"\"hi\"  # all, 2h"}));
  const std::string refusal = "the text must have 1 to 200 bytes that can be seen";
  EXPECT_EQ(errorOf("say"), refusal);
  EXPECT_EQ(errorOf("say \xe2\x80\x8b"), refusal);  // a space of no width
  EXPECT_EQ(errorOf("say " + std::string(kMaxReasonBytes, 'x')), "none");
  EXPECT_EQ(errorOf("say " + std::string(kMaxReasonBytes + 1, 'x')), refusal);
}

TEST(ConsoleCommand, DrainTakesALimitAndAServer) {
  EXPECT_EQ(commandOf("drain"), ConsoleCommand(DrainCommand{}));
  EXPECT_EQ(commandOf("drain 1"), ConsoleCommand(DrainCommand{1s, ""}));
  EXPECT_EQ(commandOf("drain 86400 192.0.2.7:7777"), ConsoleCommand(DrainCommand{24h, "192.0.2.7:7777"}));
  EXPECT_EQ(commandOf("drain play.example.org"), ConsoleCommand(DrainCommand{{}, "play.example.org"}));
  const std::string range = "the limit is a number of seconds from 1 to 86400; stop ends the server at once";
  for (const char* line : {"drain 0", "drain 86401", "drain 99999999999999999999"})
    EXPECT_EQ(errorOf(line), range) << line;
  const std::string usage = "name a number of seconds, then perhaps one server, such as 600 play.example.org:7777";
  for (const char* line : {"drain 1 a b", "drain 1.5.0:x", "drain host:0", "drain 1 host:x", "drain 1 ho/st"})
    EXPECT_EQ(errorOf(line), usage) << line;
  EXPECT_EQ(errorOf("drain " + std::string(kMaxNextServerBytes, 'x')), "none");
  EXPECT_EQ(errorOf("drain " + std::string(kMaxNextServerBytes + 1, 'x')), usage);
}

TEST(ConsoleCommand, RefusesAnUnknownName) {
  EXPECT_EQ(errorOf("shutdown"), "'shutdown' is no command: help lists all");
  EXPECT_EQ(errorOf("STOP"), "'STOP' is no command: help lists all");
  EXPECT_EQ(errorOf(""), "'' is no command: help lists all");
  EXPECT_EQ(errorOf("stop;"), "'stop;' is no command: help lists all");
}

TEST(ConsoleCommand, RefusesALineThatIsNoText) {
  const std::string refusal = "a command is one line of at most 512 bytes of text without control characters";
  EXPECT_EQ(errorOf("status\n"), refusal);
  EXPECT_EQ(errorOf("stop\0"s + "x"), refusal);
  EXPECT_EQ(errorOf("kick \x1b[2J"), refusal);
  EXPECT_EQ(errorOf("kick \xff"), refusal);
  EXPECT_EQ(errorOf("say \xe2\x80\xae"
                    "txt"),
            refusal);  // reverses the direction of writing
  EXPECT_EQ(errorOf(std::string(kMaxConsoleLineBytes + 1, 'x')), refusal);
}

TEST(ConsoleCommand, TheHelpListsEveryCommandOnce) {
  std::vector<std::string> names;
  for (const ConsoleCommandHelp& one : consoleCommands()) {
    names.emplace_back(one.name);
    EXPECT_FALSE(one.meaning.empty());
    EXPECT_EQ(errorOf(names.back()).find("is no command"), std::string::npos) << one.name;
  }
  EXPECT_EQ(names, (std::vector<std::string>{"status", "players", "kick", "ban", "unban", "bans", "mute", "unmute",
                                             "say", "next", "reload", "drain", "stop", "help"}));
}

TEST(HostingPage, ListsEveryCommandWithItsArguments) {
  const std::string page = readText("docs/hosting.md");
  for (const ConsoleCommandHelp& one : consoleCommands()) {
    std::string row = "| `" + std::string(one.name);
    for (const char byte : " " + std::string(one.arguments))
      row += byte == '|' ? std::string("\\|") : std::string(1, byte);
    if (one.arguments.empty()) row.pop_back();
    EXPECT_NE(page.find(row + "` | "), std::string::npos) << row;
  }
}

// Any line is either refused with a printable sentence or gives values that the rest of the server accepts.
TEST(ConsoleCommand, SurvivesHostileLines) {
  const std::vector<std::string> parts{"ban",  "kick",  "say",       "unban", " ",     "\"",
                                       "\t",   "2h",    "::/0",      "/",     "until", "192.0.2.7",
                                       "#",    "\x1b[", "\xc3",      "\n",    "Zoë",   std::string(120, 'x'),
                                       "mute", "1",     "4294967296"};
  std::mt19937 random(11);
  int accepted = 0;
  for (int i = 0; i < 20000; ++i) {
    std::string line;
    for (std::size_t words = random() % 8; words > 0; --words)
      line += parts[random() % parts.size()] + (random() % 2 ? " " : "");
    const auto parsed = parseConsoleCommand(line);
    if (const auto* error = std::get_if<ParseError>(&parsed)) {
      EXPECT_TRUE(isLabel(error->what, 300)) << error->what;
      continue;
    }
    ++accepted;
    const auto& command = std::get<ConsoleCommand>(parsed);
    if (const auto* ban = std::get_if<BanCommand>(&command)) {
      const AddressRange target =
          std::holds_alternative<AddressRange>(ban->target) ? std::get<AddressRange>(ban->target) : range("192.0.2.7");
      BanList list;
      list.add({target, ban->duration ? parseUtcTime("2026-12-01") : std::nullopt, ban->reason});
      EXPECT_EQ(std::get<BanList>(BanList::parse(list.text())), list) << line;
    }
    if (const auto* say = std::get_if<SayCommand>(&command)) {
      EXPECT_TRUE(isLabel(say->text, kMaxReasonBytes));
    }
  }
  EXPECT_GT(accepted, 500);
}

}  // namespace
}  // namespace platon::console_command_test
