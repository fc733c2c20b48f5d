#include "client/editor/editor.h"

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include <glm/geometric.hpp>

#include "tests/client/editor/test_editor.h"

namespace platon::editor_test {
namespace {

TEST(EditorTest, ShowsTheLevelAndItsFile) {
  const TestEditor editor;
  const EditorStatus status = editor.status();
  EXPECT_EQ(status.file, "test.level");
  EXPECT_EQ(status.title, "Test");
  EXPECT_FALSE(status.unsaved);
  EXPECT_EQ(status.error, "");
  EXPECT_EQ(editor.scene().stage->title, "Test");
  EXPECT_EQ(editor.analysed(), editor.level().document().level());
}

TEST(EditorTest, AnEditGivesAnotherLevelToAnalyse) {
  TestEditor editor;
  const auto before = editor.analysed();
  editor.key(Key::kD);
  editor.drag({0, {-50, 10}}, {0, {50, 10}});
  EXPECT_NE(editor.analysed(), before);
}

TEST(EditorTest, ABallIsPlayedFromTheClickedPlace) {
  TestEditor editor;
  editor.key(Key::kP);
  editor.click({0, {-60, -150}});
  ASSERT_TRUE(editor.status().playing);
  EXPECT_EQ(editor.analysed()->start, Point(-60 * 1024, -150 * 1024)) << "the search begins at the ball";
  const double before = editor.scene().focus.position.x;
  editor.handle(KeyEvent{Key::kArrowRight, KeyEvent::Kind::kPress});
  for (int i = 0; i < 90; ++i) editor.advance(1.0 / 60);
  const Scene scene = editor.scene();
  ASSERT_EQ(scene.players.size(), 1U);
  EXPECT_GT(glm::distance(scene.focus.position, glm::dvec3(before, scene.focus.position.y, scene.focus.position.z)),
            50);
  EXPECT_TRUE(editor.status().arrived);
  editor.key(Key::kEscape);
  EXPECT_FALSE(editor.status().playing);
  EXPECT_EQ(editor.level().text(), TestEditor::levelText()) << "the start of the level stays";
}

TEST(EditorTest, ABallInAWallIsRefused) {
  TestEditor editor;
  editor.key(Key::kP);
  editor.click({0, {0, -200}});
  EXPECT_FALSE(editor.status().playing);
  EXPECT_EQ(editor.status().message.substr(0, 26), "the ball does not fit here");
}

TEST(EditorTest, TheTextOfAnotherProgramIsShown) {
  TestEditor editor;
  editor.reload(TestEditor::levelText("-50 10 50 10\n"));
  EXPECT_EQ(editor.all().size(), 2U);
  EXPECT_FALSE(editor.level().unsaved());
}

TEST(EditorTest, AReportIsMarkedOnTheFaces) {
  TestEditor editor;
  LevelReport report;
  report.reached = std::make_shared<const std::vector<FacePlace>>(3);
  editor.setReport(report);
  EXPECT_EQ(editor.scene().marksBelow->size(), 3U);
  editor.key(Key::kH);
  EXPECT_EQ(editor.scene().marksBelow->size(), 0U);
}

TEST(EditorTest, TheHoveredSegmentIsMarked) {
  TestEditor editor;
  EXPECT_TRUE(editor.scene().marksAbove->empty());
  editor.move({0, {0, -198}});
  ASSERT_EQ(editor.scene().marksAbove->size(), 1U);
  EXPECT_EQ(editor.scene().marksAbove->front().a, glm::vec2(-200, -200));
}

TEST(EditorTest, UndoAndRedo) {
  TestEditor editor;
  editor.key(Key::kD);
  editor.drag({0, {-50, 10}}, {0, {50, 10}});
  const std::string drawn = editor.level().text();
  editor.key(Key::kZ, true);
  EXPECT_EQ(editor.level().text(), TestEditor::levelText());
  EXPECT_FALSE(editor.level().unsaved());
  editor.key(Key::kY, true);
  EXPECT_EQ(editor.level().text(), drawn);
  editor.key(Key::kZ, true);
  editor.key(Key::kZ, true, true);
  EXPECT_EQ(editor.level().text(), drawn);
  editor.key(Key::kY, true);
  EXPECT_EQ(editor.status().message, "nothing to redo");
}

TEST(EditorTest, SavingAnInvalidLevelSaysSo) {
  TestEditor editor;
  editor.markSaved();
  EXPECT_EQ(editor.status().message, "saved");
  editor.key(Key::kT);
  editor.click({0, {0, -201}});
  editor.markSaved();
  EXPECT_EQ(editor.status().message.substr(0, 10), "saved, but");
}

}  // namespace
}  // namespace platon::editor_test
