#include "server/admin/console.h"

#include <algorithm>
#include <random>
#include <sstream>

#include <gtest/gtest.h>

#include "protocol/label.h"
#include "protocol/limits.h"
#include "server/admin/bans.h"
#include "server/base/utc_time.h"
#include "tests/support/files.h"
#include "tests/support/test_levels.h"

namespace platon::console_test {
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
    "name a player by number or by name, in quotes if it contains spaces (see the command 'players')";

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
  EXPECT_EQ(errorOf("ban 192.0.2.7/24"), "'192.0.2.7/24' has bits set after its first 24: write 192.0.2.0/24");
  EXPECT_TRUE(errorOf("ban 999.1.1.1").starts_with("'999.1.1.1' is not an address")) << "it was taken for a name";
  EXPECT_TRUE(errorOf("ban 192.0.2.x/24").ends_with("such as 192.0.2.7 or 2001:db8::/32"));
  EXPECT_TRUE(errorOf("ban 3 until tomorrow").starts_with("the reason must"));
  EXPECT_TRUE(errorOf("ban 3 2h # x").starts_with("the reason must"));
}

TEST(ConsoleCommand, Unban) {
  EXPECT_EQ(commandOf("unban 192.0.2.0/24"), ConsoleCommand(UnbanCommand{range("192.0.2.0/24")}));
  EXPECT_TRUE(errorOf("unban").starts_with("'' is not an address"));
  EXPECT_EQ(errorOf("unban 192.0.2.7 192.0.2.8"), "name one address or range (see the command 'bans')");
}

TEST(ConsoleCommand, MuteAndUnmute) {
  EXPECT_EQ(commandOf("mute 3"), ConsoleCommand(MuteCommand{{"3"}, true}));
  EXPECT_EQ(commandOf("unmute \"Ann B\""), ConsoleCommand(MuteCommand{{"Ann B"}, false}));
  EXPECT_EQ(errorOf("mute"), kPlayerMissing);
  EXPECT_EQ(errorOf("mute Ann B"), kPlayerMissing);
}

TEST(ConsoleCommand, SayTakesTheRestOfTheLineAsItIs) {
  EXPECT_EQ(commandOf("say  \"hi\"  # all, 2h "), ConsoleCommand(SayCommand{"\"hi\"  # all, 2h"}));
  const std::string refusal = "the text must have at most 200 bytes, and something that can be seen";
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
  const std::string range = "the limit must be a number of seconds from 1 to 86400; 'stop' stops the server at once";
  for (const char* line : {"drain 0", "drain 86401", "drain 99999999999999999999"})
    EXPECT_EQ(errorOf(line), range) << line;
  const std::string usage =
      "name a number of seconds, a server, or both in this order, such as 600 play.example.org:7777";
  for (const char* line : {"drain 1 a b", "drain 1.5.0:x", "drain host:0", "drain 1 host:x", "drain 1 ho/st"})
    EXPECT_EQ(errorOf(line), usage) << line;
  EXPECT_EQ(errorOf("drain " + std::string(kMaxNextServerBytes, 'x')), "none");
  EXPECT_EQ(errorOf("drain " + std::string(kMaxNextServerBytes + 1, 'x')), usage);
}

