#include "client/desync/desync_detector.h"

#include <gtest/gtest.h>

#include "client/desync/desync_report.h"
#include "protocol/limits.h"
#include "tests/sim/verification.h"
#include "tests/support/flipped_bit.h"
#include "tests/support/test_level.h"

namespace platon {
namespace {

constexpr std::uint32_t kRight = 100;  // ticks that both games are the same
constexpr Input kStands{Input::kPresent};
constexpr Input kRuns{Input::kPresent | Input::kRight};

/// A server's game and a client's, which a flipped bit turns wrong.
class MismatchWatchTest : public testing::Test {
 protected:
  MismatchWatchTest() {
    play(kRight);
    watch_.agreed(own_);
  }

  void playServer(std::uint32_t ticks) {
    for (std::uint32_t i = 0; i < ticks; ++i) server_.advance(inputs_);
  }
  void playOwn(std::uint32_t ticks) {
    for (std::uint32_t i = 0; i < ticks; ++i) {
      own_.advance(inputs_);
      watch_.advanced(inputs_, own_);
    }
  }
  void play(std::uint32_t ticks) {
    playServer(ticks);
    playOwn(ticks);
  }

  // Turns the own game wrong, plays three ticks and hears of it.
  void goWrong() {
    ASSERT_TRUE(own_.restore(flippedBit(own_, "entity 0", "position")));
    play(3);
    ASSERT_NE(own_.hash(), server_.hash());
    watch_.differs(own_, shortHash(server_.hash()));
  }

  void expectPosition(const Desync& desync) {
    const auto difference = firstDifference(desync.own, *desync.server);
    ASSERT_TRUE(difference.has_value());
    EXPECT_EQ(difference->owner, "entity 0");
    EXPECT_EQ(difference->field, "position");
  }

