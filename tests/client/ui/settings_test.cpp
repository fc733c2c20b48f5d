#include "client/ui/settings.h"

#include <gtest/gtest.h>

namespace platon {
namespace {

TEST(Settings, TextIsReadBackAsItWas) {
  Settings settings;
  settings.comfort = {.turnSpeed = 12.5, .instantCut = true, .reducedMotion = true};
  settings.controls = ControlFrame::kScreen;
  settings.zoom = 1.25;
  settings.fullscreen = true;
  settings.netGraph = true;
  const SettingsResult read = parseSettings(settings.text());
  EXPECT_EQ(read.error, "");
  EXPECT_EQ(read.settings.text(), settings.text());
  EXPECT_NE(read.settings.text(), Settings().text());
}

TEST(Settings, EmptyLinesAndMissingSettingsAreFine) {
  const SettingsResult read = parseSettings("\n  \nzoom 2\n");
  EXPECT_EQ(read.error, "");
  EXPECT_EQ(read.settings.zoom, 2);
  EXPECT_EQ(read.settings.comfort.turnSpeed, Settings().comfort.turnSpeed);
}

TEST(Settings, BadLinesAreNamed) {
  EXPECT_EQ(parseSettings("zoom 1\nturn-speed 0\n").error, "line 2: turn-speed is a number from 1 to 30");
  EXPECT_EQ(parseSettings("zoom nan\n").error, "line 1: zoom is a number from 0.5 to 2");
  EXPECT_EQ(parseSettings("zoom 1e999\n").error, "line 1: zoom is a number from 0.5 to 2");
  EXPECT_EQ(parseSettings("zoom 1x\n").error, "line 1: zoom is a number from 0.5 to 2");
  EXPECT_EQ(parseSettings("zoom\n").error, "line 1: zoom is a number from 0.5 to 2");
  EXPECT_EQ(parseSettings("zoom 1 2\n").error, "line 1: one value is enough");
  EXPECT_EQ(parseSettings("controls mine\n").error, "line 1: controls is player or screen");
  EXPECT_EQ(parseSettings("fullscreen yes\n").error, "line 1: fullscreen is on or off");
  EXPECT_EQ(parseSettings("colour red\n").error, "line 1: there is no setting 'colour'");
}

}  // namespace
}  // namespace platon
