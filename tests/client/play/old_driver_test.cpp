// What the program says on a driver without OpenGL 3.3. Mesa looks only once whether it has to behave like one.
#include <memory>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

#include "client/gl/gl_context.h"
#include "client/gl/window.h"
#include "client/play/offscreen/offscreen_play.h"
#include "client/play/screen.h"
#include "client/time/steady_now.h"
#include "protocol/program_error.h"
#include "tests/support/environment_variable.h"
#include "tests/support/files.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/wait_until.h"

// Runs on a virtual display with a window manager (on_display.sh).
namespace platon::old_driver_test {
namespace {

const EnvironmentVariable kOldVersion("MESA_GL_VERSION_OVERRIDE", "2.1");
constexpr const char* kText = "the graphics driver has no OpenGL 3.3: update it, or start with LIBGL_ALWAYS_SOFTWARE=1";

template <class Open>
std::string reasonOf(Open open) {
  try {
    open();
  } catch (const NoOpenGl& error) {
    return error.what();
  } catch (const std::runtime_error& error) {
    return std::string("another error: ") + error.what();
  }
  return "opened";
}

// As soon as the recording has been read.
std::unique_ptr<OffscreenReplay> readToEnd(const ClientOptions& options) {
  auto replay = std::make_unique<OffscreenReplay>(options, Settings(), steadyClock().now());
  EXPECT_TRUE(waitUntil([&] { return replay->read(steadyClock().now()); }));
  return replay;
}

TEST(OldDriver, AWindowTellsThatOpenGl33IsMissing) {
  EXPECT_EQ(reasonOf([] { const DesktopWindow window("Platon", 640, 360); }), kText);
}

TEST(OldDriver, OffScreenTheReasonIsTheSame) {
  EXPECT_EQ(reasonOf([] { const Offscreen context; }), kText);
}

// A damaged recording is the fault, whatever the driver.
TEST(OldDriver, OffScreenARecordingIsReadBefore) {
  const TemporaryFolder folder;
  ClientOptions options;
  options.offscreen = true;
  options.replay = (folder / "text").string();
  writeText(options.replay, "no recording");
  try {
    readToEnd(options);
    FAIL() << "read";
  } catch (const ProgramError& error) {
    EXPECT_EQ(error.exitCode(), ProgramError::kInvalid);
  }
  options.replay = "tests/determinism/golden/hexahedron.recording";
  EXPECT_EQ(reasonOf([&] { readToEnd(options)->draw(); }), kText);
}

TEST(OldDriver, TheProgramDoesNotAdviseToDrawOffScreen) {
  try {
    openWindow("use --offscreen");
    FAIL() << "opened";
  } catch (const ProgramError& error) {
    EXPECT_EQ(error.exitCode(), ProgramError::kFailed);
    EXPECT_STREQ(error.what(), kText);
  }
}

}  // namespace
}  // namespace platon::old_driver_test
