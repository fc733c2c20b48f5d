#include "client/ui/setting_table.h"

#include <set>
#include <string>
#include <tuple>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/files.h"
#include "tests/support/members.h"

namespace platon::setting_table_test {
namespace {

PLATON_MEMBERS(Settings, views, comfort, controls, bindings, secondKeys, toggled, zoom, uiScale, quality, fullscreen,
               vsync, frameCap, gameSpeed, netGraph, chat, firstKeys, firstDown, firstLook, untold, name, volume,
               effectsVolume, musicVolume, timer, ghosts, ball, second, third, fourth, flashes, highContrast,
               faceNumbers, listUrl)
PLATON_MEMBERS(CameraComfort, turnRate, instantCut, reducedMotion, view)
PLATON_MEMBERS(ToggledControls, slow, look)
PLATON_MEMBERS(QualityChoice, level, scale, samples)
PLATON_MEMBERS(BallChoice, colour, pattern)
PLATON_MEMBERS(CompanionChoice, name, ball)

// The values of a struct whose members have names above, and of the structs in it; another value as it is.
template <class Value>
auto valuesOf(const Value& value) {
  if constexpr (requires { membersOf(value); }) {
    return std::apply([](const auto&... members) { return std::tuple_cat(valuesOf(members)...); }, membersOf(value));
  } else {
    return std::make_tuple(value);
  }
}
using Values = decltype(valuesOf(Settings()));

// The indices of the values that differ from the default.
std::set<std::size_t> changedIn(const Settings& settings) {
  return differing(valuesOf(settings), valuesOf(Settings()));
}

// The settings after one line, which gives this setting a value that is not its default.
Settings changed(const std::string& name) {
  for (const char* value : {"on", "off", "0.75", "75", "12", "2", "screen", "face", "low", "blue", "stripes", "door",
                            "https://example.org/list", "jump j", "each"}) {
    const SettingsResult result = parseSettings(name + " " + value);
    if (result.errors.empty() && !changedIn(result.settings).empty()) return result.settings;
  }
  ADD_FAILURE() << name << " takes none of the values of this test: add one";
  return {};
}

std::vector<std::string> namesInFile() {
  std::vector<std::string> names{"key", "key2"};  // of the bindings
  for (const Setting& setting : settingTable()) names.emplace_back(setting.name);
  return names;
}

TEST(SettingTable, EachMemberHasASettingAndEachSettingAMember) {
  std::set<std::size_t> all;
  for (const std::string& name : namesInFile()) {
    const std::set<std::size_t> members = changedIn(changed(name));
    EXPECT_EQ(members.size(), 1U) << name;
    for (const std::size_t member : members) {
      EXPECT_TRUE(all.insert(member).second)
          << name << " changes what another setting changes: a struct of both needs PLATON_MEMBERS";
    }
  }
  EXPECT_EQ(all.size(), std::tuple_size_v<Values>) << "a member of Settings has no setting in the table";
}

TEST(SettingTable, WhatIsWrittenIsReadAsEqual) {
  for (const std::string& name : namesInFile()) {
    const Settings settings = changed(name);
    const SettingsResult again = parseSettings(settings.text());
    EXPECT_EQ(again.errors, std::vector<std::string>()) << name;
    EXPECT_TRUE(valuesOf(again.settings) == valuesOf(settings)) << settings.text();
  }
}

TEST(SettingTable, EachWordIsReadAsItIsWritten) {
  for (const Setting& setting : settingTable()) {
    const auto* const words = std::get_if<SettingWords>(&setting.value);
    if (!words) continue;
    for (std::size_t i = 0; i < words->words.size(); ++i) {
      Settings settings;
      const std::string word(words->words[i].word);
      EXPECT_TRUE(readSetting(setting, word, settings)) << word;
      EXPECT_EQ(words->index(settings), i) << word;
      EXPECT_NE(settings.text().find(std::string(setting.name) + " " + word + "\n"), std::string::npos) << word;
    }
  }
}

TEST(SettingTable, OtherWordsChangeNothingAndAreReported) {
  Settings settings;
  settings.ball.colour = 2;
  for (const Setting& setting : settingTable()) {
    EXPECT_FALSE(readSetting(setting, "", settings)) << setting.name;
    if (setting.name.starts_with("name")) continue;  // any word may be one
    for (const char* word : {"Orange", "7x", "On", "nan"}) {
      EXPECT_FALSE(readSetting(setting, word, settings)) << setting.name;
    }
  }
  EXPECT_EQ(changedIn(settings).size(), 1U);
  EXPECT_EQ(settings.ball.colour, 2U);
  EXPECT_EQ(parseSettings("ball-colour red").errors.front(),
            "line 1: ball-colour must be auto, orange, blue, green, rose, cream");
  EXPECT_EQ(parseSettings("ball-pattern red").errors.front(),
            "line 1: ball-pattern must be auto, spots, stripes, belt, cross, dots, halves, checks, plain");
  EXPECT_EQ(parseSettings("quality best").errors.front(), "line 1: quality must be auto, low, medium, high or all");
}

TEST(SettingTable, NamesAndLabelsAreUnique) {
  std::set<std::string_view> names;
  std::set<std::string_view> labels;
  for (const Setting& setting : settingTable()) {
    EXPECT_TRUE(names.insert(setting.name).second) << setting.name;
    const bool hidden = setting.group == SettingGroup::kHidden;
    EXPECT_TRUE(hidden || labels.insert(setting.label).second) << setting.label;
  }
}

TEST(SettingTable, ThePageForPlayersHasEachSetting) {
  const std::string page = readText("docs/playing.md");
  for (const Setting& setting : settingTable()) {
    const std::string label(setting.group == SettingGroup::kHidden ? "–" : setting.label);
    const std::string row =
        "\n| " + label + " | `" + std::string(setting.name) + "`: " + allowedValues(setting) + " | ";
    EXPECT_NE(page.find(row), std::string::npos) << "add to the table of docs/playing.md#comfort:" << row;
  }
}

}  // namespace
}  // namespace platon::setting_table_test