TEST(ConsoleCommand, RefusesAnUnknownName) {
  EXPECT_EQ(errorOf("shutdown"), "'shutdown' is not a command: 'help' lists all commands");
  EXPECT_EQ(errorOf("STOP"), "'STOP' is not a command: 'help' lists all commands");
  EXPECT_EQ(errorOf(""), "'' is not a command: 'help' lists all commands");
  EXPECT_EQ(errorOf("stop;"), "'stop;' is not a command: 'help' lists all commands");
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
    EXPECT_EQ(errorOf(names.back()).find("is not a command"), std::string::npos) << one.name;
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

ConsoleReply sent(const ConsoleReply& reply) {
  std::istringstream stream(encode(reply));
  ConsoleReplyReader reader;
  std::optional<ConsoleReply> received;
  for (std::string line; std::getline(stream, line);) {
    EXPECT_FALSE(received) << "a line after the end of the reply: " << line;
    received = reader.add(line);
  }
  return received.value();
}

TEST(ConsoleReply, TheEncodingIsThatOfTheManual) {
  EXPECT_EQ(encode(ConsoleReply{true, "one\n two"}), " one\n  two\nok\n");
  EXPECT_EQ(encode(ConsoleReply{false, "no"}), " no\nfailed\n");
  EXPECT_EQ(encode(ConsoleReply{true, ""}), "ok\n");
}

TEST(ConsoleReply, ArrivesAsItWasSent) {
  for (const ConsoleReply& reply : {ConsoleReply{true, ""},
                                    {false, ""},
                                    {true, "one"},
                                    {false, "one\ntwo\n three"},
                                    {true, "ok\nfailed"},
                                    {true, "a\n\nb"}}) {
    EXPECT_EQ(sent(reply), reply) << reply.text;
  }
}

TEST(ConsoleReply, AReaderReadsOneReplyAfterTheOther) {
  ConsoleReplyReader reader;
  EXPECT_EQ(reader.add(" a"), std::nullopt);
  EXPECT_EQ(reader.add("failed"), (ConsoleReply{false, "a"}));
  EXPECT_EQ(reader.add(" b"), std::nullopt);
  EXPECT_EQ(reader.add("ok"), (ConsoleReply{true, "b"}));
}

TEST(ConsoleReply, WhatATerminalWouldObeyIsNotPrinted) {
  ConsoleReplyReader reader;
  for (const char* line :
       {" \x1b[2J\x1b]0;title\x07", " tab\tbell\a", " \xe2\x80\xaename", " \xff\xc3", " \xc2\x9b\x7f", " µ “Zoë” 日本"})
    EXPECT_EQ(reader.add(line), std::nullopt);
  EXPECT_EQ(reader.add("ok"), (ConsoleReply{true, "?[2J?]0;title?\ntab?bell?\n?name\n??\n??\nµ “Zoë” 日本"}));
}

const UtcTime kNow = *parseUtcTime("2026-11-22T12:00:00Z");
constexpr std::size_t kMany = Console::kMaxBansListed + 50;

class ConsoleTest : public testing::Test {
 protected:
  void join(ClientId client, const std::string& name, const char* address = "127.0.0.1") {
    Hello hello;
    hello.name = name;
    hello.token = SessionToken{static_cast<std::uint8_t>(client)};
    match_.receive(client, hello, *IpAddress::parse(address));
    match_.takeOutgoing();
  }

  ConsoleReply run(std::string_view line) { return console_.execute(line, kNow); }

  // The reply to a command that must succeed.
  std::string text(std::string_view line) {
    const ConsoleReply reply = run(line);
    EXPECT_TRUE(reply.ok) << reply.text;
    return reply.text;
  }

  // The reply to a command that must fail.
  std::string error(std::string_view line) {
    const ConsoleReply reply = run(line);
    EXPECT_FALSE(reply.ok) << reply.text;
    return reply.text;
  }

  // The reasons of all Byes since the last call.
  std::vector<std::string> byes() {
    std::vector<std::string> reasons;
    for (const Outgoing& message : match_.takeOutgoing()) {
      const auto decoded = decodeToClient(message.bytes);
      if (decoded && std::holds_alternative<Bye>(*decoded)) reasons.push_back(std::get<Bye>(*decoded).reason);
    }
    return reasons;
  }

  Match match_{LevelRotation({levelOf(farGoalText()), levelOf(nearGoalText())}), {8, "Test"}};
  BanStore bans_;
  int reloads_ = 0;
  int stops_ = 0;
  std::optional<DrainCommand> drain_;
  std::vector<std::string> log_;
  Console console_{match_,
                   bans_,
                   {[] { return std::string("server: Test"); },
                    [this] {
                      ++reloads_;
                      return ConsoleReply{false, "broken"};
                    },
                    [this] { ++stops_; },
                    [this](const DrainCommand& command) {
                      drain_ = command;
                      return ConsoleReply{true, "drains"};
                    },
                    [this](std::string_view line) { log_.emplace_back(line); }}};
};

TEST_F(ConsoleTest, Status) {
  join(1, "Ann");
  join(2, "Ben");
  match_.disconnect(2);
  match_.tick();
  EXPECT_EQ(text("status"), "server: Test\nround: 1, level \"\", tick 1\nplayers: 2, disconnected: 1\nbans: 0");
}

TEST_F(ConsoleTest, PlayersAreListedByNumber) {
  EXPECT_EQ(text("players"), "no players");
  join(7, "Ann", "192.0.2.7");
  join(3, "Ben \"B\"");
  join(5, "Cid", "192.0.2.8");
  match_.disconnect(5);
  text("mute 2");
  EXPECT_EQ(text("players"),
            "1  192.0.2.7  \"Ann\", missed inputs: 0\n2  this machine  \"Ben \"B\"\", missed inputs: 0, muted\n"
            "3  192.0.2.8  \"Cid\", disconnected");
}

TEST_F(ConsoleTest, KickRemovesAPlayerByNumberOrName) {
  for (ClientId client = 1; client <= 4; ++client) join(client, client == 4 ? "Ann B" : "P" + std::to_string(client));
  EXPECT_EQ(text("kick 2"), "removed player 2 (P2)");
  EXPECT_EQ(byes(), std::vector<std::string>{"you were removed by the operator of the server"});
  EXPECT_EQ(text("kick P3 too loud"), "removed player 3 (P3)");
  EXPECT_EQ(byes(), std::vector<std::string>{"you were removed by the operator of the server: too loud"});
  EXPECT_EQ(text("kick \"Ann B\""), "removed player 4 (Ann B)");
  EXPECT_EQ(match_.players(), 1u);
  EXPECT_EQ(error("kick P3"), "there is no player 'P3': the command 'players' lists all of them");
  EXPECT_EQ(error("kick 0"), "there is no player '0': the command 'players' lists all of them");
}

TEST_F(ConsoleTest, ThePlayersOfAConnectionAreListedAndRemovedWithIt) {
  join(1, "Ann", "192.0.2.7");
  for (const std::uint32_t local : {1u, 2u}) match_.receive(1, Companion{local, true, "P" + std::to_string(local)});
  EXPECT_EQ(text("players"),
            "1  192.0.2.7  \"Ann\", missed inputs: 0\n"
            "2  192.0.2.7  \"P1\", with player 1, missed inputs: 0\n"
            "3  192.0.2.7  \"P2\", with player 1, missed inputs: 0");
  EXPECT_EQ(text("kick P1"), "removed player 2 (P1)");
  EXPECT_TRUE(byes().empty()) << "its connection stays";
  EXPECT_EQ(text("kick 1"), "removed player 1 (Ann), and 1 companion");
  EXPECT_TRUE(match_.idle());
}

TEST_F(ConsoleTest, TheLongestReasonFits) {
  join(1, "Ann");
  const std::string reason(kMaxKickReasonBytes, 'x');
  text("kick 1 " + reason);
  EXPECT_EQ(byes(), std::vector<std::string>{"you were removed by the operator of the server: " + reason});
}

// Nobody can make another player the target by the choice of a name.
TEST_F(ConsoleTest, ANumberNeverMeansAName) {
  join(1, "2");
  join(2, "Ann");
  EXPECT_EQ(text("kick 2"), "removed player 2 (Ann)");
  EXPECT_EQ(error("kick 2"), "there is no player '2': the command 'players' lists all of them");
}

TEST_F(ConsoleTest, BanRemovesThePlayerAndItsHousehold) {
  join(1, "Ann", "192.0.2.7");
  join(2, "Ben", "192.0.2.7");
  join(3, "Cid", "192.0.2.8");
  EXPECT_EQ(text("ban Ann 2h too loud"),
            "banned 192.0.2.7 until 2026-11-22T14:00:00Z: too loud\nremoved 2 players\n"
            "the ban ends with the server: name a file after --ban-file to keep bans");
  const std::string reason = "you are banned from this server until 2026-11-22T14:00:00Z: too loud";
  EXPECT_EQ(byes(), (std::vector<std::string>{reason, reason}));
  EXPECT_EQ(match_.players(), 1u);
  EXPECT_TRUE(bans_.list().find(*IpAddress::parse("192.0.2.7"), kNow));
}

TEST_F(ConsoleTest, AnIpv6PlayerIsListedByItsAddressAndBannedWithItsHousehold) {
  join(1, "Ann", "2001:db8::1");
  join(2, "Ben", "2001:db8::2");
  EXPECT_EQ(text("players"), "1  2001:db8::1  \"Ann\", missed inputs: 0\n2  2001:db8::2  \"Ben\", missed inputs: 0");
  EXPECT_TRUE(text("ban 2001:db8::1").starts_with("banned 2001:db8::1\nremoved 1 player\n"));
  EXPECT_TRUE(text("ban Ben").starts_with("banned 2001:db8::/64\nremoved 1 player\n"));
}

TEST_F(ConsoleTest, BanOfARange) {
  join(1, "Ann", "192.0.2.7");
  EXPECT_TRUE(text("ban 192.0.2.0/24").starts_with("banned 192.0.2.0/24\nremoved 1 player\n"));
  EXPECT_TRUE(
      text("ban 2001:db8::/32 7d").starts_with("banned 2001:db8::/32 until 2026-11-29T12:00:00Z\nremoved 0 players"));
  EXPECT_EQ(text("bans"), "192.0.2.0/24\n2001:db8::/32 until 2026-11-29T12:00:00Z");
  EXPECT_EQ(text("unban 192.0.2.0/24"), "192.0.2.0/24 may join again");
  EXPECT_EQ(error("unban 192.0.2.0/24"), "there is no ban of 192.0.2.0/24; the command 'bans' lists all of them");
}

TEST_F(ConsoleTest, APlayerOfThisMachineCannotBeBanned) {
  join(1, "Ann");
  EXPECT_EQ(error("ban 1"), "player 1 (Ann) plays on this machine, which cannot be banned: use 'kick'");
  EXPECT_EQ(match_.players(), 1u);
}

TEST_F(ConsoleTest, BansAreListedUpToABound) {
  EXPECT_EQ(text("bans"), "no bans");
  for (std::size_t i = 0; i < kMany; ++i) run("ban 10.0." + std::to_string(i / 256) + "." + std::to_string(i % 256));
  const std::string list = text("bans");
  EXPECT_EQ(static_cast<std::size_t>(std::count(list.begin(), list.end(), '\n')), Console::kMaxBansListed);
  EXPECT_TRUE(list.ends_with("\nand 50 more"));
}

TEST_F(ConsoleTest, ABanThatHasEndedIsListedAsSuch) {
  bans_.add({AddressRange(*IpAddress::parse("192.0.2.7")), kNow + std::chrono::seconds(1), ""}, kNow);
  EXPECT_EQ(console_.execute("bans", kNow + std::chrono::seconds(1)).text,
            "192.0.2.7 until 2026-11-22T12:00:01Z (ended)");
}

TEST_F(ConsoleTest, MuteAndUnmute) {
  join(1, "Ann");
  EXPECT_EQ(text("mute Ann"), "player 1 (Ann) is shown as \"Player 1\"");
  EXPECT_TRUE(match_.playerStatus().at(0).muted);
  EXPECT_EQ(text("unmute Ann"), "player 1 (Ann) is shown as \"Ann\"");
  EXPECT_FALSE(match_.playerStatus().at(0).muted);
  EXPECT_EQ(error("mute Ben"), "there is no player 'Ben': the command 'players' lists all of them");
}

TEST_F(ConsoleTest, SaySendsTheTextToThePlayers) {
  EXPECT_EQ(text("say hello"), "said to 0 players");
  join(1, "Ann");
  EXPECT_EQ(text("say restart at  noon"), "said to 1 player");
  const std::span<const Outgoing> sent = match_.takeOutgoing();
  ASSERT_EQ(sent.size(), 1u);
  EXPECT_EQ(decodeToClient(sent[0].bytes), ToClient(Notice{"restart at noon"}));
}

TEST_F(ConsoleTest, NextEndsTheRound) {
  join(1, "Ann");
  match_.tick();
  EXPECT_EQ(text("next"), "the round is over");
  EXPECT_EQ(error("next"), "the round is over already; the next one starts within seconds");
  for (std::uint32_t tick = 0; tick < MatchRounds::kPauseTicks; ++tick) match_.tick();
  EXPECT_EQ(match_.round(), 2u);
}

TEST_F(ConsoleTest, DrainIsHandedToTheProgram) {
  EXPECT_EQ(text("drain 600 [::1]:7777"), "drains");
  EXPECT_EQ(drain_, (DrainCommand{std::chrono::seconds(600), "[::1]:7777"}));
  EXPECT_EQ(log_, std::vector<std::string>{"drain 600 [::1]:7777"});
}

TEST_F(ConsoleTest, ReloadAndStopAskTheProgram) {
  EXPECT_EQ(error("reload"), "broken");
  EXPECT_EQ(reloads_, 1);
  EXPECT_EQ(text("stop"), "the server stops");
  EXPECT_EQ(stops_, 1);
}

TEST_F(ConsoleTest, HelpListsEveryCommandWithItsMeaning) {
  const std::string help = text("help");
  for (const ConsoleCommandHelp& one : consoleCommands()) {
    EXPECT_NE(("\n" + help).find("\n" + std::string(one.name) + " "), std::string::npos) << one.name;
    EXPECT_NE(help.find(one.meaning), std::string::npos) << one.name;
  }
}

TEST_F(ConsoleTest, LogsTheCommandsThatHaveChangedSomething) {
  join(1, "Ann");
  for (const char* line : {"status", "players", "bans", "help", "kick 9", "bogus", "reload", "mute 1", "next"})
    run(line);
  EXPECT_EQ(log_, (std::vector<std::string>{"mute 1", "next"}));
}

TEST_F(ConsoleTest, AnErrorOfTheLineIsTheReply) {
  EXPECT_EQ(error("bogus"), "'bogus' is not a command: 'help' lists all commands");
}

}  // namespace
}  // namespace platon::console_test
