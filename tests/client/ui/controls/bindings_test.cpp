#include "client/ui/controls/bindings.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <set>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "client/ui/settings.h"
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

using Words = std::vector<std::string>;

std::vector<std::string> linesOf(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

TEST(BindingsText, TheDefaultsAreALineForEachControl) {
  const std::vector<std::string> lines = linesOf(textOf(Bindings()));
  ASSERT_EQ(lines.size(), kControlCount);
  EXPECT_EQ(lines[0], "key left arrow-left a pad-left");
  EXPECT_EQ(lines[4], "key jump space pad-a");
}

TEST(BindingsText, TheSecondPlayerHasKeysToMoveItsBall) {
  EXPECT_EQ(linesOf(textOf(Bindings(KeySet::kSecond), KeySet::kSecond)),
            (Words{"key2 left arrow-left", "key2 right arrow-right", "key2 up arrow-up", "key2 down arrow-down",
                   "key2 jump none", "key2 slow period", "key2 restart slash", "key2 wave none", "key2 laugh none",
                   "key2 here none", "key2 thanks none"}));
  const SettingsResult result = parseSettings("key2 jump hello\nkey2 left j k\n");
  EXPECT_EQ(result.errors, Words{"line 1: key2 jump must be none, or up to two keys, such as: arrow-left j"});
  EXPECT_EQ(result.settings.secondKeys.keysOf(Control::kLeft), (ControlKeys{Key::kJ, Key::kK, {}}));
  EXPECT_EQ(result.settings.bindings, Bindings());
  EXPECT_EQ(parseSettings(result.settings.text()).settings.secondKeys, result.settings.secondKeys);
}

TEST(BindingsText, LinesThatTheSecondPlayerCannotHaveAreReported) {
  const std::string form = " must be none, or up to two keys, such as: arrow-left j";
  EXPECT_EQ(parseSettings("key2 left pad-a\n").errors, Words{"line 1: key2 left" + form});
  EXPECT_EQ(parseSettings("key2 left\n").errors, Words{"line 1: key2 left" + form});
  EXPECT_EQ(parseSettings("key2 vote j\n").errors,
            Words{"line 1: key2 vote belongs to the first player: remove the line"});
  EXPECT_EQ(parseSettings("key2 left j\nkey2 right j\n").errors,
            Words{"line 2: key2 right must not use j, which left already uses"});
}

TEST(Bindings, WithoutThoseOfAnotherPlayerKeepsTheRest) {
  const Bindings rest = Bindings().without(Bindings(KeySet::kSecond));
  EXPECT_EQ(rest.keysOf(Control::kLeft), (ControlKeys{Key::kA, {}, Key::kPadLeft}));
  EXPECT_EQ(rest.keysOf(Control::kJump), Bindings().keysOf(Control::kJump));
  EXPECT_EQ(rest.controlOf(Key::kArrowUp), std::nullopt);
}

TEST(BindingsText, AnyBindingsAreReadAsTheyWereWrittenInAnyOrder) {
  std::mt19937_64 random(2);
  for (int i = 0; i < 200; ++i) {
    Bindings bindings;
    change(bindings, random, 40);
    std::vector<std::string> lines = linesOf(textOf(bindings));
    std::shuffle(lines.begin(), lines.end(), random);
    std::string text;
    for (const std::string& line : lines) text += line + "\n";
    const SettingsResult result = parseSettings(text);
    EXPECT_TRUE(result.errors.empty()) << text;
    EXPECT_EQ(result.settings.bindings, bindings) << text;
  }
}

TEST(BindingsText, EachKeyIsReadAsItWasWritten) {
  for (std::size_t i = 0; i < kKeyCount; ++i) {
    const auto key = static_cast<Key>(i);
    if (!canBeBound(key)) continue;
    Bindings bindings;
    bindings.bind(Control::kVote, key);
    EXPECT_EQ(parseSettings(textOf(bindings)).settings.bindings, bindings) << wordOf(key);
  }
}

TEST(BindingsText, ALineTakesKeysOverFromControlsThatHaveNoLine) {
  const SettingsResult result = parseSettings("key vote space\n");
  EXPECT_TRUE(result.errors.empty());
  EXPECT_EQ(result.settings.bindings.keysOf(Control::kVote), (ControlKeys{Key::kSpace, {}, {}}));
  EXPECT_EQ(result.settings.bindings.keysOf(Control::kJump), (ControlKeys{{}, {}, Key::kPadA}));
}

TEST(BindingsText, BadLinesAreReportedAndLeaveTheKeysAsTheyWere) {
  const std::string form = " must be none, or up to two keys and a button of the gamepad, such as: space j pad-a";
  for (const char* words :
       {"", "hello", "space space", "a b c", "pad-a pad-b", "none a", "space none", "escape", "esc"}) {
    const SettingsResult result = parseSettings(std::string("key jump ") + words + "\n");
    EXPECT_EQ(result.errors, Words{"line 1: key jump" + form}) << words;
    EXPECT_EQ(result.settings.bindings, Bindings()) << words;
  }
  const SettingsResult twice = parseSettings("key jump x\nkey vote v x\n");
  EXPECT_EQ(twice.errors, Words{"line 2: key vote must not use x, which jump already uses"});
  EXPECT_EQ(twice.settings.bindings.controlOf(Key::kV), Control::kVote);
}

TEST(BindingsText, ControlsOfOtherVersionsAreKept) {
  const SettingsResult result = parseSettings("key fly x\nkey\n");
  EXPECT_EQ(result.errors, (Words{"line 1: unknown setting 'key'", "line 2: unknown setting 'key'"}));
  EXPECT_EQ(result.unknownLines, (Words{"key fly x", "key"}));
  EXPECT_EQ(result.settings.bindings, Bindings());
}

// Random lines of random words, most of which mean something.
std::string randomText(std::mt19937_64& random) {
  std::string text;
  for (std::size_t line = random() % 20; line > 0; --line) {
    text += "key " + std::string(wordOf(randomControl(random)));
    for (std::size_t word = random() % 5; word > 0; --word)
      text += " " + std::string(random() % 9 == 0 ? "none" : wordOf(randomKey(random)));
    if (random() % 9 == 0) text.push_back(static_cast<char>(random() % 256));
    text += "\n";
  }
  return text;
}

TEST(BindingsText, WhateverIsReadIsWrittenAndReadAlike) {
  std::mt19937_64 random(3);
  for (int i = 0; i < 2000; ++i) {
    const std::string text = randomText(random);
    const SettingsResult result = parseSettings(text);
    const SettingsResult again = parseSettings(result.settings.text());
    ASSERT_TRUE(again.errors.empty()) << text;
    ASSERT_EQ(again.settings.bindings, result.settings.bindings) << text;
  }
}

}  // namespace
}  // namespace platon::bindings_test
