#include "client/ui/setting_table.h"

#include <set>
#include <string>
#include <tuple>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/files.h"

namespace platon::setting_table_test {
namespace {

// Every value of the settings. Does not compile while one has no name here.
auto membersOf(const Settings& settings) {
  const auto& [comfort, controls, bindings, toggled, zoom, uiScale, quality, fullscreen, vsync, frameCap, gameSpeed,
               netGraph, chat, firstKeys, untold, volume, effectsVolume, musicVolume, timer, ghosts, ball, flashes,
               highContrast, faceNumbers, listUrl] = settings;
  const auto& [turnRate, instantCut, reducedMotion, view] = comfort;
  const auto& [slow, look] = toggled;
  const auto& [level, scale, samples] = quality;
  const auto& [colour, pattern] = ball;
  return std::make_tuple(turnRate, instantCut, reducedMotion, view, controls, bindings, slow, look, zoom, uiScale,
                         level, scale, samples, fullscreen, vsync, frameCap, gameSpeed, netGraph, chat, firstKeys,
                         untold, volume, effectsVolume, musicVolume, timer, ghosts, colour, pattern, flashes,
                         highContrast, faceNumbers, listUrl);
}
using Members = decltype(membersOf(Settings()));

// The indices of the members that differ from the default.
std::set<std::size_t> changedIn(const Settings& settings) {
  std::set<std::size_t> changed;
  const Members now = membersOf(settings);
  const Members before = membersOf(Settings());
  const auto compare = [&]<std::size_t... kIndex>(std::index_sequence<kIndex...>) {
    ((std::get<kIndex>(now) == std::get<kIndex>(before) ? void() : void(changed.insert(kIndex))), ...);
  };
  compare(std::make_index_sequence<std::tuple_size_v<Members>>());
  return changed;
}

// The settings after one line, which gives this setting a value that is not its default.
Settings changed(const std::string& name) {
  for (const char* value : {"on", "off", "0.75", "75", "12", "2", "screen", "face", "low", "blue", "stripes", "door",
                            "https://example.org/list", "jump j"}) {
    const SettingsResult result = parseSettings(name + " " + value);
    if (result.errors.empty() && !changedIn(result.settings).empty()) return result.settings;
  }
  ADD_FAILURE() << name << " takes none of the values of this test: add one";
  return {};
}

std::vector<std::string> namesInFile() {
  std::vector<std::string> names{"key"};  // of the bindings
  for (const Setting& setting : settingTable()) names.emplace_back(setting.name);
  return names;
}

TEST(SettingTable, EachMemberHasASettingAndEachSettingAMember) {
  std::set<std::size_t> all;
  for (const std::string& name : namesInFile()) {
    const std::set<std::size_t> members = changedIn(changed(name));
    EXPECT_EQ(members.size(), 1U) << name;
    for (const std::size_t member : members) {
      EXPECT_TRUE(all.insert(member).second) << name << " changes what another setting changes";
    }
  }
  EXPECT_EQ(all.size(), std::tuple_size_v<Members>) << "a member of Settings has no setting in the table";
}

TEST(SettingTable, WhatIsWrittenIsReadAsEqual) {
  for (const std::string& name : namesInFile()) {
    const Settings settings = changed(name);
    const SettingsResult again = parseSettings(settings.text());
    EXPECT_EQ(again.errors, std::vector<std::string>()) << name;
    EXPECT_TRUE(membersOf(again.settings) == membersOf(settings)) << settings.text();
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
    for (const char* word : {"", "Orange", "7x", "On", "nan"}) {
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
