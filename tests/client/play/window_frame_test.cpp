#include "client/play/title_screen.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include <GLFW/glfw3.h>

#include "client/menu/pages/settings_pages.h"
#include "tests/client/gl/shown_pictures.h"
#include "tests/client/play/window_play_fixture.h"

// What the pictures of the window show, counted in pictures.
namespace platon::window_frame_test {
namespace {

// As GLFW does it: the event is there before the next picture, whenever the X server would have sent it.
void deliver(int key, int action = GLFW_PRESS) {
  GLFWwindow* const window = glfwGetCurrentContext();
  const GLFWkeyfun onKey = glfwSetKeyCallback(window, nullptr);
  glfwSetKeyCallback(window, onKey);
  onKey(window, key, 0, action, 0);
}

void tap(int key, std::ptrdiff_t times = 1) {
  for (; times > 0; --times) {
    deliver(key);
    deliver(key, GLFW_RELEASE);
  }
}

std::vector<std::uint8_t> pixelAt(const Image& image, glm::vec2 place) {
  const auto x = static_cast<std::size_t>(place.x);
  const auto y = static_cast<std::size_t>(place.y);
  const auto first = image.pixels.begin() + static_cast<std::ptrdiff_t>(3 * (y * image.width + x));
  return {first, first + 3};
}

class WindowFrameTest : public WindowPlayTest {
 protected:
  ~WindowFrameTest() override { onPicture = {}; }

  // The next picture, from now on.
  void keepNextPicture() {
    pictures_ = 0;
    onPicture = [this] {
      if (++pictures_ == 1) picture_ = backBuffer();
    };
  }
  // The bar at the left end of a row, which only the one with the focus has; in a window of 1280 × 720.
  std::vector<std::uint8_t> barOf(const Image& image, std::size_t row) const {
    const MenuBox box = menu().layout(font_).rows[row].box;
    return pixelAt(image, {box.low.x + 2, (box.low.y + box.high.y) / 2});
  }
  const Prediction& prediction() const { return match()->client().session()->round()->prediction(); }
  const PlayerState& player() const { return prediction().predicted().player(prediction().slot()); }
  // Rows with a focus above this one.
  static std::ptrdiff_t rowsAbove(const std::string& name) {
    Settings settings;
    const std::vector<MenuItem> items = settingsPage(settings, SubPages()).items;
    const auto row = std::find_if(items.begin(), items.end(), [&](const auto& item) { return item.name == name; });
    return std::count_if(items.begin(), row, [](const auto& item) { return item.canHaveFocus(); });
  }

  Image picture_;
  int pictures_ = 0;
};

TEST_F(WindowFrameTest, TheFirstPictureAfterAKeyShowsWhatItDidInTheMenu) {
  options_.level.clear();
  const auto shown = [this] { return pictures_ > 0; };
  Image before;
  Image focus;
  play({{[] {}, [this] { return shows("Quit"); }},
        {[this] { keepNextPicture(); }, shown},
        {[&] {
           before = picture_;
           keepNextPicture();
           tap(GLFW_KEY_DOWN);
         },
         shown},
        {[&] {
           focus = picture_;
           EXPECT_EQ(barOf(focus, 1), barOf(before, 0));
           EXPECT_NE(barOf(focus, 0), barOf(before, 0));
           onPicture = [this] {
             ++pictures_;
             EXPECT_TRUE(shows("Run and jump"));
           };
           pictures_ = 0;
           tap(GLFW_KEY_ENTER);
         },
         shown}});
  EXPECT_TRUE(stepsDone_);
}

// With the lowest limit, in which a picture takes two ticks.
TEST_F(WindowFrameTest, TheNextTickHasAKeyAndTheFirstPictureAfterItShowsTheTick) {
  std::filesystem::create_directories(folder_ / "platon");
  writeText(folder_ / "platon/settings", "frame-cap 30\n");
  std::uint32_t ticks = 0;
  play({{[] {}, [this] { return isOnGround() == std::optional(true) && confirmedTicks() > 30; }},
        {[&] {
           ticks = prediction().predictedTicks();
           pictures_ = 0;
           onPicture = [&] {
             if (++pictures_ > 1) return;
             EXPECT_GT(prediction().predictedTicks(), ticks);
             EXPECT_NE(player().held & Input::kJump, 0);
             EXPECT_GT(player().velocity.y, 0);
           };
           deliver(GLFW_KEY_SPACE);
         },
         [this] { return pictures_ > 0; }},
        {[] { deliver(GLFW_KEY_SPACE, GLFW_RELEASE); }, [] { return true; }}});
  EXPECT_TRUE(stepsDone_);
}

TEST_F(WindowFrameTest, ASettingIsJudgedOnABallThatRunsWhileTheMatchStandsStill) {
  std::uint64_t hash = 0;
  const auto previews = [this] { return desk_->preview() != nullptr; };
  const auto face = [this] { return desk_->preview()->game().world().entities()[0].part; };
  play({{[] {}, [this] { return isOnGround() == std::optional(true); }},
        {[] { tap(GLFW_KEY_ESCAPE); }, [this] { return match()->paused(); }},
        {[&] {
           hash = prediction().confirmed().hash();
           clickOn("Settings");
         },
         [this] { return shows("Full screen"); }},
        {[] {
           tap(GLFW_KEY_DOWN, rowsAbove("Camera turn speed"));
           tap(GLFW_KEY_RIGHT);
         },
         previews},
        {[] {}, [=] { return face() != 0; }},
        {[] {}, [=] { return face() == 0; }},
        {[&] {
           EXPECT_TRUE(match()->paused());
           EXPECT_EQ(prediction().confirmed().hash(), hash);
           tap(GLFW_KEY_DOWN);
         },
         [=] { return !previews(); }}});
  EXPECT_TRUE(stepsDone_);
}

TEST_F(WindowFrameTest, AtTheTitleASettingIsJudgedOnABallThatRuns) {
  options_.level.clear();
  const auto previews = [this] { return desk_->preview() != nullptr; };
  play({{[] {}, [this] { return shows("Quit"); }},
        {[this] { clickOn("Settings"); }, [this] { return shows("Full screen"); }},
        {[] { tap(GLFW_KEY_DOWN, rowsAbove("Zoom")); }, [] { return true; }},
        {[&] {
           EXPECT_FALSE(previews());
           tap(GLFW_KEY_RIGHT);
         },
         previews},
        {[] { tap(GLFW_KEY_ESCAPE); }, [=, this] { return !previews() && shows("Quit"); }}});
  EXPECT_TRUE(stepsDone_);
}

}  // namespace
}  // namespace platon::window_frame_test
