#include "client/ui/controls/bindings_text.h"

#include <algorithm>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "client/ui/settings.h"
#include "tests/client/ui/controls/random_bindings.h"

namespace platon::bindings_text_test {
namespace {

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
}  // namespace platon::bindings_text_test
