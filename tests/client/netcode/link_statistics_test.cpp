#include "client/netcode/link_statistics.h"

#include <gtest/gtest.h>

namespace platon::link_statistics_test {
namespace {

using std::chrono::milliseconds;

ConfirmedTicks confirmed(std::uint32_t from, LinkReport report) {
  ConfirmedTicks message;
  message.from = from;
  message.count = 1;
  message.link = report;
  return message;
}

TEST(LinkStatistics, ConvertsToDisplayUnits) {
  LinkMeter meter;
  PredictionClock clock(6);
  const std::uint8_t sequence = meter.nextSequence(milliseconds(100));
  clock.receive(confirmed(9, {sequence, 3, std::nullopt}), milliseconds(100));
  for (int ms = 110; ms <= 1000; ms += 10) {
    const auto next = static_cast<std::uint32_t>(clock.tick());
    clock.update(milliseconds(ms), next);
    if (clock.reaches(next)) clock.inputChosen(next);
  }
  // Two samples of the required lead, six ticks apart: 100 ms.
  clock.receive(confirmed(40, {sequence, 3, SlackReport{30, 8}}), milliseconds(1000));
  clock.receive(confirmed(41, {sequence, 3, SlackReport{31, 2}}), milliseconds(1000));
  meter.receive(confirmed(41, {sequence, 3, SlackReport{31, 2}}), milliseconds(180));
  const LinkStatistics statistics = makeLinkStatistics(meter, &clock);
  EXPECT_DOUBLE_EQ(statistics.rttMs, 80);
  EXPECT_NEAR(statistics.jitterMs, 100, 1e-6);
  EXPECT_EQ(statistics.slackTicks, 2);
  EXPECT_EQ(statistics.lostUpPercent, 3);
  EXPECT_EQ(statistics.lostDownPercent, 0);
}

TEST(LinkStatistics, WithoutAClockHasOnlyTheValuesOfTheMeter) {
  LinkMeter meter;
  meter.receive(confirmed(0, {meter.nextSequence(milliseconds(1)), 7, SlackReport{0, 4}}), milliseconds(21));
  const LinkStatistics statistics = makeLinkStatistics(meter, nullptr);
  EXPECT_DOUBLE_EQ(statistics.rttMs, 20);
  EXPECT_EQ(statistics.lostUpPercent, 7);
  EXPECT_EQ(statistics.jitterMs, 0);
  EXPECT_EQ(statistics.slackTicks, 0);
}

}  // namespace
}  // namespace platon::link_statistics_test
