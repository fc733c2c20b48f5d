#include <gtest/gtest.h>

#include <cstdio>
#include <memory>
#include <vector>

#include "client/bot/button_presser.h"
#include "tests/net/support/input_flipper.h"
#include "tests/net/support/session_network.h"
#include "tests/support/test_levels.h"

namespace platon::resync_test {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

constexpr std::uint64_t kSeed = 5;
constexpr Time kMaxExtraTime = milliseconds(100);  // in addition to the round trip

Controls pressing(std::uint64_t seed) {
  return [presser = std::make_shared<ButtonPresser>(seed)](const Game&, std::uint32_t) { return presser->next(); };
}

/// Adds players that press buttons for two seconds and then disconnect. They stay in the game and cost no bandwidth.
void addDisconnectedPlayers(SessionNetwork& match, std::uint32_t count) {
  constexpr ClientId kFirst = 1000;
  for (std::uint32_t i = 0; i < count; ++i) {
    Hello hello;
    hello.token = SessionToken{0xff, 0xff, static_cast<std::uint8_t>(i)};
    match.match().receive(kFirst + i, hello);
    PlayerInputs message;
    message.round = match.match().round();
    message.sync = UINT8_MAX;  // unknown to the server
    message.first = match.match().game().tick() + 1;
    ButtonPresser presser(kSeed + i);
    for (int tick = 0; tick < 120; ++tick) {
      message.inputs.push_back(Input{static_cast<std::uint8_t>(presser.next().buttons | Input::kPresent)});
    }
    match.match().receive(kFirst + i, message);
    match.match().disconnect(kFirst + i);
  }
}

class Resync : public testing::TestWithParam<int> {
 protected:
  Resync() {
    LinkQuality quality;
    quality.delayMs = roundTripMs() / 2.0;
    match_.join(quality, pressing(kSeed));
    match_.run(seconds(2));
    addDisconnectedPlayers(match_, kMaxPlayers - 1);
    match_.run(seconds(3));
  }

  static int roundTripMs() { return GetParam(); }

  bool matchesServer() {
    const Prediction& prediction = match_.session(0).round()->prediction();
    return prediction.confirmed().hash() == match_.hashOf(match_.match().round(), prediction.confirmedTicks());
  }

  Time timeToMatch() {
    const Time start = match_.now();
    while (!matchesServer() && match_.now() < start + seconds(5)) match_.run(milliseconds(1));
    return match_.now() - start;
  }

  // Changes an input on the way to the client, and runs until its game differs.
  void desync() {
    const auto flipper = std::make_shared<InputFlipper>();
    flipper->from = match_.match().game().tick();
    flipper->slot = static_cast<std::uint8_t>(match_.slot(0));
    match_.setChecked(0, false);
    match_.tamper(0, [flipper](std::vector<std::uint8_t>& bytes) { (*flipper)(bytes); });
    const Time end = match_.now() + seconds(5);
    while (matchesServer() && match_.now() < end) match_.run(milliseconds(1));
  }

  SessionNetwork match_{{endlessLevel()}, kSeed, kMaxPlayers};
};

// Measures the time from the first differing tick until the confirmed game matches again.
TEST_P(Resync, TakesAtMost100MillisecondsMoreThanARoundTrip) {
  std::uint32_t present = 0;
  for (std::uint32_t slot = 0; slot < kMaxPlayers; ++slot)
    present += match_.match().game().player(slot).present ? 1 : 0;
  ASSERT_EQ(present, kMaxPlayers);
  for (std::uint32_t times = 1; times <= 2; ++times) {
    desync();
    ASSERT_FALSE(matchesServer());
    const Time took = timeToMatch();
    EXPECT_LE(took, milliseconds(roundTripMs()) + kMaxExtraTime);
    std::printf("%zu bytes, after %lld ms\n", match_.match().game().save().size(),
                static_cast<long long>(took / milliseconds(1)));
    match_.setChecked(0, true);
    match_.run(seconds(2));
    EXPECT_EQ(match_.session(0).roundStatistics().desyncs, times);
    EXPECT_EQ(match_.session(0).roundStatistics().resyncs, times);
  }
}

// The state of the largest number of players takes longest.
INSTANTIATE_TEST_SUITE_P(RoundTrips, Resync, testing::Values(20, 100, 400));

}  // namespace
}  // namespace platon::resync_test
