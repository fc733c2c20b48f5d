#include "client/play/title_screen.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <GLFW/glfw3.h>
#include <gtest/gtest.h>

#include "client/menu/pages/settings_pages.h"
#include "tests/client/gl/shown_pictures.h"
#include "tests/client/play/window_play_fixture.h"

// Runs on a virtual display with a window manager (on_display.sh).
namespace platon::window_play_test {
namespace {

constexpr int kSettingsItem = 4;  // of the menu over the game, below Resume
constexpr const char* kKeysItem = "Keys and buttons";

std::string keys(const std::string& key, int times) {
  std::string command = "key";
  for (int i = 0; i < times; ++i) command += " " + key;
  return command;
}

bool hasSize(int width, int height) {
  int nowWidth = 0;
  int nowHeight = 0;
  glfwGetWindowSize(glfwGetCurrentContext(), &nowWidth, &nowHeight);
  return nowWidth == width && nowHeight == height;
}

bool isFullscreen() { return glfwGetWindowMonitor(glfwGetCurrentContext()) != nullptr && hasSize(1280, 1024); }

TEST_F(WindowPlayTest, TheRightArrowInTheMenuTurnsFullScreenOn) {
  play({{[] { xdotool("key Escape " + keys("Down", kSettingsItem).substr(4) + " Return Right"); }, isFullscreen},
        {[] { xdotool("key Left"); }, [] { return !isFullscreen(); }},
        {[] { xdotool("key Right"); }, isFullscreen}});
  EXPECT_TRUE(stepsDone_);
  Settings expected;
  expected.fullscreen = true;
  EXPECT_EQ(savedSettings(), expected.text());
}

TEST_F(WindowPlayTest, AKeyTurnsFullScreenOnAndOff) {
  play({{[] { xdotool("key F11"); }, isFullscreen},
        {[] { xdotool("key alt+Return"); }, [] { return !isFullscreen(); }}});
  EXPECT_TRUE(stepsDone_);
  EXPECT_EQ(savedSettings(), Settings().text());
}

TEST_F(WindowPlayTest, StartsInFullScreenIfTheSettingsSaySo) {
  std::filesystem::create_directories(folder_ / "platon");
  writeText(folder_ / "platon/settings", "fullscreen on\n");
  play({{[] {}, isFullscreen}});
  EXPECT_TRUE(stepsDone_);
}

TEST_F(WindowPlayTest, AWindowOfOnePixelGoesOnAndComesBackInTheTitleInAReplayAndInTheGame) {
  options_.level.clear();
  keepRecording("Anna.recording");
  std::vector<WindowStep> steps;
  int frames = 0;
  const auto add = [&steps](std::vector<WindowStep> more) { steps.insert(steps.end(), more.begin(), more.end()); };
  const auto resized = [&frames](int width, int height) {
    const std::string size = std::to_string(width) + " " + std::to_string(height);
    return std::vector<WindowStep>{
        {[size] { xdotool("getactivewindow windowsize " + size); }, [=] { return hasSize(width, height); }},
        {[&frames] { frames = 0; }, [&frames] { return ++frames == 5; }}};
  };
  const auto shrink = [&] {
    add(resized(1, 1));
    add(resized(1280, 720));
  };
  shrink();
  add(toReplay());
  shrink();
  add(fromReplayToGame());
  shrink();
  add({{[] { xdotool("key Escape"); }, [this] { return shows("Resume"); }}});
  play(std::move(steps));
  EXPECT_TRUE(stepsDone_);
}

TEST_F(WindowPlayTest, TheMenuLeadsToTheTitleAndTheTitleQuits) {
  play({{[] { xdotool("key Escape Up Return"); }, [this] { return match() == nullptr; }},
        {[] { xdotool("key Up Return"); }, [] { return false; }}});
  EXPECT_FALSE(timeIsUp_);
  EXPECT_EQ(savedSettings(), Settings().text());
}

TEST_F(WindowPlayTest, WithoutALevelItStartsAtTheTitleAndPlays) {
  options_.level.clear();
  play({{[] {}, [this] { return match() == nullptr && menu().isOpen(); }},
        {[] { xdotool("key Return"); }, [this] { return inGame(); }}});
  EXPECT_TRUE(stepsDone_);
}

TEST_F(WindowPlayTest, AServerThatDoesNotAnswerIsReportedOnTheScreenAndAtTheEnd) {
  options_.level.clear();
  options_.seconds.reset();
  options_.server = ServerAddress{"127.0.0.1", 1};
  const auto failed = [this] { return menu().isOpen(); };
  EXPECT_THROW(play({{[] {}, failed},
                     {[] { xdotool("key Return"); }, [this] { return inGame(); }},
                     {[] {}, failed},
                     {[] { xdotool("key Escape"); }, [this] { return match() == nullptr; }}}),
               ProgramError);
}

TEST_F(WindowPlayTest, WithATimeLimitAFailureEndsTheProgram) {
  options_.level = "no_such.level";
  EXPECT_THROW(play({}), ProgramError);
}

TEST_F(WindowPlayTest, AnInvalidLevelIsReportedOnTheScreen) {
  options_.level = folder_ / "broken.level";
  options_.seconds.reset();
  writeText(options_.level, "CUBE\n");
  try {
    play({{[] {}, [this] { return menu().isOpen() && match() == nullptr; }}});
    FAIL();
  } catch (const ProgramError& error) {
    EXPECT_EQ(error.exitCode(), ProgramError::kInvalid);
  }
}

TEST_F(WindowPlayTest, AGamepadMovesThroughTheMenu) {
  const auto push = [](int button) { fakeGamepad.emplace().buttons[button] = GLFW_PRESS; };
  // Each state of the gamepad lasts one frame.
  std::vector<WindowStep> steps;
  const auto tap = [&](int button) {
    steps.push_back({[=] { push(button); }, [] { return true; }});
    steps.push_back({[] { fakeGamepad.emplace(); }, [] { return true; }});
  };
  tap(GLFW_GAMEPAD_BUTTON_START);
  for (int i = 0; i < kSettingsItem; ++i) tap(GLFW_GAMEPAD_BUTTON_DPAD_DOWN);
  tap(GLFW_GAMEPAD_BUTTON_A);
  tap(GLFW_GAMEPAD_BUTTON_DPAD_RIGHT);
  steps.push_back({[] {}, isFullscreen});
  play(std::move(steps));
  EXPECT_TRUE(stepsDone_);
}

TEST_F(WindowPlayTest, AGamepadThatIsUnpluggedPausesAndIsUsedAgainWhenItIsPlugged) {
  const auto push = [](int button) { fakeGamepad.emplace().buttons[button] = GLFW_PRESS; };
  play({{[] {}, [this] { return isOnGround() == std::optional(true); }},
        {[=] { push(GLFW_GAMEPAD_BUTTON_A); }, [this] { return isOnGround() == std::optional(false); }},
        {[] { fakeGamepad.reset(); }, [this] { return shows("Resume") && match()->paused(); }},
        {[=] { push(GLFW_GAMEPAD_BUTTON_A); }, [this] { return inGame(); }}});
  EXPECT_TRUE(stepsDone_);
}

TEST_F(WindowPlayTest, TheMouseChoosesAndChanges) {
  play({{[] { xdotool("key Escape"); }, [this] { return menu().isOpen(); }},
        {[this] { click(kSettingsItem); }, [this] { return shows("Full screen"); }},
        {[this] { click(1); }, isFullscreen}});
  EXPECT_TRUE(stepsDone_);
}

TEST_F(WindowPlayTest, TheMouseGoesBackByItsButtonsAndByTheMark) {
  options_.level.clear();
  const auto inLevels = [this] { return shows("Run and jump") && !shows("Quit"); };
  const auto atTitle = [this] { return shows("Quit"); };
  const std::string onPicture = "mousemove --window $(xdotool getactivewindow) 1200 700 click ";
  play({{[] {}, atTitle},
        {[this] { clickOn("Levels"); }, inLevels},
        {[&] { xdotool(onPicture + "3"); }, atTitle},
        {[this] { clickOn("Levels"); }, inLevels},
        {[&] { xdotool(onPicture + "8"); }, atTitle},
        {[this] { clickOn("Levels"); }, inLevels},
        {[this] { clickOn(menu().layout(font_).back.box); }, atTitle}});
  EXPECT_TRUE(stepsDone_);
}

TEST_F(WindowPlayTest, AloneTheMenuPausesTheGame) {
  std::uint32_t ticks = 0;
  int frames = 0;
  play({{[] {}, [&] { return confirmedTicks() > 30; }},
        {[] { xdotool("key Escape"); }, [this] { return match()->paused(); }},
        {[&] { frames = 0; },
         [&] {
           if (++frames == 10) ticks = confirmedTicks();
           return frames == 40;
         }},
        {[&] {
           EXPECT_EQ(confirmedTicks(), ticks);
           xdotool("key Escape");
         },
         [&] { return confirmedTicks() > ticks + 30; }}});
  EXPECT_TRUE(stepsDone_);
}

// An X11 window keeps its size while it is minimised.
TEST_F(WindowPlayTest, AMinimisedWindowDrawsNothingAndPlaysOn) {
  std::uint32_t ticks = 0;
  std::size_t pictures = 0;
  play({{[] {}, [this] { return confirmedTicks() > 30; }},
        {[] { xdotool("getactivewindow windowminimize"); }, [] { return windowHas(GLFW_ICONIFIED); }},
        {[&] {
           ticks = confirmedTicks();
           pictures = shownPictures;
         },
         [&] { return confirmedTicks() > ticks + 30; }},
        {[&] {
           EXPECT_EQ(shownPictures, pictures);
           glfwRestoreWindow(glfwGetCurrentContext());
         },
         [&] { return shownPictures > pictures; }}});
  EXPECT_TRUE(stepsDone_);
}

TEST_F(WindowPlayTest, AChosenKeyJumps) {
  Settings settings;
  const std::vector<MenuItem> items = settingsPage(settings, SubPages()).items;
  const auto row = std::find_if(items.begin(), items.end(), [](const auto& item) { return item.name == kKeysItem; });
  const auto above = std::count_if(items.begin(), row, [](const auto& item) { return item.canHaveFocus(); });
  const auto grounded = [this] { return isOnGround() == std::optional(true); };
  play({{[] {}, grounded},
        {[] { xdotool("key Escape " + keys("Down", kSettingsItem).substr(4) + " Return"); },
         [this] { return shows("Full screen"); }},
        {[&] { xdotool(keys("Down", static_cast<int>(above)) + " Return"); }, [this] { return shows("Jump"); }},
        {[] { xdotool(keys("Down", static_cast<int>(Control::kJump)) + " Return j"); }, [] { return true; }},
        {[] { xdotool(keys("Escape", 3)); }, [this] { return inGame(); }},
        {[] { xdotool("keydown j"); }, [this] { return isOnGround() == std::optional(false); }},
        {[] { xdotool("keyup j"); }, grounded}});
  EXPECT_TRUE(stepsDone_);
  EXPECT_NE(savedSettings().find("\nkey jump j space pad-a\n"), std::string::npos);
}

TEST_F(WindowPlayTest, TheTitleTellsThatLinesOfTheSettingsAreInvalid) {
  options_.level.clear();
  const std::string file = folder_ / "platon/settings";
  std::filesystem::create_directories(folder_ / "platon");
  writeText(file, "key jump spcae\n");
  play({{[] {},
         [&] {
           return shows("Quit") && desk_->told() == "1 line of " + file +
                                                        " is invalid; the next save keeps the old file as " + file +
                                                        ".broken";
         }}});
  EXPECT_TRUE(stepsDone_);
  EXPECT_EQ(readText(file + ".broken"), "key jump spcae\n");
}

TEST_F(WindowPlayTest, ASavedPictureIsToldInTheTitleInAReplayAndInTheGame) {
  options_.level.clear();
  keepRecording("Anna.recording");
  const auto press = [this](int number) {
    const std::string file = (folder_ / ("platon-000" + std::to_string(number) + ".png")).string();
    return WindowStep{[] { xdotool("key F12"); }, [this, file] { return desk_->told() == "picture saved: " + file; }};
  };
  std::vector<WindowStep> steps{press(1)};
  for (WindowStep& step : toReplay()) steps.push_back(std::move(step));
  steps.push_back(press(2));
  for (WindowStep& step : fromReplayToGame()) steps.push_back(std::move(step));
  steps.push_back(press(3));
  play(std::move(steps));
  EXPECT_TRUE(stepsDone_);
}

TEST_F(WindowPlayTest, AReplayIsWatchedFromTheTitleAndLeadsBack) {
  options_.level.clear();
  keepRecording("Anna.recording");
  std::uint32_t at = 0;
  play({{[] { xdotool("key Down Down Down Down Return"); }, [this] { return shows("Hexahedron"); }},
        {[] { xdotool("key Return"); }, [this] { return shows("Watch"); }},
        {[] { xdotool("key Return"); }, [this] { return viewer() && player().tick() > 10; }},
        {[] { xdotool("key space"); }, [this] { return player().paused(); }},
        {[&] {
           at = player().tick();
           xdotool("key Right");
         },
         [&] { return player().tick() == at + 1; }},
        {[] { xdotool("key shift+Right"); }, [&] { return player().tick() == at + 301; }},
        {[] { xdotool("mousemove --window $(xdotool getactivewindow) 640 666 click 1"); },
         [this] { return std::abs(player().tick() - player().replay().ticks() / 2.0) < 10; }},
        {[] { xdotool("key Tab"); }, [this] { return player().followed() != 0; }},
        {[] { xdotool("key plus plus"); }, [this] { return player().speed() == 4; }},
        {[] { xdotool("key F11"); }, isFullscreen},
        {[] { xdotool("key F11"); }, [] { return !isFullscreen(); }},
        {[] { xdotool("key Escape"); }, [this] { return replay() == nullptr && shows("Watch"); }},
        {[] { xdotool("key Escape"); }, [this] { return shows("Hexahedron"); }},
        {[] { xdotool("key Escape"); }, [this] { return shows("Quit"); }}});
  EXPECT_TRUE(stepsDone_);
}

// The menu thought the pointer where it had been before the replay.
TEST_F(WindowPlayTest, APointerThatCameToRestOverAReplayLeavesTheFocusToTheKeys) {
  options_.level.clear();
  keepRecording("Anna.recording");
  keepRecording("Ben.recording");
  std::string overFirst;
  int frames = 0;
  std::size_t second = 0;
  std::vector<WindowStep> steps = toReplay();
  steps[1].act = [&] {
    const glm::vec2 place = menu().layout(font_).rows.front().box.high - 8.0F;
    overFirst = std::to_string(std::lround(place.x)) + " " + std::to_string(std::lround(place.y));
    second = menu().focus() + 1;
    xdotool("key Return");
  };
  steps.push_back(
      {[&] { xdotool("mousemove --window $(xdotool getactivewindow) " + overFirst); }, [&] { return ++frames == 3; }});
  steps.push_back({[] { xdotool("key Escape"); }, [this] { return shows("Watch"); }});
  steps.push_back({[] { xdotool("key Escape"); }, [this] { return shows("Hexahedron"); }});
  steps.push_back({[] { xdotool("key Down"); }, [&] { return menu().focus() == second; }});
  steps.push_back({[] { xdotool("mousemove_relative 1 0"); }, [&] { return ++frames == 6; }});
  steps.push_back({[&] { EXPECT_EQ(menu().focus(), second); }, [] { return true; }});
  play(std::move(steps));
  EXPECT_TRUE(stepsDone_);
}

TEST_F(WindowPlayTest, ARecordingThatCannotBePlayedIsReportedOnTheScreen) {
  options_.level.clear();
  const std::string whole = readText(kRecording);
  keepRecording("Anna.recording");
  play({{[] { xdotool("key Down Down Down Down Return Return"); }, [this] { return shows("Watch"); }},
        {[&] {
           writeText(folder_ / "platon/ghosts/Anna.recording", whole.substr(0, whole.size() / 2));
           xdotool("key Return");
         },
         [this] { return shows("Try again"); }},
        {[this] {
           keepRecording("Anna.recording");  // mended
           xdotool("key Return");
         },
         [this] { return viewer() != nullptr; }},
        {[] { xdotool("key Escape"); }, [this] { return shows("Watch"); }}});
  EXPECT_TRUE(stepsDone_);
}

TEST_F(WindowPlayTest, ARecordingOfTheCommandLineIsPlayedAndLeadsToItsPage) {
  options_.level.clear();
  options_.replay = kRecording;
  play({{[] {}, [this] { return viewer() != nullptr; }},
        {[] { xdotool("key Escape"); }, [this] { return shows("Watch"); }}});
  EXPECT_TRUE(stepsDone_);
}

TEST_F(WindowPlayTest, ARecordingOfTheCommandLineThatCannotBePlayedIsReportedAlsoAtTheEnd) {
  options_.level.clear();
  options_.seconds.reset();
  options_.replay = (folder_ / "text").string();
  writeText(options_.replay, "no recording");
  try {
    play({{[] {}, [this] { return shows("Try again"); }}});
    FAIL();
  } catch (const ProgramError& error) {
    EXPECT_EQ(error.exitCode(), ProgramError::kInvalid);
  }
}

TEST_F(WindowPlayTest, ADroppedRecordingIsPlayedButNotDuringAGame) {
  const auto drop = [] {
    GLFWwindow* const handle = glfwGetCurrentContext();
    const GLFWdropfun dropped = glfwSetDropCallback(handle, nullptr);
    glfwSetDropCallback(handle, dropped);
    const char* path = kRecording;
    dropped(handle, 1, &path);
  };
  int frames = 0;
  play({{drop, [&] { return ++frames == 3; }},
        {[this] { EXPECT_EQ(replay(), nullptr); }, [] { return true; }},
        {[] { xdotool("key Escape Up Return"); }, [this] { return match() == nullptr; }},
        {drop, [this] { return viewer() != nullptr; }}});
  EXPECT_TRUE(stepsDone_);
}

TEST_F(WindowPlayTest, TheBestRunIsWatchedInAPauseAndLeadsBackToIt) {
  options_.level = "levels/data/hexahedron/01_run_and_jump.level";
  const std::uint64_t level = loadLevel(readText(options_.level)).level->hash;
  std::filesystem::create_directories(folder_ / "platon/runs");
  std::filesystem::copy_file("levels/data/ways/01_run_and_jump.recording",
                             folder_ / "platon/runs" / RunStore::fileNameOf(level, 5));
  play({{[] {}, [this] { return isOnGround().has_value(); }},
        {[] { xdotool("key Escape"); }, [this] { return shows("Watch your best run"); }},
        {[] { xdotool("key Down Down Down Return"); }, [this] { return viewer() && player().tick() > 10; }},
        {[] {}, [this] { return match()->paused(); }},
        {[] { xdotool("key Escape"); }, [this] { return shows("Watch your best run"); }},
        {[] { xdotool("key Escape"); }, [this] { return inGame() && !match()->paused(); }}});
  EXPECT_TRUE(stepsDone_);
}

TEST_F(WindowPlayTest, AloneAnUnfinishedLevelIsLeftAtTheSecondWish) {
  const auto round = [this] {
    const Session* const session = match()->client().session();
    return session && session->round() ? session->round()->id() : 0;
  };
  int frames = 0;
  play({{[] {}, [&] { return round() == 1 && match()->alone(); }},
        {[] { xdotool("key v key Left key v"); }, [&] { return ++frames == 30; }},
        {[&] {
           EXPECT_EQ(round(), 1U) << "another key takes the wish back";
           xdotool("key v");
         },
         [&] { return round() == 2; }}});
  EXPECT_TRUE(stepsDone_);
}

TEST_F(WindowPlayTest, ClosingTheWindowLeavesTheGame) {
  play({{[] { xdotool("key alt+F4"); }, [] { return false; }}});
  EXPECT_FALSE(timeIsUp_);
}

}  // namespace
}  // namespace platon::window_play_test
