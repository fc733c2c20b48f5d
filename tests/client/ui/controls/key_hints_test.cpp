#include "client/ui/controls/key_hints.h"

#include <gtest/gtest.h>

namespace platon::key_hints_test {
namespace {

TEST(KeyHints, NameTheFirstKeyAndWithAGamepadItsButton) {
  EXPECT_EQ(KeyHints().of(Control::kJump), "Space");
  EXPECT_EQ(KeyHints({}, true).of(Control::kJump), "pad A");
  EXPECT_EQ(KeyHints({}, true).of(Control::kLook), "Tab") << "it has no button";
  EXPECT_EQ(KeyHints().to(Control::kRestart, "back"), "R: back");
}

TEST(KeyHints, NameTheKeyOfTheMenuAndWithAGamepadItsButton) {
  EXPECT_EQ(KeyHints().menu(), "Esc");
  EXPECT_EQ(KeyHints({}, true).menu(), "Start");
}

TEST(KeyHints, NameTheKeysThatThePlayerHasChosen) {
  Bindings bindings;
  bindings.bind(Control::kJump, Key::kJ);
  EXPECT_EQ(KeyHints(bindings).of(Control::kJump), "J");
  EXPECT_EQ(KeyHints(bindings).keys(Control::kJump), "J or Space");
  bindings.clear(Control::kJump);
  EXPECT_EQ(KeyHints(bindings).of(Control::kJump), "no key");
  EXPECT_EQ(KeyHints(bindings).keys(Control::kJump), "");
  bindings.bind(Control::kJump, Key::kPadX);
  EXPECT_EQ(KeyHints(bindings).of(Control::kJump), "pad X");
  EXPECT_EQ(KeyHints(bindings).pad(Control::kJump), "pad X");
}

TEST(KeyHints, EnterGoesOnAndWithAGamepadTheButtonOfTheVote) {
  EXPECT_EQ(KeyHints().goOn(), "Enter");
  Bindings jumpsByEnter;
  jumpsByEnter.bind(Control::kJump, Key::kEnter);
  EXPECT_EQ(KeyHints(jumpsByEnter).goOn(), "V");
  EXPECT_EQ(KeyHints({}, true).goOn(), "pad Y");
}

TEST(KeyHints, NameTheKeysOfBothSides) {
  EXPECT_EQ(KeyHints().run(), "← → or A D");
  EXPECT_EQ(KeyHints({}, true).run(), "stick ← stick →");
  Bindings bindings;
  bindings.bind(Control::kVote, Key::kA);
  EXPECT_EQ(KeyHints(bindings).run(), "← →") << "one side alone has a second key";
  bindings.clear(Control::kLeft);
  EXPECT_EQ(KeyHints(bindings).run(), "no key →");
}

}  // namespace
}  // namespace platon::key_hints_test
