#include "server/admin/console.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/test_levels.h"

namespace platon::console_test {
namespace {

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
  EXPECT_EQ(error("kick P3"), "there is no player 'P3': the command players lists all");
  EXPECT_EQ(error("kick 0"), "there is no player '0': the command players lists all");
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
  EXPECT_EQ(error("kick 2"), "there is no player '2': the command players lists all");
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
  EXPECT_EQ(error("unban 192.0.2.0/24"), "there is no ban of 192.0.2.0/24; the command bans lists all");
}

TEST_F(ConsoleTest, APlayerOfThisMachineCannotBeBanned) {
  join(1, "Ann");
  EXPECT_EQ(error("ban 1"), "player 1 (Ann) plays on this machine, which cannot be banned: use kick");
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
  EXPECT_EQ(error("mute Ben"), "there is no player 'Ben': the command players lists all");
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

TEST_F(ConsoleTest, AnErrorOfTheLineIsTheReply) { EXPECT_EQ(error("bogus"), "'bogus' is no command: help lists all"); }

}  // namespace
}  // namespace platon::console_test
