#include "client/ui/settings.h"

#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace platon::settings_test {
namespace {

using Lines = std::vector<std::string>;

TEST(Settings, ParsingTheTextGivesTheSameSettings) {
  Settings settings;
  settings.comfort = {.turnRate = 12.5, .instantCut = true, .reducedMotion = true, .view = CameraView::kFaceFade};
  settings.controls = ControlFrame::kScreen;
  settings.zoom = 1.25;
  settings.uiScale = 1.5;
  settings.vsync = false;
  settings.frameCap = 144;
  settings.fullscreen = true;
  settings.quality = {QualityLevel::kAll, 0.75, 2};
  settings.netGraph = true;
  settings.chat = false;
  settings.firstKeys = false;
  settings.untold.mask = 0b0100010;
  settings.volume = 0;
  settings.effectsVolume = 37.5;
  settings.musicVolume = 100;
  settings.timer = false;
  settings.ghosts = false;
  settings.faceNumbers = true;
  settings.flashes = false;
  settings.ball = {.colour = 3, .pattern = BallPattern::kBelt};
  settings.gameSpeed = 75;
  settings.highContrast = true;
  settings.listUrl = "https://example.org/servers.json";
  settings.toggled = {.slow = true, .look = true};
  settings.bindings.bind(Control::kJump, Key::kJ);
  const SettingsResult result = parseSettings(settings.text());
  EXPECT_EQ(result.errors, Lines());
  EXPECT_EQ(result.unknownLines, Lines());
  EXPECT_EQ(result.settings.text(), settings.text());
  EXPECT_NE(result.settings.text(), Settings().text());
  EXPECT_TRUE(Settings().timer && Settings().ghosts);
  EXPECT_FALSE(result.settings.timer || result.settings.ghosts);
}

TEST(Settings, EmptyLinesAndMissingSettingsAreAllowed) {
  const SettingsResult result = parseSettings("\n  \nzoom 2\n");
  EXPECT_EQ(result.errors, Lines());
  EXPECT_EQ(result.settings.zoom, 2);
  EXPECT_EQ(result.settings.comfort.turnRate, Settings().comfort.turnRate);
}

// The terminal obeyed what a damaged file told it.
TEST(Settings, AnErrorIsReadableWhateverTheLine) {
  const std::string longName(41, 'x');
  const SettingsResult result = parseSettings("\x1b[2J on\n\xff\n" + longName + "\n" + longName.substr(1));
  EXPECT_EQ(result.errors, (Lines{"line 1: unknown setting", "line 2: unknown setting", "line 3: unknown setting",
                                  "line 4: unknown setting '" + longName.substr(1) + "'"}));
  EXPECT_EQ(result.unknownLines.size(), 4u);
}

TEST(Settings, EveryBadLineIsReportedAndAffectsNoOther) {
  const SettingsResult result = parseSettings("turn-speed 0\nfullscreen on\ncolour red\nzoom 2 1\nnet-graph on");
  EXPECT_EQ(result.errors, (Lines{"line 1: turn-speed must be a number from 1 to 30",
                                  "line 3: unknown setting 'colour'", "line 4: zoom must be a number from 0.5 to 2"}));
  EXPECT_EQ(result.unknownLines, Lines{"colour red"});
  Settings expected;
  expected.fullscreen = true;
  expected.netGraph = true;
  EXPECT_EQ(result.settings.text(), expected.text());
}

TEST(Settings, BadValuesAreReported) {
  const std::string zoom = "line 1: zoom must be a number from 0.5 to 2";
  for (const char* line : {"zoom nan", "zoom 1e999", "zoom 1x", "zoom", "zoom 1 2", "zoom 0.49", "zoom 2.01"}) {
    EXPECT_EQ(parseSettings(line).errors, Lines{zoom}) << line;
  }
  const std::string range = " must be a number from 0 to 100";
  EXPECT_EQ(parseSettings("volume 101\n").errors, Lines{"line 1: volume" + range});
  EXPECT_EQ(parseSettings("volume-effects -1\n").errors, Lines{"line 1: volume-effects" + range});
  EXPECT_EQ(parseSettings("volume-music off\n").errors, Lines{"line 1: volume-music" + range});
  EXPECT_EQ(parseSettings("controls mine\n").errors, Lines{"line 1: controls must be player or screen"});
  EXPECT_EQ(parseSettings("camera me\n").errors, Lines{"line 1: camera must be follow, face or face-fade"});
  EXPECT_EQ(parseSettings("toggle-slow 1\n").errors, Lines{"line 1: toggle-slow must be on or off"});
  EXPECT_EQ(parseSettings("fullscreen yes\n").errors, Lines{"line 1: fullscreen must be on or off"});
}

TEST(Settings, ANameMayHaveSpacesAndLettersOfAllScripts) {
  for (const std::string& name :
       {std::string("Ann"), std::string("Ann Lee"), std::string("Лев"), std::string(32, 'W')}) {
    Settings settings;
    settings.name = name;
    const SettingsResult result = parseSettings(settings.text());
    EXPECT_EQ(result.errors, Lines());
    EXPECT_EQ(result.settings.name, name);
  }
  EXPECT_EQ(parseSettings("name none").settings.name, "");
  for (const std::string& bad : {std::string("name"), "name " + std::string(33, 'W'), std::string("name a\x1b[31m")}) {
    EXPECT_EQ(parseSettings(bad).errors,
              Lines{"line 1: name must be none, or a text of at most 32 bytes without control characters"});
  }
}

// The name "none" was lost at the next start.
TEST(Settings, WhatAPlayerTypesIsItsNameUnlessTheFileCouldNotKeepIt) {
  std::string name = "Ann";
  const auto typed = [&](std::string_view text) {
    takeName(text, name);
    Settings settings;
    settings.name = name;
    EXPECT_EQ(parseSettings(settings.text()).settings.name, name);
    return name;
  };
  EXPECT_EQ(typed("Ben"), "Ben");
  for (const std::string& bad :
       {std::string("none"), std::string(" none "), std::string(33, 'W'), std::string("a\x1b")})
    EXPECT_EQ(typed(bad), "Ben") << bad;
  EXPECT_EQ(typed("None"), "None");
  EXPECT_EQ(typed("  Ann   Lee "), "Ann Lee");
  EXPECT_EQ(typed(""), "") << "it is taken away";
}

TEST(Settings, AListOfServersIsAUrlOfTheWebOrNone) {
  const std::string longest = "https://" + std::string(kMaxListUrlBytes - 8, 'x');
  for (const std::string& url : {std::string("http://x"), std::string("https://[::1]:8000/a?b=c#d"), longest}) {
    const SettingsResult result = parseSettings("list-url " + url);
    EXPECT_EQ(result.errors, Lines());
    EXPECT_EQ(result.settings.listUrl, url);
    EXPECT_TRUE(isListUrl(url));
  }
  EXPECT_EQ(parseSettings("list-url https://x\nlist-url none").settings.listUrl, "");
  EXPECT_FALSE(isListUrl("none"));
  for (const std::string& bad : {std::string("http://"), std::string("https://"), std::string("file:///etc/passwd"),
                                 std::string("example.org"), std::string("http://\xc3\xa9"), std::string("http://\x7f"),
                                 longest + "x", std::string("http://a b"), std::string()}) {
    EXPECT_EQ(
        parseSettings("list-url " + bad).errors,
        Lines{"line 1: list-url must be none, or a URL that begins with https:// or http://, of at most 512 bytes "
              "and without spaces"})
        << bad;
    EXPECT_FALSE(isListUrl(bad));
  }
}

TEST(Settings, WhoHasSetNothingHearsEverything) {
  const std::string text = Settings().text();
  for (const char* const line : {"volume 80\n", "volume-effects 100\n", "volume-music 70\n"})
    EXPECT_NE(text.find(line), std::string::npos) << line << text;
}

}  // namespace
}  // namespace platon::settings_test
