#include "client/play/edit_play.h"

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

#include "client/time/steady_now.h"
#include "protocol/program_error.h"
#include "tests/client/gl/desktop.h"
#include "tests/client/gl/shown_pictures.h"
#include "tests/client/play/window_steps.h"
#include "tests/support/environment_variable.h"
#include "tests/support/files.h"
#include "tests/support/temporary_folder.h"

// Runs on a virtual display with a window manager (on_display.sh).
namespace platon::edit_play_test {
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

class EditPlayTest : public testing::Test {
 protected:
  EditPlayTest() {
    options_.edit = path_.string();
    options_.seconds = 300;  // a test that does not end by itself fails
  }

  // Edits until the user leaves or all steps are done. Returns whether all steps were done, as `runSteps`.
  testing::AssertionResult edit(std::vector<WindowStep> steps) {
    EditPlay play(options_, steadyClock());
    play_ = &play;
    const Moment start = steadyClock().now();
    testing::AssertionResult allDone = runSteps(play, std::move(steps));
    timeIsUp_ = toSeconds(steadyClock().now() - start) >= *options_.seconds;
    return allDone;
  }

  // What the editor shows with these settings when its search has ended.
  Image pictureWith(const std::string& settings) {
    const EnvironmentVariable config("XDG_CONFIG_HOME", folder_.path().string());
    std::filesystem::create_directories(folder_ / "platon");
    writeText(folder_ / "platon/settings", settings);
    Image image;
    int frames = 0;
    const auto isFound = [this] { return play_->editor().status().report.finished; };
    EXPECT_TRUE(edit({{[] {}, isFound},
                      {[&] { onPicture = [&image] { image = backBuffer(); }; }, [&frames] { return ++frames == 3; }}}));
    onPicture = {};
    return image;
  }

  bool fileHas(const std::string& text) const {
    return std::filesystem::exists(path_) && readText(path_).find(text) != std::string::npos;
  }

  const TemporaryFolder folder_;
  const std::filesystem::path path_ = folder_ / "02_new_room.level";
  ClientOptions options_;
  const EditPlay* play_ = nullptr;
  bool timeIsUp_ = false;
};

TEST_F(EditPlayTest, ASegmentIsDrawnAndSavedIntoANewFile) {
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

TEST_F(EditPlayTest, LeavingWithUnsavedChangesAsks) {
  edit({{[] { xdotool("key Escape Down Return"); }, [] { return false; }}});
  EXPECT_FALSE(timeIsUp_);
  EXPECT_TRUE(fileHas("HEXAHEDRON")) << "saved and left";
}

TEST_F(EditPlayTest, ClosingTheWindowAsksToo) {
  edit({{[] { xdotool("key alt+F4"); }, [this] { return play_->editor().menu().isOpen(); }},
        {[] { xdotool("key Up Return"); }, [] { return false; }}});
  EXPECT_FALSE(timeIsUp_);
  EXPECT_FALSE(std::filesystem::exists(path_)) << "left without saving";
}

TEST_F(EditPlayTest, AChangedFileIsReadAgain) {
  std::filesystem::copy_file("levels/data/hexahedron/01_run_and_jump.level", path_);
  const std::string text = readText(path_) + "# more\n";
  EXPECT_TRUE(edit({{[&] { writeText(path_, text); }, [&] { return play_->editor().level().text() == text; }}}));
}

TEST_F(EditPlayTest, WhatAnotherProgramHasWrittenIsReplacedOnlyWhenAskedAgain) {
  const std::string text = readText("levels/data/hexahedron/01_run_and_jump.level");
  writeText(path_, text);
  const auto drawn = [&] { return play_->editor().level().unsaved(); };
  const auto refuses = [&] { return play_->editor().status().message.find("save again") != std::string::npos; };
  EXPECT_TRUE(edit({{[] { xdotool("key d mousemove 500 400 mousedown 1 mousemove --sync 700 420 mouseup 1"); }, drawn},
                    {[&] {
                       writeText(path_, text + "# theirs\n");
                       xdotool("key ctrl+s");
                     },
                     refuses},
                    {[] { xdotool("key ctrl+s"); }, [&] { return !fileHas("# theirs"); }}}));
}

TEST_F(EditPlayTest, IsDrawnAsTheSettingsSay) {
  writeText(path_, kClosedRoom);  // where the search ends soon
  const Image plain = pictureWith("");
  EXPECT_EQ(pictureWith(""), plain);
  for (const char* const settings : {"reduced-motion on\n", "high-contrast on\n", "text-size 1.5\n"})
    EXPECT_NE(pictureWith(settings), plain) << settings;
}

TEST_F(EditPlayTest, AMinimisedWindowDrawsNothing) {
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

TEST_F(EditPlayTest, OffscreenThePictureIsWritten) {
  options_.offscreen = true;
  options_.seconds = 0.5;
  options_.screenshot = (folder_ / "picture.png").string();
  options_.solid = SolidKind::kIcosahedron;
  EditPlay(options_, steadyClock()).run([] { return false; });
  EXPECT_GT(std::filesystem::file_size(options_.screenshot), 10000U);
  EXPECT_FALSE(std::filesystem::exists(path_));
}

TEST_F(EditPlayTest, AnInvalidLevelIsRefusedWithItsErrors) {
  writeText(path_, "CUBE\n");
  try {
    const EditPlay play(options_, steadyClock());
    ADD_FAILURE() << "accepted";
  } catch (const ProgramError& error) {
    EXPECT_EQ(error.exitCode(), ProgramError::kInvalid);
    EXPECT_NE(std::string(error.what()).find("02_new_room.level:1:1: error: unknown solid"), std::string::npos);
  }
}

}  // namespace
}  // namespace platon::edit_play_test
