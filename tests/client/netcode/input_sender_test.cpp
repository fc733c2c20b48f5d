#include "client/netcode/input_sender.h"

#include <gtest/gtest.h>

#include <vector>

namespace platon::input_sender_test {
namespace {

using std::chrono::milliseconds;

constexpr std::uint32_t kRound = 7;

Input pressing(std::uint32_t tick) { return {static_cast<std::uint8_t>(Input::kPresent | tick % 8)}; }

void addTicks(InputSender& sender, std::uint32_t from, std::uint32_t to) {
  for (std::uint32_t tick = from; tick < to; ++tick) sender.add(tick, {pressing(tick)});
}

TEST(InputSender, ReportsTheConfirmedStateBeforeTheFirstInput) {
  InputSender sender(kRound);
  const auto message = sender.takeMessage(milliseconds(0), {5, 0xabcd, 3});
  ASSERT_TRUE(message.has_value());
  EXPECT_EQ(*message, (PlayerInputs{kRound, 3, 5, 0xabcd, 5, {}}));
  EXPECT_FALSE(sender.takeMessage(milliseconds(79), {5, 0xabcd, 3}).has_value());
  EXPECT_TRUE(sender.takeMessage(milliseconds(80), {5, 0xabcd, 3}).has_value());
}

TEST(InputSender, SendsAllUnconfirmedInputsInOrder) {
  InputSender sender(kRound);
  addTicks(sender, 20, 30);
  const auto first = sender.takeMessage(milliseconds(0), {12, 0, 0});
  ASSERT_TRUE(first.has_value());
  EXPECT_EQ(first->first, 20u);  // the local player is absent before
  ASSERT_EQ(first->inputs.size(), 10u);
  for (std::uint32_t i = 0; i < 10; ++i) EXPECT_EQ(first->inputs[i], pressing(20 + i));
  addTicks(sender, 30, 31);
  const auto second = sender.takeMessage(milliseconds(16), {26, 0, 0});
  ASSERT_TRUE(second.has_value());
  EXPECT_EQ(second->first, 26u);
  ASSERT_EQ(second->inputs.size(), 5u);
  EXPECT_EQ(second->inputs.back(), pressing(30));
}

TEST(InputSender, SendsNoInputsWhenAllAreConfirmed) {
  InputSender sender(kRound);
  addTicks(sender, 0, 10);
  const auto message = sender.takeMessage(milliseconds(0), {40, 0, 0});
  ASSERT_TRUE(message.has_value());
  EXPECT_EQ(message->first, 40u);
  EXPECT_TRUE(message->inputs.empty());
}

// Only a faulty server sends a full state of an earlier tick than the last one.
TEST(InputSender, NeverSendsMoreInputsThanAMessageHolds) {
  InputSender sender(kRound);
  addTicks(sender, 0, 1000);
  const auto message = sender.takeMessage(milliseconds(0), {100, 0, 0});
  ASSERT_TRUE(message.has_value());
  EXPECT_EQ(message->inputs.size(), kMaxInputsPerMessage);
}

TEST(InputSender, AcceptsTicksUpToTheLargest) {
  InputSender sender(kRound);
  addTicks(sender, UINT32_MAX - 3, UINT32_MAX);
  const auto message = sender.takeMessage(milliseconds(0), {UINT32_MAX - 2, 0, 0});
  ASSERT_TRUE(message.has_value());
  EXPECT_EQ(message->first, UINT32_MAX - 2);
  EXPECT_EQ(message->inputs.size(), 2u);
  EXPECT_EQ(decodeToServer(encode(*message)), ToServer(*message));
}

TEST(InputSender, SendsTheInputsOfACompanionFromItsFirstTickOn) {
  InputSender sender(kRound);
  addTicks(sender, 20, 23);
  for (std::uint32_t tick = 23; tick < 26; ++tick) sender.add(tick, {pressing(tick), {}, pressing(tick + 1)});
  const auto first = sender.takeMessage(milliseconds(0), {12, 0, 0});
  ASSERT_TRUE(first.has_value());
  EXPECT_EQ(first->inputs.size(), 6U);
  EXPECT_EQ(first->companions, (std::vector<CompanionInputs>{{2, 23, {pressing(24), pressing(25), pressing(26)}}}));
  sender.sendSoon();
  const auto confirmed = sender.takeMessage(milliseconds(1), {25, 0, 0});
  EXPECT_EQ(confirmed->companions, (std::vector<CompanionInputs>{{2, 25, {pressing(26)}}}));
  sender.sendSoon();
  EXPECT_TRUE(sender.takeMessage(milliseconds(2), {26, 0, 0})->companions.empty());
}

TEST(InputSender, WhoHasLeftSendsNothingAndBeginsAnewWhenItReturns) {
  InputSender sender(kRound);
  for (std::uint32_t tick = 0; tick < 4; ++tick) sender.add(tick, {pressing(tick), pressing(1)});
  addTicks(sender, 4, 6);
  EXPECT_TRUE(sender.takeMessage(milliseconds(0), {0, 0, 0})->companions.empty());
  sender.add(6, {pressing(6), pressing(2)});
  const auto message = sender.takeMessage(milliseconds(16), {0, 0, 0});
  ASSERT_TRUE(message.has_value());
  EXPECT_EQ(message->companions, (std::vector<CompanionInputs>{{1, 6, {pressing(2)}}}));
}

// Who leaves and comes back between two ticks sent what the one before had pressed.
TEST(InputSender, WhoTakesOverALocalNumberSendsNothingOfTheOneBefore) {
  InputSender sender(kRound);
  for (std::uint32_t tick = 0; tick < 4; ++tick) sender.add(tick, {pressing(tick), pressing(1)});
  sender.forget(1);
  sender.add(4, {pressing(4), pressing(2)});
  const auto message = sender.takeMessage(milliseconds(0), {0, 0, 0});
  ASSERT_TRUE(message.has_value());
  EXPECT_EQ(message->inputs.size(), 5U);
  EXPECT_EQ(message->companions, (std::vector<CompanionInputs>{{1, 4, {pressing(2)}}}));
}

TEST(InputSender, TheLongestMessageOfAllPlayersIsWithinTheLargestSize) {
  InputSender sender(kRound);
  for (std::uint32_t tick = 0; tick < 1000; ++tick) {
    InputsByLocal inputs;
    inputs.fill(pressing(tick % 2));
    sender.add(tick, inputs);
  }
  const auto message = sender.takeMessage(milliseconds(0), {700, 0, 0});
  ASSERT_TRUE(message.has_value());
  EXPECT_EQ(message->companions.size(), kMaxLocalPlayers - 1);
  EXPECT_EQ(message->companions.back().inputs.size(), kMaxInputsPerMessage);
  EXPECT_LE(encode(*message).size(), kMaxMessageBytes);
  EXPECT_EQ(decodeToServer(encode(*message)), ToServer(*message));
}

TEST(InputSender, SendSoonSendsWithoutANewInput) {
  InputSender sender(kRound);
  sender.takeMessage(milliseconds(0), {});
  EXPECT_FALSE(sender.takeMessage(milliseconds(1), {}).has_value());
  sender.sendSoon();
  EXPECT_TRUE(sender.takeMessage(milliseconds(1), {}).has_value());
  EXPECT_FALSE(sender.takeMessage(milliseconds(1), {}).has_value());
}

constexpr Input kLeft{Input::kPresent | Input::kLeft};
constexpr Input kRight{Input::kPresent | Input::kRight};

class SendScheduleTest : public testing::Test {
 protected:
  // Adds one input per tick. Returns the ticks at which a message was sent.
  std::vector<std::uint32_t> play(const std::vector<Input>& inputs) {
    std::vector<std::uint32_t> sent;
    for (const Input input : inputs) {
      schedule_.addInputs({input});
      ++ticks_;
      if (!due()) continue;
      sent.push_back(ticks_);
      schedule_.sent(now(), ticks_);
    }
    return sent;
  }

