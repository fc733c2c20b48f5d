#include "client/ui/controls/key_names.h"

#include <cstddef>
#include <set>
#include <string>

#include <gtest/gtest.h>

namespace platon::key_names_test {
namespace {

TEST(KeyNames, EachKeyThatCanBeBoundIsFoundByItsWord) {
  std::set<std::string_view> words;
  for (std::size_t i = 0; i < kKeyCount; ++i) {
    const Key key = static_cast<Key>(i);
    EXPECT_FALSE(shownNameOf(key).empty());
    if (!canBeBound(key)) continue;
    EXPECT_TRUE(words.insert(wordOf(key)).second) << wordOf(key);
    EXPECT_EQ(keyNamed(wordOf(key)), key);
    EXPECT_EQ(wordOf(key).starts_with("pad-"), isOfGamepad(key)) << wordOf(key);
    EXPECT_EQ(wordOf(key).find_first_of(" \t"), std::string_view::npos);
    EXPECT_NE(wordOf(key), "none") << "the word for no key";
  }
}

TEST(KeyNames, TheFunctionKeysThatDoNothingElseCanBeBound) {
  EXPECT_EQ(wordOf(Key::kF2), "f2");
  EXPECT_EQ(shownNameOf(Key::kF10), "F10");
  for (int i = static_cast<int>(Key::kF4); i <= static_cast<int>(Key::kF10); ++i)
    EXPECT_TRUE(canBeBound(static_cast<Key>(i))) << shownNameOf(static_cast<Key>(i));
}

TEST(KeyNames, TheKeysOfMenusAndTiltsOfAStickCannotBeBound) {
  for (const Key key : {Key::kEscape, Key::kPadStart, Key::kDelete, Key::kBackspace, Key::kF1, Key::kF3, Key::kF11,
                        Key::kF12, Key::kPadWalk, Key::kPadCreep, Key::kPadLookLeft, Key::kPadLookDown})
    EXPECT_FALSE(canBeBound(key)) << shownNameOf(key);
  EXPECT_FALSE(keyNamed(""));
  EXPECT_FALSE(keyNamed("Space"));
}

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

TEST(KeyHints, NameWhatLooksRound) {
  EXPECT_EQ(KeyHints().look(), "Hold Tab and press arrows");
  EXPECT_EQ(KeyHints({}, true).look(), "right stick");
  Bindings bindings;
  bindings.clear(Control::kLook);
  EXPECT_EQ(KeyHints(bindings).look(), "right mouse button");
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
}  // namespace platon::key_names_test