  std::vector<Input> inputs_{kStands, kRuns};
  Game server_{endlessLevel()};
  Game own_ = server_;
  DesyncDetector watch_{5, own_};
};

TEST_F(MismatchWatchTest, HasNothingToSayOfAGameThatWasRight) {
  EXPECT_FALSE(watch_.abandoned().has_value());
  EXPECT_FALSE(watch_.replaced(server_, inputs_).has_value());
}

TEST_F(MismatchWatchTest, HasNothingToSayOfAGameThatCameRightByItself) {
  goWrong();
  watch_.agreed(own_);
  EXPECT_FALSE(watch_.abandoned().has_value());
  watch_.differs(own_, shortHash(server_.hash()));
  EXPECT_TRUE(watch_.abandoned().has_value()) << "the next one is";
}

TEST_F(MismatchWatchTest, ComparesAtTheServersTickWhenTheOwnGameIsThere) {
  goWrong();
  play(20);
  const Game own = own_;
  const auto found = watch_.replaced(server_, inputs_);
  ASSERT_TRUE(found.has_value());
  EXPECT_EQ(found->round, 5u);
  EXPECT_EQ(found->agreedAt, kRight);
  EXPECT_EQ(found->tick, kRight + 3);
  EXPECT_NE(found->ownHash, found->serverHash);
  EXPECT_EQ(found->guessedTicks, 0u);
  EXPECT_EQ(found->own, own);
  EXPECT_EQ(found->server, server_);
  expectPosition(*found);
}

TEST_F(MismatchWatchTest, BeginsAnewWithTheServersState) {
  goWrong();
  play(20);
  ASSERT_TRUE(watch_.replaced(server_, inputs_).has_value());
  EXPECT_FALSE(watch_.abandoned().has_value());
  own_ = server_;
  play(50);
  watch_.differs(own_, shortHash(own_.hash()) + 1);
  const auto found = watch_.replaced(server_, inputs_);
  ASSERT_TRUE(found.has_value());
  EXPECT_EQ(found->agreedAt, kRight + 23);
  const sim::Verification played = sim::Verifier(found->recording).run();
  EXPECT_EQ(played.fault, "");
  EXPECT_FALSE(played.divergence.has_value());
  EXPECT_EQ(played.firstTick, kRight + 23);
  EXPECT_EQ(played.ticks, 50u);
  EXPECT_TRUE(reportOf(*found).summary.ends_with("after tick 173 no field differs any more"));
}

TEST_F(MismatchWatchTest, GoesBackWhenTheOwnGameIsAhead) {
  goWrong();
  play(20);
  const Game own = own_;
  playOwn(7);
  const auto found = watch_.replaced(server_, inputs_);
  ASSERT_TRUE(found.has_value());
  EXPECT_EQ(found->own, own);
  expectPosition(*found);
}

// The one tick that is missing came with the state.
TEST_F(MismatchWatchTest, GoesOnByTheTickThatTheStateTellsOf) {
  goWrong();
  play(20);
  inputs_[0] = kRuns;
  playServer(1);
  Game own = own_;
  own.advance(inputs_);
  const auto found = watch_.replaced(server_, inputs_);
  ASSERT_TRUE(found.has_value());
  EXPECT_EQ(found->guessedTicks, 0u);
  EXPECT_EQ(found->own, own);
  EXPECT_EQ(reportOf(*found).text.find("never came"), std::string::npos);
}

TEST_F(MismatchWatchTest, SaysWhichTicksAreGuessed) {
  goWrong();
  playServer(6);
  const auto found = watch_.replaced(server_, inputs_);
  ASSERT_TRUE(found.has_value());
  EXPECT_EQ(found->own.tick(), server_.tick());
  EXPECT_EQ(found->guessedTicks, 5u);
  expectPosition(*found);
  EXPECT_NE(reportOf(*found).text.find("the inputs of the 5 ticks from 103 on never came here; all players were taken "
                                       "to do what they did in tick 108"),
            std::string::npos)
      << reportOf(*found).text;
}

TEST_F(MismatchWatchTest, DoesNotFollowAStateThatIsFarOff) {
  goWrong();
  playServer(static_cast<std::uint32_t>(DesyncDetector::kMaxStates) + 1);
  const auto found = watch_.replaced(server_, inputs_);
  ASSERT_TRUE(found.has_value());
  EXPECT_EQ(found->own, own_);
  const std::string text = reportOf(*found).text;
  EXPECT_NE(text.find("after ticks 103 here and 360 there"), std::string::npos) << text;
  EXPECT_NE(text.find("no own state of the server's tick"), std::string::npos) << text;
}

TEST_F(MismatchWatchTest, KeepsOnlyTheLastStates) {
  goWrong();
  playServer(5);
  playOwn(5 + static_cast<std::uint32_t>(DesyncDetector::kMaxStates));
  const auto found = watch_.replaced(server_, inputs_);
  ASSERT_TRUE(found.has_value());
  EXPECT_EQ(found->own, own_);
}

TEST_F(MismatchWatchTest, ReportsWhatTheServerNeverPutRight) {
  goWrong();
  play(5);
  const auto found = watch_.abandoned();
  ASSERT_TRUE(found.has_value());
  EXPECT_FALSE(found->server.has_value());
  EXPECT_EQ(found->own, own_);
  const DesyncReport report = reportOf(*found);
  EXPECT_EQ(report.summary,
            "round 5: the game was not the server's after tick 103, and was after tick 100; the server's state has not "
            "come, so that no field can be named");
}

// What no input explains, a fault of memory say, shows when the recording is played again.
TEST_F(MismatchWatchTest, TheRecordingTellsWhenInputsDoNotExplainIt) {
  goWrong();
  play(RecentRecording::kTicksBetweenCheckpoints);
  const auto found = watch_.replaced(server_, inputs_);
  ASSERT_TRUE(found.has_value());
  const sim::Verification played = sim::Verifier(found->recording).run();
  EXPECT_EQ(played.fault, "");
  ASSERT_TRUE(played.divergence.has_value());
  EXPECT_EQ(played.divergence->tick, kRight + 1);
  ASSERT_TRUE(played.divergence->difference.has_value());
  EXPECT_EQ(played.divergence->difference->owner, "entity 0");
}

TEST_F(MismatchWatchTest, TheReportHasEveryFieldOfBothGames) {
  goWrong();
  const auto found = watch_.replaced(server_, inputs_);
  ASSERT_TRUE(found.has_value());
  const DesyncReport report = reportOf(*found);
  std::size_t marked = 0;
  for (const StateField& field : fieldsOf(server_)) {
    const std::size_t at = report.text.find("\n  " + field.owner + " " + field.name + " ");
    const std::size_t markedAt = report.text.find("\n! " + field.owner + " " + field.name + " ");
    EXPECT_NE(at == std::string::npos, markedAt == std::string::npos) << field.owner << " " << field.name;
    marked += markedAt == std::string::npos ? 0 : 1;
  }
  EXPECT_EQ(marked, 1u) << report.text;
  EXPECT_NE(report.text.find("rules version"), std::string::npos);
}

}  // namespace
}  // namespace platon
