#include "server/match/tick_history.h"

#include <gtest/gtest.h>

#include <random>

namespace platon::tick_history_test {
namespace {

Input pressing(int buttons) { return Input{static_cast<std::uint8_t>(buttons | Input::kPresent)}; }

ConfirmedTicks collect(const TickHistory& history, std::uint32_t confirmed) {
  ConfirmedTicks message{9, 9, 9, 9, LinkReport{}, {{9, 9, pressing(9)}}};  // as an earlier one may have left it
  history.collect(confirmed, message);
  return message;
}

TEST(TickHistory, StartsWithTheHashOfTheNewGame) {
  const TickHistory history(4, 99);
  EXPECT_EQ(history.end(), 0u);
  EXPECT_TRUE(history.covers(0));
  EXPECT_FALSE(history.covers(1));
  EXPECT_EQ(history.hashAfter(0), 99u);
}

TEST(TickHistory, CollectsOnlyChanges) {
  TickHistory history(4, 99);
  history.append(std::vector<Input>{pressing(1), pressing(0)}, 100);
  history.append(std::vector<Input>{pressing(1), pressing(0)}, 101);
  history.append(std::vector<Input>{pressing(2)}, 102);
  const ConfirmedTicks all{
      4, 0, 3, 102, std::nullopt, {{0, 0, pressing(1)}, {0, 1, pressing(0)}, {2, 0, pressing(2)}, {2, 1, Input{}}}};
  EXPECT_EQ(collect(history, 0), all);
  const ConfirmedTicks last{4, 2, 1, 102, std::nullopt, {{2, 0, pressing(2)}, {2, 1, Input{}}}};
  EXPECT_EQ(collect(history, 2), last);
  EXPECT_EQ(history.hashAfter(1), 100u);
  EXPECT_EQ(history.held(), (std::vector<Input>{pressing(2), Input{}}));
}

TEST(TickHistory, KeepsOnlyTheLastTicks) {
  TickHistory history(1, 0);
  for (std::uint32_t tick = 0; tick < TickHistory::kTicks + 5; ++tick) history.append({}, tick + 1);
  EXPECT_FALSE(history.covers(4));
  ASSERT_TRUE(history.covers(5));
  EXPECT_EQ(history.hashAfter(5), 5u);
  EXPECT_EQ(history.hashAfter(6), 6u);
  EXPECT_EQ(history.hashAfter(history.end()), TickHistory::kTicks + 5u);
  EXPECT_EQ(collect(history, 5).count, kMaxTicksPerMessage);
}

// Checked on random inputs. Every message must also be within its limit.
TEST(TickHistory, ConsecutiveMessagesContainEveryInput) {
  constexpr std::uint64_t seed = 11;
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937_64 random(seed);
  TickHistory history(1, 0);
  std::vector<std::vector<Input>> decided;
  for (std::uint32_t tick = 0; tick < 300; ++tick) {
    std::vector<Input> inputs(random() % (kMaxPlayers + 1));
    for (Input& input : inputs) input = random() % 3 == 0 ? Input{} : pressing(static_cast<int>(random() % 32));
    history.append(inputs, tick);
    inputs.resize(kMaxPlayers);
    decided.push_back(inputs);
  }
  std::vector<Input> held(kMaxPlayers);
  for (std::uint32_t tick = 0; tick < history.end();) {
    const ConfirmedTicks message = collect(history, tick);
    ASSERT_GE(message.count, 1u);
    ASSERT_LE(encode(message).size(), kMaxMessageBytes);
    auto change = message.changes.begin();
    for (const std::uint32_t end = tick + message.count; tick < end; ++tick) {
      for (; change != message.changes.end() && change->tick == tick; ++change) held[change->slot] = change->input;
      ASSERT_EQ(held, decided[tick]) << "tick " << tick;
    }
    ASSERT_EQ(message.hash, history.hashAfter(tick));
  }
}

}  // namespace
}  // namespace platon::tick_history_test
