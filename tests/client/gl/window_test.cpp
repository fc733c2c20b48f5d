#include "client/gl/window.h"

#include <array>
#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <GL/glew.h>
#include <GLFW/glfw3.h>
#include <gtest/gtest.h>
#include <glm/common.hpp>

#include "client/gl/game_view.h"
#include "client/gl/gl_context.h"
#include "client/ui/controls/input_mapper.h"
#include "tests/client/gl/desktop.h"
#include "tests/client/gl/fake_gamepad.h"
#include "tests/client/gl/shown_pictures.h"
#include "tests/support/environment_variable.h"
#include "tests/support/wait_until.h"

// Runs on a virtual display with a window manager (on_display.sh).
namespace platon::window_test {
namespace {

using Kind = KeyEvent::Kind;
using Events = std::vector<KeyEvent>;

constexpr std::uint32_t kScreenWidth = 1280;
constexpr std::uint32_t kScreenHeight = 1024;
constexpr int kWidth = 640;
constexpr int kHeight = 360;

// The events of this kind since the last call.
template <class Event>
std::vector<Event> take(Window& window) {
  std::vector<Event> taken;
  for (const WindowEvent& event : window.takeEvents()) {
    if (const Event* const wanted = std::get_if<Event>(&event)) taken.push_back(*wanted);
  }
  return taken;
}

class WindowTest : public testing::Test {
 protected:
  WindowTest() {
    EXPECT_TRUE(pollUntil([&] { return has(GLFW_FOCUSED); })) << "the window manager does not focus the window";
    take<KeyEvent>(window_);
  }
  ~WindowTest() override { fakeGamepad.reset(); }

  template <class Done>
  bool pollUntil(Done done) {
    return stepUntil([this] { window_.poll(); }, done);
  }
  // The events since the last call, without what was typed.
  Events takeKeys() {
    Events events = take<KeyEvent>(window_);
    std::erase_if(events, [](const KeyEvent& event) { return event.kind == Kind::kCharacter; });
    return events;
  }
  // Polls until there are `count` key events.
  Events pollEvents(std::size_t count) {
    Events events;
    pollUntil([&] {
      for (const KeyEvent& event : takeKeys()) events.push_back(event);
      return events.size() >= count;
    });
    return events;
  }
  bool has(int attribute) const { return glfwGetWindowAttrib(handle_, attribute) == GLFW_TRUE; }
  bool hasSize(std::uint32_t width, std::uint32_t height) const {
    return window_.pixelWidth() == width && window_.pixelHeight() == height;
  }
  // Draws frames until the window shows the picture of the renderer: after a resize, the driver needs a frame to resize
  // its buffers.
  void expectShowsThePicture() {
    Image expected;
    Image shown;
    const auto drawFrame = [&] {
      window_.poll();
      view_.resize(window_.pixelWidth(), window_.pixelHeight());
      view_.draw(nullptr, {.message = "Hello", .warning = false, .help = true}, Settings(), Overlay(), 0);
      view_.present();
      expected = view_.read();
      shown = backBuffer();
      window_.show();
    };
    drawFrame();
    EXPECT_TRUE(stepUntil(drawFrame, [&] { return shown == expected; }));
    EXPECT_EQ(takeGlErrors(), "");
    EXPECT_EQ(expected.width, window_.pixelWidth());
    EXPECT_EQ(expected.height, window_.pixelHeight());
  }

