#include "client/session/dialogue.h"

#include <gtest/gtest.h>

#include <variant>
#include <vector>

#include "client/netcode/prediction_clock.h"

namespace platon::dialogue_test {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

class DialogueTest : public testing::Test {
 protected:
  template <class Message>
  std::vector<Message> sent() {
    std::vector<Message> found;
    for (const OutgoingMessage& message : dialogue_.takeOutgoing()) {
      const auto decoded = decodeToServer(message.bytes);
      EXPECT_EQ(message.reliable, !(std::is_same_v<Message, PlayerInputs>));
      if (decoded && std::holds_alternative<Message>(*decoded)) found.push_back(std::get<Message>(*decoded));
    }
    return found;
  }

  const Hello hello_{kRulesVersion, "Ann", SessionToken{3}, {7, 8}};
  Dialogue dialogue_{hello_, seconds(1)};
};

TEST_F(DialogueTest, BeginsWithHello) {
  EXPECT_EQ(sent<Hello>(), std::vector{hello_});
  EXPECT_TRUE(dialogue_.takeOutgoing().empty()) << "each message is taken once";
  EXPECT_FALSE(dialogue_.ending());
  EXPECT_FALSE(dialogue_.welcome());
}

TEST_F(DialogueTest, TheFirstLeadIsThatOfTheTimeToWelcome) {
  const Welcome welcome{3, 1, 17, 4, kTicksPerSecond, "Test"};
  EXPECT_EQ(dialogue_.begin(welcome, seconds(3)), PredictionClock::initialLead(seconds(2)));
  EXPECT_EQ(dialogue_.welcome(), welcome);
}

TEST_F(DialogueTest, ASecondWelcomeEndsTheSession) {
  dialogue_.begin({3, 1, 17, 4, kTicksPerSecond, "Test"}, seconds(2));
  EXPECT_EQ(dialogue_.begin({4, 1, 17, 4, kTicksPerSecond, "Test"}, seconds(2)), std::nullopt);
  ASSERT_TRUE(dialogue_.ending());
  EXPECT_EQ(dialogue_.ending()->reason, "protocol error: second Welcome from the server");
  EXPECT_TRUE(dialogue_.ending()->permanent);
  EXPECT_EQ(dialogue_.welcome()->slot, 3u);
}

TEST_F(DialogueTest, AMessageIsDecodedAndItsTimeNoted) {
  const std::optional<ToClient> message = dialogue_.receive(encode(Notice{"a"}), seconds(4));
  ASSERT_TRUE(message);
  EXPECT_EQ(*message, ToClient(Notice{"a"}));
  EXPECT_EQ(dialogue_.receivedAt(), seconds(4));
}

TEST_F(DialogueTest, AMalformedMessageEndsTheSession) {
  const std::vector<std::uint8_t> malformed = {1, 2, 3, 4};
  EXPECT_FALSE(dialogue_.receive(malformed, seconds(1)));
  ASSERT_TRUE(dialogue_.ending());
  EXPECT_EQ(dialogue_.ending()->reason, "protocol error: malformed message from the server");
  EXPECT_TRUE(dialogue_.ending()->permanent);
}

TEST_F(DialogueTest, ARefusalTellsItsReason) {
  dialogue_.end(Refused{RefusalCode::kFull, "server is full"});
  ASSERT_TRUE(dialogue_.ending());
  EXPECT_EQ(dialogue_.ending()->reason, "the server refused this client: server is full");
  EXPECT_FALSE(dialogue_.ending()->permanent);
}

TEST_F(DialogueTest, WithoutAVisibleReasonTheSentenceEndsBeforeIt) {
  dialogue_.end(Refused{RefusalCode::kWrongRules, "\u3164"});
  ASSERT_TRUE(dialogue_.ending());
  EXPECT_EQ(dialogue_.ending()->reason, "the server refused this client");
  EXPECT_TRUE(dialogue_.ending()->permanent);
}

TEST_F(DialogueTest, ReconnectsToAServerThatStopsButNotToOneThatRemovesThePlayer) {
  for (const ByeCode code : {ByeCode::kServerStops, ByeCode::kRemoved, ByeCode::kOther}) {
    dialogue_.end(Bye{code, "why"});
    ASSERT_TRUE(dialogue_.ending());
    EXPECT_EQ(dialogue_.ending()->reason, "the server ended the game: why");
    EXPECT_EQ(dialogue_.ending()->permanent, code != ByeCode::kServerStops);
  }
}

// The player decides whether to go there.
TEST_F(DialogueTest, AServerThatNamesAnotherOneIsNotAskedAgain) {
  dialogue_.end(Bye{ByeCode::kServerStops, "why", "example.org:7777"});
  EXPECT_TRUE(dialogue_.ending()->permanent);
  EXPECT_EQ(dialogue_.ending()->next, "example.org:7777");
  dialogue_.end(Refused{RefusalCode::kFull, "why", "example.org:7778"});
  EXPECT_TRUE(dialogue_.ending()->permanent);
  EXPECT_EQ(dialogue_.ending()->next, "example.org:7778");
}

TEST_F(DialogueTest, IgnoresAnotherServerThatIsNoAddress) {
  dialogue_.end(Bye{ByeCode::kServerStops, "why", "no address"});
  EXPECT_FALSE(dialogue_.ending()->permanent);
  EXPECT_EQ(dialogue_.ending()->next, "");
}

TEST_F(DialogueTest, NumbersInputsAndMeasuresTheRoundTripByTheirNumbers) {
  EXPECT_EQ(sent<Hello>().size(), 1u);
  for (int i = 0; i < 2; ++i) dialogue_.sendInputs(PlayerInputs{}, milliseconds(2000 + 10 * i));
  const std::vector<PlayerInputs> inputs = sent<PlayerInputs>();
  ASSERT_EQ(inputs.size(), 2u);
  EXPECT_EQ(inputs[1].sequence, inputs[0].sequence + 1);
  ConfirmedTicks ticks;
  ticks.link = LinkReport{inputs[1].sequence, 0, {}};
  dialogue_.measure(ticks, milliseconds(2050));
  EXPECT_DOUBLE_EQ(dialogue_.linkStatistics(nullptr).rttMs, 40);
}

}  // namespace
}  // namespace platon::dialogue_test
