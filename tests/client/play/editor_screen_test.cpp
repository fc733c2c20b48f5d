#include "client/play/editor_screen.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <GLFW/glfw3.h>

#include "client/files/settings_file.h"
#include "client/files/user_folders.h"
#include "client/gl/gl_context.h"
#include "client/time/steady_now.h"
#include "protocol/program_error.h"
#include "tests/client/gl/desktop.h"
#include "tests/client/gl/shown_pictures.h"
#include "tests/client/play/window_steps.h"
#include "tests/support/environment_variable.h"
#include "tests/support/files.h"
#include "tests/support/temporary_folder.h"

// Runs on a virtual display with a window manager (on_display.sh).
namespace platon::editor_screen_test {
namespace {

constexpr std::string_view kClosedRoom = R"(HEXAHEDRON
0 -60 -128 0
0 60 -128
480
%
-100 -140 100 -140
100 -140 100 -90
100 -90 -100 -90
-100 -90 -100 -140
%
%
%
%
%
)";

class EditorScreenTest : public testing::Test {
 protected:
  // Edits until the user leaves or all steps are done. Returns whether all steps were done, as `runSteps`.
  testing::AssertionResult edit(std::vector<WindowStep> steps) {
    EditSession session(path_.string(), SolidKind::kHexahedron);
    editor_ = &session.editor();
    DesktopWindow window = openWindow("");
    const Settings settings = SettingsFile(configFolder()).load();
    ScreenStack screens(std::make_unique<EditorScreen>(session, window, settings, ""));
    const Time start = steadyClock().now();
    testing::AssertionResult allDone = runSteps(screens, window, kLimit, std::move(steps));
    timeIsUp_ = toSeconds(steadyClock().now() - start) >= kLimit;
    return allDone;
  }

  // What the editor shows with these settings when its search has ended.
  Image pictureWith(const std::string& settings) {
    const EnvironmentVariable config("XDG_CONFIG_HOME", folder_.path().string());
    std::filesystem::create_directories(folder_ / "platon");
    writeText(folder_ / "platon/settings", settings);
    Image image;
    int frames = 0;
    const auto isFound = [this] { return editor_->status().report.finished; };
    EXPECT_TRUE(edit({{[] {}, isFound},
                      {[&] { onPicture = [&image] { image = backBuffer(); }; }, [&frames] { return ++frames == 3; }}}));
    onPicture = {};
    return image;
  }

  bool fileHas(const std::string& text) const {
    return std::filesystem::exists(path_) && readText(path_).find(text) != std::string::npos;
  }

  static constexpr double kLimit = 300;  // s: a test that does not end by itself fails
  const TemporaryFolder folder_;
  const std::filesystem::path path_ = folder_ / "02_new_room.level";
  const Editor* editor_ = nullptr;
  bool timeIsUp_ = false;
};

TEST_F(EditorScreenTest, ASegmentIsDrawnAndSavedIntoANewFile) {
  EXPECT_TRUE(edit({{[] {
                       xdotool(
                           "key d mousemove 500 470 mousedown 1 mousemove --sync 600 470 mousemove --sync 700 480 "
                           "mouseup 1 key ctrl+s");
                     },
                     [this] { return fileHas("# title: New room"); }}}));
  const std::shared_ptr<const Level> level = loadLevel(readText(path_)).level;
  ASSERT_TRUE(level);
  std::size_t segments = 0;
  for (const auto& face : level->segments) segments += face.size();
  EXPECT_EQ(segments, 2U) << readText(path_);
}

TEST_F(EditorScreenTest, LeavingWithUnsavedChangesAsks) {
  edit({{[] { xdotool("key Escape Down Return"); }, [] { return false; }}});
  EXPECT_FALSE(timeIsUp_);
  EXPECT_TRUE(fileHas("HEXAHEDRON")) << "saved and left";
}

TEST_F(EditorScreenTest, ClosingTheWindowAsksToo) {
  edit({{[] { xdotool("key alt+F4"); }, [this] { return editor_->menu().isOpen(); }},
        {[] { xdotool("key Up Return"); }, [] { return false; }}});
  EXPECT_FALSE(timeIsUp_);
  EXPECT_FALSE(std::filesystem::exists(path_)) << "left without saving";
}

TEST_F(EditorScreenTest, AChangedFileIsReadAgain) {
  std::filesystem::copy_file("levels/data/hexahedron/01_run_and_jump.level", path_);
  const std::string text = readText(path_) + "# more\n";
  EXPECT_TRUE(edit({{[&] { writeText(path_, text); }, [&] { return editor_->level().text() == text; }}}));
}

TEST_F(EditorScreenTest, WhatAnotherProgramHasWrittenIsReplacedOnlyWhenAskedAgain) {
  const std::string text = readText("levels/data/hexahedron/01_run_and_jump.level");
  writeText(path_, text);
  const auto drawn = [&] { return editor_->level().unsaved(); };
  const auto refuses = [&] { return editor_->status().message.find("save again") != std::string::npos; };
  EXPECT_TRUE(edit({{[] { xdotool("key d mousemove 500 400 mousedown 1 mousemove --sync 700 420 mouseup 1"); }, drawn},
                    {[&] {
                       writeText(path_, text + "# theirs\n");
                       xdotool("key ctrl+s");
                     },
                     refuses},
                    {[] { xdotool("key ctrl+s"); }, [&] { return !fileHas("# theirs"); }}}));
}

TEST_F(EditorScreenTest, IsDrawnAsTheSettingsSay) {
  writeText(path_, kClosedRoom);  // where the search ends soon
  const Image plain = pictureWith("");
  EXPECT_EQ(pictureWith(""), plain);
  for (const char* const settings : {"reduced-motion on\n", "high-contrast on\n", "text-size 1.5\n"})
    EXPECT_NE(pictureWith(settings), plain) << settings;
}

TEST_F(EditorScreenTest, AMinimisedWindowDrawsNothing) {
  std::size_t pictures = 0;
  int frames = 0;
  EXPECT_TRUE(edit({{[] { xdotool("getactivewindow windowminimize"); }, [] { return windowHas(GLFW_ICONIFIED); }},
                    {[&] { pictures = shownPictures; }, [&] { return ++frames == 10; }},
                    {[&] {
                       EXPECT_EQ(shownPictures, pictures);
                       glfwRestoreWindow(glfwGetCurrentContext());
                     },
                     [&] { return shownPictures > pictures; }}}));
}

TEST_F(EditorScreenTest, OffscreenANewLevelIsDrawn) {
  EditSession session(path_.string(), SolidKind::kIcosahedron);
  const Offscreen context;
  EditorPicture picture{Settings()};
  session.analyse();
  picture.draw(session.editor());
  writePng(picture.read(), folder_ / "picture.png");
  EXPECT_GT(std::filesystem::file_size(folder_ / "picture.png"), 10000U);
  EXPECT_FALSE(std::filesystem::exists(path_));
}

TEST_F(EditorScreenTest, AnInvalidLevelIsRefusedWithItsErrors) {
  writeText(path_, "CUBE\n");
  try {
    const EditSession session(path_.string(), SolidKind::kHexahedron);
    ADD_FAILURE() << "accepted";
  } catch (const ProgramError& error) {
    EXPECT_EQ(error.exitCode(), ProgramError::kInvalid);
    EXPECT_NE(std::string(error.what()).find("02_new_room.level:1:1: error: unknown solid"), std::string::npos);
  }
}

}  // namespace
}  // namespace platon::editor_screen_test