  DesktopWindow window_{"Platon", kWidth, kHeight};
  GLFWwindow* handle_ = glfwGetCurrentContext();
  GameView view_{kWidth, kHeight};
};

TEST_F(WindowTest, OpensWithTheRequestedSizeAndShowsThePicture) {
  EXPECT_TRUE(hasSize(kWidth, kHeight));
  EXPECT_TRUE(take<CloseAsked>(window_).empty());
  expectShowsThePicture();
}

TEST_F(WindowTest, EveryKeyIsDelivered) {
  constexpr std::array<std::pair<const char*, Key>, 17> kKeys{{{"Left", Key::kArrowLeft},
                                                               {"Right", Key::kArrowRight},
                                                               {"Up", Key::kArrowUp},
                                                               {"Down", Key::kArrowDown},
                                                               {"a", Key::kA},
                                                               {"d", Key::kD},
                                                               {"w", Key::kW},
                                                               {"s", Key::kS},
                                                               {"space", Key::kSpace},
                                                               {"Return", Key::kEnter},
                                                               {"r", Key::kR},
                                                               {"Escape", Key::kEscape},
                                                               {"F1", Key::kF1},
                                                               {"F2", Key::kF2},
                                                               {"F3", Key::kF3},
                                                               {"F10", Key::kF10},
                                                               {"F11", Key::kF11}}};
  for (const auto& [name, key] : kKeys) {
    xdotool(std::string("key ") + name);
    EXPECT_EQ(pollEvents(2), (Events{{key, Kind::kPress}, {key, Kind::kRelease}})) << name;
  }
}

TEST_F(WindowTest, TheKeysOfEditorAndReplaysAreDelivered) {
  constexpr std::array<std::pair<const char*, Key>, 8> kKeys{{{"z", Key::kZ},
                                                              {"0", Key::kDigit0},
                                                              {"9", Key::kDigit9},
                                                              {"plus", Key::kPlus},
                                                              {"minus", Key::kMinus},
                                                              {"Delete", Key::kDelete},
                                                              {"Tab", Key::kTab},
                                                              {"Prior", Key::kPageUp}}};
  for (const auto& [name, key] : kKeys) {
    xdotool(std::string("key ") + name);
    // The plus sign may need Shift.
    Events events;
    pollUntil([&] {
      for (const KeyEvent& event : takeKeys()) {
        if (event.key != Key::kShift) events.push_back(event);
      }
      return events.size() >= 2;
    });
    ASSERT_EQ(events.size(), 2U) << name;
    EXPECT_EQ(events[0].key, key) << name;
    EXPECT_EQ(events[1].kind, Kind::kRelease) << name;
  }
}

TEST_F(WindowTest, CtrlAndShiftArePartOfTheEvent) {
  xdotool("keydown ctrl keydown shift key z keyup shift keyup ctrl");
  Events events;
  pollUntil([&] {
    for (const KeyEvent& event : takeKeys()) {
      if (event.key == Key::kZ) events.push_back(event);
    }
    return !events.empty();
  });
  ASSERT_FALSE(events.empty());
  EXPECT_EQ(events.front(), (KeyEvent{Key::kZ, Kind::kPress, false, true, true}));
}

// Each event has the place where the pointer was then, also if it has moved on before the next poll.
TEST_F(WindowTest, TheMouseIsDelivered) {
  int x = 0;
  int y = 0;
  glfwGetWindowPos(handle_, &x, &y);
  const auto to = [&](int dx, int dy) { return std::to_string(x + dx) + " " + std::to_string(y + dy); };
  xdotool("mousemove " + to(100, 50) + " mousedown 1 mousemove " + to(200, 90) + " mouseup 1 click 4");
  std::vector<PointerEvent> events;
  ASSERT_TRUE(pollUntil([&] {
    for (const PointerEvent& event : take<PointerEvent>(window_)) {
      if (event.kind != PointerEvent::Kind::kMove) events.push_back(event);
    }
    return events.size() >= 3;
  }));
  constexpr double kScale = 720.0 / kHeight;
  EXPECT_EQ(events[0].kind, PointerEvent::Kind::kPress);
  EXPECT_EQ(events[0].place, glm::dvec2(100, 50) * kScale);
  EXPECT_EQ(events[1].kind, PointerEvent::Kind::kRelease);
  EXPECT_EQ(events[1].place, glm::dvec2(200, 90) * kScale);
  EXPECT_EQ(events[2].scroll, 1);
}

// Before, a window that opened below the pointer, or came back there, got a movement.
TEST(Window, APointerAtRestDoesNotMoveWhenAWindowComesToLieBelowIt) {
  xdotool("mousemove 640 512");
  DesktopWindow window("Platon", 1200, 900);
  const auto firstMove = [&](const std::string& motion) {
    EXPECT_TRUE(stepUntil([&] { window.poll(); }, [&] { return window.focused(); }));
    xdotool("mousemove_relative " + motion);
    std::optional<glm::dvec2> first;
    EXPECT_TRUE(stepUntil([&] { window.poll(); },
                          [&] {
                            for (const PointerEvent& event : take<PointerEvent>(window)) {
                              if (!first) first = event.place;
                            }
                            return first.has_value();
                          }));
    int x = 0;
    int y = 0;
    glfwGetWindowPos(glfwGetCurrentContext(), &x, &y);
    return glm::round(first.value_or(glm::dvec2()) / (720.0 / 900)) + glm::dvec2(x, y);
  };
  EXPECT_EQ(firstMove("20 10"), glm::dvec2(660, 522));
  window.setFullscreen(true);
  EXPECT_TRUE(stepUntil([&] { window.poll(); }, [&] { return window.pixelHeight() == kScreenHeight; }));
  window.setFullscreen(false);
  EXPECT_TRUE(stepUntil([&] { window.poll(); }, [&] { return window.pixelHeight() == 900; }));
  EXPECT_EQ(firstMove("20 10"), glm::dvec2(680, 532));
}

// Before, a program that draws slowly took all keys of a frame first: a click before a key counted after it. The
// callbacks are called as GLFW does: a window manager may hold back a click.
TEST_F(WindowTest, KeysAndMouseAreDeliveredInTheirOrder) {
  const GLFWkeyfun key = glfwSetKeyCallback(handle_, nullptr);
  glfwSetKeyCallback(handle_, key);
  const GLFWmousebuttonfun button = glfwSetMouseButtonCallback(handle_, nullptr);
  glfwSetMouseButtonCallback(handle_, button);
  window_.takeEvents();
  for (int i = 0; i < 2; ++i) {
    button(handle_, GLFW_MOUSE_BUTTON_LEFT, GLFW_PRESS, 0);
    key(handle_, GLFW_KEY_F1, 0, GLFW_PRESS, 0);
  }
  const std::vector<WindowEvent> events = window_.takeEvents();
  ASSERT_EQ(events.size(), 4U);
  for (std::size_t i = 0; i < events.size(); ++i) EXPECT_EQ(std::holds_alternative<KeyEvent>(events[i]), i % 2 == 1);
}

TEST_F(WindowTest, EachButtonOfTheMouseIsDelivered) {
  using Button = PointerEvent::Button;
  int x = 0;
  int y = 0;
  glfwGetWindowPos(handle_, &x, &y);
  xdotool("mousemove " + std::to_string(x + 100) + " " + std::to_string(y + 50) + " click 1 click 2 click 3 click 8");
  std::vector<Button> pressed;
  ASSERT_TRUE(pollUntil([&] {
    for (const PointerEvent& event : take<PointerEvent>(window_)) {
      if (event.kind == PointerEvent::Kind::kPress) pressed.push_back(event.button);
    }
    return pressed.size() >= 4;
  }));
  EXPECT_EQ(pressed, (std::vector{Button::kLeft, Button::kMiddle, Button::kRight, Button::kBack}));
}

TEST_F(WindowTest, OtherKeysAreIgnored) {
  xdotool("key Pause Scroll_Lock space");
  EXPECT_EQ(pollEvents(2), (Events{{Key::kSpace, Kind::kPress}, {Key::kSpace, Kind::kRelease}}));
}

TEST_F(WindowTest, AltIsPartOfTheEvent) {
  xdotool("key alt+Return");
  const Events events = pollEvents(2);
  ASSERT_GE(events.size(), 2U);
  EXPECT_EQ(events[0].key, Key::kAlt);
  EXPECT_EQ(events[1], (KeyEvent{Key::kEnter, Kind::kPress, true}));
}

TEST_F(WindowTest, WhatIsTypedIsDeliveredInOrderWithTheKeys) {
  xdotool("key a BackSpace shift+b");
  std::u32string typed;
  bool erased = false;
  EXPECT_TRUE(pollUntil([&] {
    for (const KeyEvent& event : take<KeyEvent>(window_)) {
      if (event.kind == Kind::kCharacter) typed += event.character;
      erased = erased || (event.key == Key::kBackspace && event.kind == Kind::kPress && typed == U"a");
    }
    return typed.size() == 2;
  }));
  EXPECT_EQ(typed, U"aB");
  EXPECT_TRUE(erased);
}

TEST_F(WindowTest, ReadsTheClipboard) {
  glfwSetClipboardString(handle_, "host:7777");
  EXPECT_EQ(window_.clipboard(), "host:7777");
}

TEST_F(WindowTest, AHeldKeyRepeats) {
  xdotool("keydown Down");
  const Events events = pollEvents(3);
  xdotool("keyup Down");
  ASSERT_GE(events.size(), 3U);
  EXPECT_EQ(events[0], (KeyEvent{Key::kArrowDown, Kind::kPress}));
  EXPECT_EQ(events[1], (KeyEvent{Key::kArrowDown, Kind::kRepeat}));
  EXPECT_EQ(events[2], (KeyEvent{Key::kArrowDown, Kind::kRepeat}));
}

TEST_F(WindowTest, AKeyTapShorterThanAFrameIsNotLost) {
  xdotool("key space");  // pressed and released before the next poll
  InputMapper mapper;
  for (const KeyEvent& event : pollEvents(2)) mapper.handle(event, false);
  EXPECT_TRUE(mapper.takeHeld().jump);
  EXPECT_FALSE(mapper.takeHeld().jump);
}

TEST_F(WindowTest, EveryGamepadButtonIsDelivered) {
  constexpr std::array<std::pair<int, Key>, 7> kButtons{{{GLFW_GAMEPAD_BUTTON_DPAD_LEFT, Key::kPadLeft},
                                                         {GLFW_GAMEPAD_BUTTON_DPAD_RIGHT, Key::kPadRight},
                                                         {GLFW_GAMEPAD_BUTTON_DPAD_UP, Key::kPadUp},
                                                         {GLFW_GAMEPAD_BUTTON_DPAD_DOWN, Key::kPadDown},
                                                         {GLFW_GAMEPAD_BUTTON_A, Key::kPadA},
                                                         {GLFW_GAMEPAD_BUTTON_START, Key::kPadStart},
                                                         {GLFW_GAMEPAD_BUTTON_BACK, Key::kPadBack}}};
  for (const auto& [button, key] : kButtons) {
    fakeGamepad.emplace().buttons[button] = GLFW_PRESS;
    window_.poll();
    EXPECT_EQ(take<KeyEvent>(window_), (Events{{key, Kind::kPress}}));
    fakeGamepad.emplace();
    window_.poll();
    EXPECT_EQ(take<KeyEvent>(window_), (Events{{key, Kind::kRelease}}));
  }
}

TEST_F(WindowTest, TheLeftStickIsDelivered) {
  constexpr std::array<std::pair<std::pair<int, float>, Key>, 4> kDirections{
      {{{GLFW_GAMEPAD_AXIS_LEFT_X, -1}, Key::kPadLeft},
       {{GLFW_GAMEPAD_AXIS_LEFT_X, 1}, Key::kPadRight},
       {{GLFW_GAMEPAD_AXIS_LEFT_Y, -1}, Key::kPadUp},
       {{GLFW_GAMEPAD_AXIS_LEFT_Y, 1}, Key::kPadDown}}};
  for (const auto& [deflection, key] : kDirections) {
    fakeGamepad.emplace().axes[deflection.first] = deflection.second;
    window_.poll();
    EXPECT_EQ(take<KeyEvent>(window_), (Events{{key, Kind::kPress}}));
    fakeGamepad.reset();
    window_.poll();
    EXPECT_EQ(take<KeyEvent>(window_), (Events{{key, Kind::kRelease}})) << "the gamepad was disconnected";
  }
}

TEST_F(WindowTest, AGamepadIsLostWhenItIsUnplugged) {
  fakeGamepad.emplace();
  window_.poll();
  fakeGamepad.reset();
  window_.poll();
  EXPECT_TRUE(take<GamepadLost>(window_).empty()) << "it was not used";
  fakeGamepad.emplace().buttons[GLFW_GAMEPAD_BUTTON_A] = GLFW_PRESS;
  window_.poll();
  fakeGamepad.reset();
  window_.poll();
  const std::vector<WindowEvent> events = window_.takeEvents();
  ASSERT_EQ(events.size(), 3U);
  EXPECT_EQ(std::get<KeyEvent>(events[0]), (KeyEvent{Key::kPadA, Kind::kPress}));
  EXPECT_EQ(std::get<KeyEvent>(events[1]), (KeyEvent{Key::kPadA, Kind::kRelease}));
  EXPECT_TRUE(std::holds_alternative<GamepadLost>(events[2]));
}

TEST_F(WindowTest, AResizedWindowShowsAPictureOfItsSize) {
  xdotool("getactivewindow windowsize 800 500");
  ASSERT_TRUE(pollUntil([&] { return hasSize(800, 500); }));
  expectShowsThePicture();
}

TEST_F(WindowTest, FullScreenCoversTheScreenAndThenRestoresTheFormerPosition) {
  xdotool("getactivewindow windowmove 100 80");
  int x = 0;
  int y = 0;
  ASSERT_TRUE(pollUntil([&] {
    glfwGetWindowPos(handle_, &x, &y);
    return x >= 100 && y >= 80;
  }));
  window_.setFullscreen(true);
  ASSERT_TRUE(pollUntil([&] { return hasSize(kScreenWidth, kScreenHeight); }));
  expectShowsThePicture();
  window_.setFullscreen(true);
  window_.setFullscreen(false);
  EXPECT_TRUE(pollUntil([&] {
    int formerX = 0;
    int formerY = 0;
    glfwGetWindowPos(handle_, &formerX, &formerY);
    return hasSize(kWidth, kHeight) && formerX == x && formerY == y;
  }));
  expectShowsThePicture();
}

TEST_F(WindowTest, AWindowWithoutFocusReleasesItsKeysAndGetsNoOthers) {
  xdotool("keydown Right");
  ASSERT_FALSE(pollEvents(1).empty());
  GLFWwindow* const other = glfwCreateWindow(200, 200, "other", nullptr, nullptr);
  ASSERT_NE(other, nullptr);
  glfwSetInputMode(other, GLFW_STICKY_KEYS, GLFW_TRUE);
  // Key repeat may come first.
  const KeyEvent release{Key::kArrowRight, Kind::kRelease};
  EXPECT_TRUE(pollUntil([&] {
    const Events events = take<KeyEvent>(window_);
    return !events.empty() && events.back() == release;
  }));
  ASSERT_TRUE(pollUntil([&] { return glfwGetWindowAttrib(other, GLFW_FOCUSED) == GLFW_TRUE; }));
  xdotool("keyup Right key space");
  ASSERT_TRUE(pollUntil([&] { return glfwGetKey(other, GLFW_KEY_SPACE) == GLFW_PRESS; }));
  glfwDestroyWindow(other);
  ASSERT_TRUE(pollUntil([&] { return has(GLFW_FOCUSED); }));
  EXPECT_EQ(take<KeyEvent>(window_), Events());
}

TEST_F(WindowTest, AMinimisedWindowContinuesAndIsRestored) {
  xdotool("getactivewindow windowminimize");
  ASSERT_TRUE(pollUntil([&] { return has(GLFW_ICONIFIED); }));
  for (int frame = 0; frame < 3; ++frame) {
    window_.poll();
    view_.resize(window_.pixelWidth(), window_.pixelHeight());
    view_.draw(nullptr, {}, Settings(), Overlay(), 0);
    view_.present();
    window_.show();
    EXPECT_EQ(takeGlErrors(), "");
  }
  EXPECT_TRUE(take<CloseAsked>(window_).empty());
  glfwRestoreWindow(handle_);
  ASSERT_TRUE(pollUntil([&] { return !has(GLFW_ICONIFIED) && has(GLFW_FOCUSED) && hasSize(kWidth, kHeight); }));
  expectShowsThePicture();
  xdotool("key space");
  EXPECT_EQ(pollEvents(2), (Events{{Key::kSpace, Kind::kPress}, {Key::kSpace, Kind::kRelease}}));
}

// The callback is called as GLFW does: xdotool cannot drop files.
TEST_F(WindowTest, DroppedFilesAreTakenOnceInOrder) {
  GLFWwindow* const handle = glfwGetCurrentContext();
  const GLFWdropfun drop = glfwSetDropCallback(handle, nullptr);
  glfwSetDropCallback(handle, drop);
  std::array<const char*, 2> paths{"/a b", "/c"};
  drop(handle, 2, paths.data());
  drop(handle, 1, paths.data());
  const std::vector<FilesDropped> dropped = take<FilesDropped>(window_);
  ASSERT_EQ(dropped.size(), 2U);
  EXPECT_EQ(dropped[0].paths, (std::vector<std::string>{"/a b", "/c"}));
  EXPECT_EQ(dropped[1].paths, (std::vector<std::string>{"/a b"}));
  EXPECT_TRUE(window_.takeEvents().empty());
}

TEST_F(WindowTest, TheWindowManagerAsksToCloseTheWindowWhichStaysOpen) {
  xdotool("key alt+F4");
  EXPECT_TRUE(pollUntil([&] { return !take<CloseAsked>(window_).empty(); }));
  EXPECT_EQ(glfwWindowShouldClose(handle_), GLFW_FALSE);
}

TEST(Window, WithoutADisplayTheReasonIsStated) {
  const EnvironmentVariable noDisplay("DISPLAY", std::nullopt);
  try {
    const DesktopWindow window("Platon", kWidth, kHeight);
    ADD_FAILURE() << "a window opened";
  } catch (const std::runtime_error& error) {
    EXPECT_EQ(std::string(error.what()).find("cannot open a window: "), 0U) << error.what();
  }
}

}  // namespace
}  // namespace platon::window_test