  Time now() const { return milliseconds(ticks_ * 16); }
  bool due() const { return schedule_.due(now(), ticks_); }

  SendSchedule schedule_;
  std::uint32_t ticks_ = 0;
};

TEST_F(SendScheduleTest, SendsAChangeAtOnceAndTwiceMoreElseEveryFourthTick) {
  const std::vector<Input> inputs(20, kLeft);
  EXPECT_EQ(play(inputs), (std::vector<std::uint32_t>{1, 2, 3, 7, 11, 15, 19}));
  EXPECT_EQ(play({kRight, kRight, kRight, kRight, kRight, kRight, kRight}),
            (std::vector<std::uint32_t>{21, 22, 23, 27}));
}

TEST_F(SendScheduleTest, SendsEvery80MillisecondsWithoutInputs) {
  EXPECT_TRUE(schedule_.due(milliseconds(5), 0));
  schedule_.sent(milliseconds(5), 0);
  EXPECT_FALSE(schedule_.due(milliseconds(84), 0));
  EXPECT_TRUE(schedule_.due(milliseconds(85), 0));
}

TEST_F(SendScheduleTest, RepeatsOnlyWithANewInput) {
  play({kLeft});
  EXPECT_FALSE(due());  // although two repetitions remain
  schedule_.addInputs({kLeft});
  EXPECT_FALSE(due());  // for a tick that has been sent
  ++ticks_;
  EXPECT_TRUE(due());
}

TEST_F(SendScheduleTest, SendSoonMakesOneMessageDue) {
  play({kLeft});
  schedule_.sendSoon();
  EXPECT_TRUE(due());
  schedule_.sent(now(), ticks_);
  EXPECT_FALSE(due());
}

}  // namespace
}  // namespace platon::input_sender_test
