#include "client/netcode/input_clock.h"

#include <gtest/gtest.h>

#include "protocol/limits.h"

namespace platon {
namespace {

using std::chrono::milliseconds;

ConfirmedTicks ticks(std::uint32_t from, std::uint32_t count) {
  ConfirmedTicks message;
  message.from = from;
  message.count = count;
  return message;
}

ConfirmedTicks withSlack(std::uint32_t from, std::uint32_t count, SlackReport slack) {
  ConfirmedTicks message = ticks(from, count);
  message.link = LinkReport{0, 0, slack};
  return message;
}

TEST(InputClock, RunsFromTheFirstMessageThatIsNotCatchingUp) {
  InputClock clock(6);
  EXPECT_FALSE(clock.reaches(0));
  clock.receive(ticks(0, kMaxTicksPerMessage), milliseconds(0));
  EXPECT_FALSE(clock.sync().has_value());
  EXPECT_EQ(clock.lead(), 6);
  clock.receive(ticks(240, 10), milliseconds(0));
  ASSERT_TRUE(clock.sync().has_value());
  EXPECT_EQ(clock.firstInput(), 256u);
  EXPECT_TRUE(clock.reaches(255));
  EXPECT_FALSE(clock.reaches(256));
  clock.update(milliseconds(17), 256);
  EXPECT_TRUE(clock.reaches(256));
}

TEST(InputClock, TheLeadIsOverTheNewestTickHeardOf) {
  InputClock clock(6);
  clock.receive(ticks(0, 10), milliseconds(0));
  clock.update(milliseconds(1000), 16);
  clock.receive(ticks(0, 66), milliseconds(1000));
  EXPECT_EQ(clock.lead(), 6);  // before a report it is not known better
  clock.receive(withSlack(0, 66, {16, 0}), milliseconds(1000));
  EXPECT_NEAR(clock.lead(), 10, 1e-9);
}

// Of five inputs chosen together the server tells of the last; the first had four ticks less.
TEST(InputClock, OfInputsChosenTogetherTheOldestIsJudged) {
  const auto targetAfter = [](std::uint32_t reported) {
    InputClock clock(6);
    clock.receive(ticks(0, 10), milliseconds(0));
    clock.update(milliseconds(100), 16);
    for (std::uint32_t tick = 16; clock.reaches(tick); ++tick) clock.chose(tick);
    clock.receive(withSlack(0, 20, {reported, -3}), milliseconds(100));
    return clock.sync()->error();
  };
  EXPECT_NEAR(targetAfter(20) - targetAfter(16), -4, 1e-6);
}

// After a quarter of a second without an update.
TEST(InputClock, WhatWasChosenAfterAHiccupIsNotJudged) {
  const auto errorAfter = [](int ms) {
    InputClock clock(6);
    clock.receive(ticks(0, 10), milliseconds(0));
    clock.update(milliseconds(ms), 16);
    for (std::uint32_t tick = 16; clock.reaches(tick); ++tick) clock.chose(tick);
    clock.receive(withSlack(0, 20, {16, -9}), milliseconds(ms));
    return clock.sync()->error();
  };
  EXPECT_LT(errorAfter(240), -5);
  EXPECT_EQ(errorAfter(260), 0);
}

// Of several messages before the first report the one that came earliest counts.
TEST(InputClock, AMessageThatCameEarlierSetsItForward) {
  InputClock clock(6);
  clock.receive(ticks(0, 10), milliseconds(0));
  clock.update(milliseconds(100), 16);
  EXPECT_FALSE(clock.reaches(22));
  clock.receive(ticks(10, 9), milliseconds(100));  // three ticks more in the same time
  clock.update(milliseconds(100), 22);
  EXPECT_TRUE(clock.reaches(24));
  EXPECT_FALSE(clock.reaches(25));
}

TEST(InputClock, BeginsWithTheTimeOfTheGreetingAndSevenTicksMore) {
  EXPECT_NEAR(InputClock::firstLead(milliseconds(100)), 13, 1e-9);
}

}  // namespace
}  // namespace platon
