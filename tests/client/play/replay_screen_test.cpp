#include "client/play/replay_screen.h"

#include <algorithm>
#include <string>

#include <gtest/gtest.h>

#include "client/gl/gl_context.h"
#include "tests/support/files.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/wait_until.h"

namespace platon::replay_screen_test {
namespace {

constexpr const char* kRecording = "tests/determinism/golden/hexahedron.recording";

// Waits until the file has been read.
void waitForRead(ReplayPlay& play) {
  EXPECT_TRUE(waitUntil([&] {
    play.advance(0);
    return play.viewer() != nullptr || !play.fault().empty();
  }));
}

bool isEmpty(const Image& image) {
  return std::all_of(image.pixels.begin(), image.pixels.end(), [&](auto value) { return value == image.pixels[0]; });
}

TEST(ReplayPlay, PlaysWhenTheFileHasBeenRead) {
  ReplayPlay play(kRecording);
  play.handle(KeyEvent{.key = Key::kSpace});
  EXPECT_EQ(play.viewer(), nullptr) << "still being read";
  waitForRead(play);
  ASSERT_NE(play.viewer(), nullptr);
  EXPECT_EQ(play.readingText(), "reading hexahedron.recording … 99 %");
  for (int i = 0; i < 4; ++i) play.advance(0.05);
  EXPECT_EQ(play.viewer()->player().tick(), 12U);
  play.advance(1);
  EXPECT_EQ(play.viewer()->player().tick(), 18U) << "one slow picture does not make the next one slower";
  play.handle(KeyEvent{.key = Key::kSpace});
  EXPECT_TRUE(play.viewer()->player().paused());
  EXPECT_EQ(play.fault(), "");
}

TEST(ReplayPlay, EscapeAndTheGamepadLeaveAlsoWhileTheFileIsRead) {
  for (const Key key : {Key::kEscape, Key::kPadB, Key::kPadStart}) {
    ReplayPlay play(kRecording);
    EXPECT_FALSE(play.handle(KeyEvent{.key = Key::kTab}));
    EXPECT_FALSE(play.handle(KeyEvent{.key = key, .kind = KeyEvent::Kind::kRelease}));
    EXPECT_TRUE(play.handle(KeyEvent{.key = key}));
  }
}

TEST(ReplayPlay, TheMouseLeaves) {
  const Offscreen offscreen;
  const GameView view(320, 180);
  for (const PointerEvent::Button button : {PointerEvent::Button::kRight, PointerEvent::Button::kBack}) {
    ReplayPlay play(kRecording);
    EXPECT_FALSE(play.handle({.kind = PointerEvent::Kind::kRelease, .button = button}, view, Settings()));
    EXPECT_TRUE(play.handle({.kind = PointerEvent::Kind::kPress, .button = button}, view, Settings()));
  }
}

TEST(ReplayPlay, AFaultSaysWhyTheFileCannotBePlayed) {
  const TemporaryFolder folder;
  writeText(folder / "text", "no recording");
  ReplayPlay play(folder / "text");
  waitForRead(play);
  EXPECT_EQ(play.viewer(), nullptr);
  EXPECT_EQ(play.fault(),
            (folder / "text").string() + ": cannot be played: byte 0: not a recording, or an unsupported version");
}

TEST(ReplayPlay, DrawsBeforeAndAfterTheFileHasBeenRead) {
  const Offscreen offscreen;
  GameView view(320, 180);
  ReplayPlay play(kRecording);
  play.draw(view, Settings(), 0);
  const Image reading = view.read();
  EXPECT_FALSE(isEmpty(reading));
  waitForRead(play);
  play.draw(view, Settings(), 0);
  EXPECT_NE(view.read().pixels, reading.pixels);
}

TEST(ReplayPlay, AtTheGoalTheMedalIsShown) {
  const Offscreen offscreen;
  ReplayPlay play("levels/data/ways/01_run_and_jump.recording");
  waitForRead(play);
  const auto pictureOf = [&play](double seconds, const ReplayContext& context) {
    GameView view(640, 360);
    play.skipTo(seconds);
    play.draw(view, Settings(), 0, context);
    return view.read().pixels;
  };
  const ReplayContext rated{.medals = MedalTimes{1, 2, 3}};
  EXPECT_EQ(pictureOf(0.5, rated), pictureOf(0.5, {}));
  EXPECT_NE(pictureOf(60, rated), pictureOf(60, {}));
}

}  // namespace
}  // namespace platon::replay_screen_test
