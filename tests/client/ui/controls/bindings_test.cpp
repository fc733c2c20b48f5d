#include "client/ui/controls/bindings.h"

#include <optional>
#include <set>
#include <string_view>

#include <gtest/gtest.h>

#include "tests/client/ui/controls/random_bindings.h"

namespace platon::bindings_test {
namespace {

TEST(Control, EachHasAWordAndANameOfItsOwn) {
  std::set<std::string_view> names;
  for (std::size_t i = 0; i < kControlCount; ++i) {
    const auto control = static_cast<Control>(i);
    EXPECT_EQ(controlNamed(wordOf(control)), control);
    EXPECT_TRUE(names.insert(nameOf(control)).second) << nameOf(control);
  }
  EXPECT_FALSE(controlNamed("fly"));
  EXPECT_FALSE(controlNamed(""));
}

// How many places of all controls have the key.
int places(const Bindings& bindings, Key key) {
  int count = 0;
  for (std::size_t i = 0; i < kControlCount; ++i) {
    const ControlKeys& keys = bindings.keysOf(static_cast<Control>(i));
    count += (keys.first == key ? 1 : 0) + (keys.second == key ? 1 : 0) + (keys.pad == key ? 1 : 0);
  }
  return count;
}

void expectSound(const Bindings& bindings) {
  for (std::size_t i = 0; i < kKeyCount; ++i) {
    const auto key = static_cast<Key>(i);
    const int count = places(bindings, key);
    EXPECT_LE(count, canBeBound(key) ? 1 : 0) << shownNameOf(key);
    EXPECT_EQ(bindings.controlOf(key).has_value(), count == 1);
  }
  for (std::size_t i = 0; i < kControlCount; ++i) {
    const ControlKeys& keys = bindings.keysOf(static_cast<Control>(i));
    EXPECT_TRUE(keys.first || !keys.second);
    EXPECT_TRUE(!keys.pad || isOfGamepad(*keys.pad));
    EXPECT_FALSE(keys.first && isOfGamepad(*keys.first));
  }
}

TEST(Bindings, WhoPlaysWithAGamepadCanTalk) {
  EXPECT_EQ(Bindings().keysOf(Control::kSay), (ControlKeys{Key::kT, std::nullopt, Key::kPadX}));
}

TEST(Bindings, EachKeyHasAtMostOneControlWhateverThePlayerChooses) {
  std::mt19937_64 random(1);
  Bindings bindings;
  expectSound(bindings);
  for (int i = 0; i < 500; ++i) {
    change(bindings, random, 1);
    expectSound(bindings);
  }
}

TEST(Bindings, TheNewKeyIsTheFirstAndTheOldOneTheSecond) {
  Bindings bindings;
  EXPECT_EQ(bindings.bind(Control::kJump, Key::kJ), std::nullopt);
  EXPECT_EQ(bindings.keysOf(Control::kJump), (ControlKeys{Key::kJ, Key::kSpace, Key::kPadA}));
  bindings.bind(Control::kJump, Key::kK);
  EXPECT_EQ(bindings.keysOf(Control::kJump), (ControlKeys{Key::kK, Key::kJ, Key::kPadA}));
  EXPECT_EQ(bindings.controlOf(Key::kSpace), std::nullopt);
  EXPECT_EQ(bindings.bind(Control::kJump, Key::kJ), std::nullopt);
  EXPECT_EQ(bindings.keysOf(Control::kJump), (ControlKeys{Key::kJ, Key::kK, Key::kPadA})) << "its own second key";
  bindings.bind(Control::kJump, Key::kPadX);
  EXPECT_EQ(bindings.keysOf(Control::kJump), (ControlKeys{Key::kJ, Key::kK, Key::kPadX}));
}

TEST(Bindings, AKeyThatIsTakenIsTakenOver) {
  Bindings bindings;
  EXPECT_EQ(bindings.bind(Control::kJump, Key::kA), Control::kLeft);
  EXPECT_EQ(bindings.controlOf(Key::kA), Control::kJump);
  EXPECT_EQ(bindings.keysOf(Control::kLeft), (ControlKeys{Key::kArrowLeft, {}, Key::kPadLeft}));
  EXPECT_EQ(bindings.bind(Control::kJump, Key::kPadLeft), Control::kLeft);
  EXPECT_EQ(bindings.keysOf(Control::kLeft), (ControlKeys{Key::kArrowLeft, {}, {}}));
}

TEST(Bindings, AClearedControlHasNoKey) {
  Bindings bindings;
  bindings.clear(Control::kJump);
  EXPECT_EQ(bindings.keysOf(Control::kJump), ControlKeys());
  EXPECT_NE(bindings, Bindings());
  EXPECT_FALSE(bindings.isAny(Control::kJump, std::bitset<kKeyCount>().set()));
}

}  // namespace
}  // namespace platon::bindings_test
