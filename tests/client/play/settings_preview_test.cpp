#include "client/play/settings_preview.h"

#include <algorithm>
#include <cstdint>
#include <functional>
#include <vector>

#include <gtest/gtest.h>

#include "client/gl/gl_context.h"

namespace platon::settings_preview_test {
namespace {

constexpr double kFrame = 1.0 / 30;

std::uint32_t faceOf(const SettingsPreview& preview) { return preview.game().world().entities()[0].part; }

// Longer than a round, which takes five minutes.
TEST(SettingsPreview, TheBallRunsOverAnEdgeAndBackForEver) {
  SettingsPreview preview;
  std::vector<std::uint32_t> faces{faceOf(preview)};
  double longest = 0;  // on a face
  double stay = 0;
  for (int frame = 0; frame < 30 * 60 * 11; ++frame) {
    preview.advance(Settings(), kFrame);
    stay += kFrame;
    if (faceOf(preview) == faces.back()) continue;
    longest = std::max(longest, stay);
    stay = 0;
    faces.push_back(faceOf(preview));
  }
  ASSERT_GT(faces.size(), 400U);
  EXPECT_LT(longest, 3);
  EXPECT_LT(stay, 3);
  for (std::size_t i = 0; i < faces.size(); ++i) EXPECT_EQ(faces[i], i % 2) << i;
}

TEST(SettingsPreview, RunsAtTheGameSpeedOfTheSettings) {
  SettingsPreview preview;
  Settings settings;
  const std::uint32_t start = preview.game().tick();
  for (int frame = 0; frame < 30; ++frame) preview.advance(settings, kFrame);
  EXPECT_NEAR(preview.game().tick() - start, 60, 1);
  settings.gameSpeed = 50;
  for (int frame = 0; frame < 30; ++frame) preview.advance(settings, kFrame);
  EXPECT_NEAR(preview.game().tick() - start, 90, 1);
  settings.gameSpeed = 100;
  preview.advance(settings, 10);
  EXPECT_NEAR(preview.game().tick() - start, 90 + SettingsPreview::kMaxTicks, 1);
}

// The picture soon after a crossing, which the edge still tells.
Image pictureWith(const std::function<void(Settings&)>& change) {
  Settings settings;
  change(settings);
  GameView view(640, 360);
  SettingsPreview preview;
  for (int frame = 0; frame < 24; ++frame) {
    preview.advance(settings, kFrame);
    preview.draw(view, settings, KeyHints(), Overlay(), kFrame);
  }
  return view.read();
}

TEST(SettingsPreview, ThePictureShowsWhatTheSettingsSay) {
  const Offscreen offscreen;
  const Image plain = pictureWith([](Settings&) {});
  EXPECT_EQ(pictureWith([](Settings&) {}), plain);
  const std::vector<std::function<void(Settings&)>> changes{
      [](Settings& settings) { settings.zoom = 1.5; },
      [](Settings& settings) { settings.uiScale = 1.75; },
      [](Settings& settings) { settings.faceNumbers = true; },
      [](Settings& settings) { settings.ball.colour = 3; },
      [](Settings& settings) { settings.comfort.view = CameraView::kFace; },
      [](Settings& settings) { settings.comfort.turnRate = 2; },
      [](Settings& settings) { settings.comfort.instantCut = true; },
      [](Settings& settings) { settings.comfort.reducedMotion = true; },
      [](Settings& settings) { settings.flashes = false; },
      [](Settings& settings) { settings.highContrast = true; },
      [](Settings& settings) { settings.timer = false; },
      [](Settings& settings) { settings.netGraph = true; },
      [](Settings& settings) { settings.gameSpeed = 50; }};
  for (std::size_t i = 0; i < changes.size(); ++i) EXPECT_NE(pictureWith(changes[i]), plain) << i;
}

}  // namespace
}  // namespace platon::settings_preview_test
