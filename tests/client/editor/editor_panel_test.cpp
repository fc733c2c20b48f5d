#include "client/editor/editor_panel.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "client/editor/level_document.h"
#include "client/ui/overlay.h"

namespace platon::editor_panel_test {
namespace {

bool shows(const EditorStatus& status, const std::string& text) {
  const Font font;
  const Overlay overlay = makeEditorPanel(status, font, {1280, 720});
  return std::any_of(overlay.texts.begin(), overlay.texts.end(),
                     [&](const Overlay::Text& one) { return one.content.find(text) != std::string::npos; });
}

EditorStatus statusOf(LevelReport::Way way) {
  EditorStatus status;
  status.file = "a.level";
  status.report.way = way;
  return status;
}

TEST(EditorPanelTest, AnUnsavedFileHasAStar) {
  EditorStatus status = statusOf(LevelReport::Way::kSearching);
  EXPECT_FALSE(shows(status, "a.level *"));
  status.unsaved = true;
  EXPECT_TRUE(shows(status, "a.level *"));
}

TEST(EditorPanelTest, TheReportSaysWhatIsKnown) {
  EXPECT_TRUE(shows(statusOf(LevelReport::Way::kSearching), "finding where the ball can get"));
  EXPECT_TRUE(shows(statusOf(LevelReport::Way::kImpossible), "the goal cannot be reached"));
  EXPECT_TRUE(shows(statusOf(LevelReport::Way::kImpossible), "proved"));
  EXPECT_TRUE(shows(statusOf(LevelReport::Way::kNotFound), "no way to the goal found"));
  EditorStatus givenUp = statusOf(LevelReport::Way::kNotFound);
  givenUp.report.states = LevelAnalysis::kMaxStates;
  EXPECT_TRUE(shows(givenUp, "gave up searching"));
  EditorStatus solved = statusOf(LevelReport::Way::kFound);
  solved.report.facts = {.ticks = 378, .presses = 3, .crossings = 1, .turns = 2, .slack = 9, .elements = {}};
  EXPECT_EQ(linesOf(solved.report),
            (std::vector<std::string>{"solved in 6.30 s", "3 presses, 1 crossing, 2 turns of down",
                                      "tightest jump 9 ticks, difficulty 14"}));
  EXPECT_TRUE(shows(solved, "✓ solved in 6.30 s"));
}

TEST(EditorPanelTest, TheReportSaysForHowManyPlayersItIs) {
  LevelReport report;
  report.level = loadLevel("# players: 2\n" + newLevelText(SolidKind::kHexahedron, "For two")).level;
  EXPECT_EQ(linesOf(report).back(), "for 2 players; all must reach the goal");
}

TEST(EditorPanelTest, WarningsAreShownUpToALimit) {
  LevelReport report;
  report.warnings.assign(20, {7, 1, false, "nobody can touch this"});
  EXPECT_EQ(linesOf(report).size(), 5U);
  EXPECT_EQ(linesOf(report).back(), "text line 7: nobody can touch this");
}

// Before, only spaces stood between the keys.
TEST(EditorPanelTest, WhatStandsOnALineIsSeparated) {
  EditorStatus status = statusOf(LevelReport::Way::kSearching);
  status.word = {ElementKind::kDoor, {4}};
  status.playing = true;
  EXPECT_TRUE(shows(status, "door 4 · grid "));
  EXPECT_TRUE(shows(status, "Playing · R: try again from here · Esc: back to editing"));
  EXPECT_FALSE(shows(status, "  "));
  status.arrived = true;
  EXPECT_TRUE(shows(status, "✓ Goal! · R: try again from here · Esc: back to editing"));
  EXPECT_FALSE(shows(status, "  "));
}

TEST(EditorPanelTest, ErrorsAndTheHelpAreShown) {
  EditorStatus status = statusOf(LevelReport::Way::kSearching);
  EXPECT_FALSE(shows(status, "Ctrl+S"));
  status.help = true;
  EXPECT_TRUE(shows(status, "Ctrl+S"));
  status.error = "a.level:3:1: error: no";
  EXPECT_TRUE(shows(status, "a.level:3:1"));
}

// Before, it was gold, and the golden letter of the tool could not be read on it.
TEST(EditorPanelTest, TheSelectedToolStandsOutFromItsPanel) {
  const Font font;
  const Overlay overlay = makeEditorPanel(statusOf(LevelReport::Way::kSearching), font, {1280, 720});
  EXPECT_EQ(std::count_if(overlay.panels.begin(), overlay.panels.end(),
                          [](const Overlay::Panel& panel) { return panel.colour == overlay_colours::kSelected; }),
            1);
}

TEST(EditorPanelTest, AWordIsNamedWithItsNumber) {
  EXPECT_EQ(nameOf(SegmentWord{}), "segment");
  EXPECT_EQ(nameOf(SegmentWord{ElementKind::kOneway, {4}}), "oneway");
  EXPECT_EQ(nameOf(SegmentWord{ElementKind::kDoor, {4}}), "door 4");
}

TEST(EditorPanelTest, EverythingIsOnTheScreen) {
  const Font font;
  EditorStatus status = statusOf(LevelReport::Way::kImpossible);
  status.help = true;
  for (const Overlay::Text& text : makeEditorPanel(status, font, {960, 720}).texts) {
    EXPECT_GE(text.place.x, 0);
    EXPECT_LE(text.place.x + font.width(text.content) * text.size, 960) << text.content;
    EXPECT_LE(text.place.y, Overlay::kHeight);
  }
}

}  // namespace
}  // namespace platon::editor_panel_test
