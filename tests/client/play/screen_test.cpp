#include "client/play/screen.h"

#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "protocol/program_error.h"
#include "tests/support/environment_variable.h"

// Runs on a virtual display with a window manager (on_display.sh).
namespace platon::screen_test {
namespace {

// Notes what it is asked to do, by its name, and wants what the test has set.
class FakeScreen : public Screen {
 public:
  FakeScreen(std::string name, std::vector<std::string>& log) : name_(std::move(name)), log_(&log) {}

  Next handle(const WindowEvent& /*event*/) override { return note("handle"); }
  Next update(const Frame& /*frame*/) override { return note("update"); }
  void draw(const Frame& /*frame*/) override { note("draw"); }
  Time frameTime() const override { return kCalmFrameTime; }
  Image read() const override { return {}; }
  bool updateBehind(const Frame& /*frame*/) override {
    note("behind");
    return returns;
  }
  Next reveal(const Ending& ending) override {
    const auto* const end = std::get_if<ReplayEnd>(&ending);
    return note(end == nullptr ? "reveal" : "reveal " + end->file.string());
  }
  void leave() override { note("leave"); }

  Next next;
  bool returns = false;

 private:
  Next note(const std::string& what) {
    log_->push_back(name_ + " " + what);
    return std::exchange(next, Stay());
  }

  std::string name_;
  std::vector<std::string>* log_;
};

using Log = std::vector<std::string>;

class ScreenStackTest : public testing::Test {
 protected:
  ScreenStackTest() {
    auto first = std::make_unique<FakeScreen>("first", log_);
    first_ = first.get();
    screens_.emplace(std::move(first));
  }

  // The next event makes the front screen want this.
  void want(FakeScreen& screen, Next next) {
    screen.next = std::move(next);
    screens_->handle(KeyEvent());
  }
  FakeScreen& push(const std::string& name) {
    auto screen = std::make_unique<FakeScreen>(name, log_);
    FakeScreen& pushed = *screen;
    want(*first_, Push{std::move(screen)});
    log_.clear();
    return pushed;
  }

  Log log_;
  FakeScreen* first_ = nullptr;
  std::optional<ScreenStack> screens_;
};

TEST_F(ScreenStackTest, EventsAndFramesGoToTheFront) {
  push("second");
  screens_->handle(KeyEvent());
  screens_->update({});
  screens_->draw({});
  EXPECT_EQ(log_, (Log{"second handle", "first behind", "second update", "second draw"}));
  EXPECT_EQ(screens_->frameTime(), kCalmFrameTime);
}

TEST_F(ScreenStackTest, AScreenThatClosesTellsTheOneBehindItHowItHasEnded) {
  FakeScreen& second = push("second");
  want(second, Close{ReplayEnd{"run"}});
  EXPECT_EQ(log_, (Log{"second handle", "second leave", "first reveal run"}));
  EXPECT_TRUE(screens_->isOpen());
}

TEST_F(ScreenStackTest, WhatTheRevealedScreenWantsIsDoneAtOnce) {
  FakeScreen& second = push("second");
  first_->next = Push{std::make_unique<FakeScreen>("third", log_)};
  want(second, Close());
  screens_->draw({});
  EXPECT_EQ(log_.back(), "third draw");
}

TEST_F(ScreenStackTest, AReplacedScreenLeavesWithoutAWordToTheOneBehind) {
  FakeScreen& second = push("second");
  want(second, Replace{std::make_unique<FakeScreen>("third", log_)});
  screens_->draw({});
  EXPECT_EQ(log_, (Log{"second handle", "second leave", "third draw"}));
}

TEST_F(ScreenStackTest, AScreenBehindComesToTheFrontWhenItHasTo) {
  push("second");
  first_->returns = true;
  screens_->update({});
  EXPECT_EQ(log_, (Log{"first behind", "second leave", "first reveal", "first update"}));
}

TEST_F(ScreenStackTest, AfterTheLastScreenNothingIsShown) {
  want(*first_, Close());
  EXPECT_FALSE(screens_->isOpen());
  log_.clear();
  screens_->handle(KeyEvent());
  screens_->update({});
  screens_->draw({});
  EXPECT_EQ(log_, Log());
}

TEST_F(ScreenStackTest, WhoQuitsIsClosedAtTheEndFromTheFrontToTheBack) {
  FakeScreen& second = push("second");
  want(second, Quit());
  EXPECT_FALSE(screens_->isOpen());
  screens_->update({});
  screens_->close();
  EXPECT_EQ(log_, (Log{"second handle", "second leave", "first leave"}));
}

TEST_F(ScreenStackTest, AnErrorWithWhichAScreenQuitsIsThrown) {
  EXPECT_THROW(want(*first_, Quit{ProgramError(ProgramError::kInvalid, "no level")}), ProgramError);
}

TEST(PlayWindow, AFrameTakesAsLongAsTheCapSaysAndLongerInACalmWindow) {
  using std::chrono::microseconds;
  EXPECT_EQ(frameTimeOf(false, 0), kMinFrameTime) << "no cap";
  EXPECT_EQ(frameTimeOf(false, 0.5), kMinFrameTime);
  EXPECT_EQ(frameTimeOf(false, 50), microseconds(20'000));
  EXPECT_EQ(frameTimeOf(false, 1), microseconds(1'000'000));
  EXPECT_EQ(frameTimeOf(false, 1000), kMinFrameTime) << "a cap above what a driver may draw";
  EXPECT_EQ(frameTimeOf(true, 0), microseconds(33'333));
  EXPECT_EQ(frameTimeOf(true, 1000), microseconds(33'333));
}

// The window manager may take room for a frame.
TEST(PlayWindow, IsAtMostOfTheSizeOfThePicture) {
  const DesktopWindow window = openWindow("");
  EXPECT_GT(window.pixelWidth(), kPictureWidth / 2);
  EXPECT_LE(window.pixelWidth(), kPictureWidth);
  EXPECT_LE(window.pixelHeight(), kPictureHeight);
}

TEST(PlayWindow, WithoutADisplayItSaysWhatCanBeDone) {
  const EnvironmentVariable noDisplay("DISPLAY", std::nullopt);
  try {
    openWindow("use --offscreen");
    FAIL() << "opened";
  } catch (const ProgramError& error) {
    EXPECT_EQ(error.exitCode(), ProgramError::kUsage);
    const std::string text = error.what();
    EXPECT_EQ(text.substr(0, 22), "cannot open a window: ");
    EXPECT_TRUE(text.ends_with("; use --offscreen")) << text;
  }
}

}  // namespace
}  // namespace platon::screen_test
