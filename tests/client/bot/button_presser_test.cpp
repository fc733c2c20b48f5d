#include "client/bot/button_presser.h"

#include <gtest/gtest.h>

#include <set>

#include "platon/game/game.h"

namespace platon::button_presser_test {
namespace {

TEST(ButtonPresser, ChangesThreeToSixTimesASecond) {
  ButtonPresser presser(11);
  Input held = presser.next();
  int since = 1;
  std::set<std::uint8_t> used = {held.buttons};
  for (int tick = 1; tick < 60 * kTicksPerSecond; ++tick) {
    const Input next = presser.next();
    if (next != held) {
      EXPECT_GE(since, kTicksPerSecond / 6);
      since = 0;
    }
    ++since;
    EXPECT_LE(since, kTicksPerSecond / 3);
    held = next;
    used.insert(held.buttons);
  }
  for (const std::uint8_t buttons : used) EXPECT_EQ(buttons & (Input::kPresent | Input::kRestart), 0);
  EXPECT_GE(used.size(), 5u);
}

TEST(ButtonPresser, TheSameSeedGivesTheSameInputs) {
  ButtonPresser a(3), b(3), c(4);
  int different = 0;
  for (int tick = 0; tick < 1000; ++tick) {
    const Input pressed = a.next();
    EXPECT_EQ(pressed, b.next());
    different += pressed != c.next() ? 1 : 0;
  }
  EXPECT_GT(different, 100);
}

}  // namespace
}  // namespace platon::button_presser_test
