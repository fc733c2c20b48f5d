#include "client/play/settings_preview.h"

#include <algorithm>
#include <cstdint>
#include <initializer_list>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include <gtest/gtest.h>

#include "client/gl/gl_context.h"
#include "client/ui/setting_table.h"

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
Image pictureWith(const Settings& settings) {
  GameView view(640, 360);
  SettingsPreview preview;
  for (int frame = 0; frame < 24; ++frame) {
    preview.advance(settings, kFrame);
    preview.draw(view, settings, KeyHints(), Overlay(), kFrame);
  }
  return view.read();
}

// Gives a setting a value that is not its default.
struct OtherValue {
  const Setting& setting;
  Settings& settings;

  void operator()(const SettingFlag& flag) const { flag.member.in(settings) = !flag.member.of(settings); }
  void operator()(const SettingNumber& number) const {
    number.member.in(settings) = number.member.of(settings) == number.max ? number.min : number.max;
  }
  void operator()(const SettingWords& words) const { words.choose(settings, words.words.size() - 1); }
  void operator()(QualityPart) const { read({"low", "0.5", "2"}); }
  void operator()(SettingMember<UntoldElements>) const { read({"none"}); }
  void operator()(const SettingText&) const { read({"https://example.org/list"}); }

  void read(std::initializer_list<std::string_view> values) const {
    EXPECT_TRUE(std::any_of(values.begin(), values.end(), [this](std::string_view value) {
      return readSetting(setting, value, settings);
    })) << setting.name;
  }
};

Settings changed(const Setting& setting, Settings settings = {}) {
  std::visit(OtherValue{setting, settings}, setting.value);
  return settings;
}

TEST(SettingsPreview, ThePictureDependsOnTheSettingsThatAreJudgedInMotionAndOnNoOther) {
  const Offscreen offscreen;
  const Image plain = pictureWith({});
  EXPECT_TRUE(pictureWith({}) == plain);
  Settings others;
  for (const Setting& setting : settingTable()) {
    if (setting.inMotion)
      EXPECT_TRUE(pictureWith(changed(setting)) != plain) << setting.name << " is inMotion, but changes no picture";
    else
      others = changed(setting, others);
  }
  if (pictureWith(others) == plain) return;
  ADD_FAILURE() << "a setting that is not inMotion changes the picture:";
  for (const Setting& setting : settingTable())
    EXPECT_TRUE(setting.inMotion || pictureWith(changed(setting)) == plain) << setting.name;
}

}  // namespace
}  // namespace platon::settings_preview_test
