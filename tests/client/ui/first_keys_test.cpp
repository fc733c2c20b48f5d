#include "client/ui/first_keys.h"

#include <gtest/gtest.h>

#include "platon/game/game.h"

namespace platon {
namespace {

HeldKeys holding(bool HeldKeys::*key) {
  HeldKeys held;
  held.*key = true;
  return held;
}

void observe(FirstKeys& keys, const HeldKeys& held, std::uint32_t ticks, std::uint32_t face = 0) {
  for (std::uint32_t tick = 0; tick < ticks; ++tick) keys.observe(held, face);
}

TEST(FirstKeys, EachIsShownUntilItWasUsed) {
  FirstKeys keys(false);
  observe(keys, holding(&HeldKeys::jump), 600, 1);
  EXPECT_EQ(keys.hint(KeyHints()), "← → or A D: roll");
  observe(keys, holding(&HeldKeys::right), kTicksPerSecond / 4);
  observe(keys, {}, 10);
  EXPECT_EQ(keys.hint(KeyHints()), "← → or A D: roll");
  observe(keys, holding(&HeldKeys::left), kTicksPerSecond / 4);
  EXPECT_EQ(keys.hint(KeyHints()).substr(0, 5), "Space");
  observe(keys, {}, 600, 1);
  observe(keys, holding(&HeldKeys::jump), 1, 1);
  EXPECT_EQ(keys.hint(KeyHints()).substr(0, 4), "Roll");
  observe(keys, {}, 600, 1);
  EXPECT_FALSE(keys.done());
  observe(keys, {}, 1, 2);
  EXPECT_TRUE(keys.done());
  EXPECT_EQ(keys.hint(KeyHints()), "");
}

TEST(FirstKeys, NameTheKeysThatThePlayerHasChosen) {
  Bindings bindings;
  bindings.bind(Control::kLeft, Key::kJ);
  EXPECT_EQ(FirstKeys(false).hint(KeyHints(bindings)), "J → or ← D: roll");
}

TEST(FirstKeys, WhoKnowsThemSeesNone) {
  FirstKeys keys(true);
  EXPECT_TRUE(keys.done());
  observe(keys, holding(&HeldKeys::right), 60);
  EXPECT_EQ(keys.hint(KeyHints()), "");
}

}  // namespace
}  // namespace platon
