#include "client/gl/game_view.h"

#include <algorithm>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "client/gl/gl_context.h"
#include "tests/client/gl/golden_picture.h"
#include "tests/client/gl/test_stage.h"

namespace platon::game_view_test {
namespace {

constexpr std::uint32_t kWidth = 320;
constexpr std::uint32_t kHeight = 180;
constexpr int kRounding = 1;  // step of a colour

Image drawn(GameView& view, const Scene* scene, const Settings& settings = {}, const Overlay& menu = {}) {
  view.draw(scene, {}, settings, menu, 0.1);
  EXPECT_EQ(takeGlErrors(), "");
  return view.read();
}

class GameViewTest : public testing::Test {
 protected:
  Offscreen context_;
  std::shared_ptr<const StageModel> stage_ = cube();
  Scene scene_ = sceneOf(stage_, {playerAt(*stage_, 0, 0, {30, 20})});
};

TEST_F(GameViewTest, AResizedViewDrawsThePictureOfANewViewOfThatSize) {
  GameView resized(kWidth, kHeight);
  for (const auto& [width, height] : {std::pair(320U, 180U), {1U, 1U}, {641U, 359U}, {400U, 900U}, {1920U, 1080U}}) {
    GameView fresh(width, height);
    resized.resize(width, height);
    const Image expected = drawn(fresh, &scene_);
    ASSERT_EQ(expected.width, width);
    ASSERT_EQ(expected.height, height);
    ASSERT_EQ(expected.pixels.size(), std::size_t{3} * width * height);
    EXPECT_EQ(drawn(resized, &scene_), expected) << width << " × " << height;
  }
}

TEST_F(GameViewTest, TheStageIsInTheMiddleOfEverySize) {
  GameView view(kWidth, kHeight);
  for (const auto& [width, height] : {std::pair(641U, 359U), {400U, 900U}, {1920U, 1080U}}) {
    view.resize(width, height);
    const Image stage = drawn(view, &scene_);
    const Image empty = drawn(view, nullptr);
    const glm::ivec2 corner(2, static_cast<int>(height) - 3);
    const glm::ivec2 left(static_cast<int>(width) / 2 - static_cast<int>(std::min(width, height)) / 5,
                          static_cast<int>(height) / 2);
    EXPECT_EQ(pixel(stage, corner), pixel(empty, corner)) << "background, " << width << " × " << height;
    EXPECT_GT(glm::distance(pixel(stage, left), pixel(empty, left)), 0.1F) << width << " × " << height;
  }
}

TEST_F(GameViewTest, AMinimisedWindowKeepsItsPicture) {
  GameView view(kWidth, kHeight);
  const Image before = drawn(view, &scene_);
  for (const auto& [width, height] : {std::pair(0U, 0U), {0U, 100U}, {100U, 0U}}) {
    view.resize(width, height);
    EXPECT_EQ(drawn(view, &scene_), before);
  }
}

TEST_F(GameViewTest, TheMenuAndTheNetGraphAreDrawnWhenEnabled) {
  GameView view(2 * kWidth, 2 * kHeight);  // where the graph has room
  view.netGraph().add({});
  const Image plain = drawn(view, &scene_);
  Overlay menu;
  menu.panels.push_back({{0, 0}, {400, 400}, 10, {1, 1, 1, 0.5F}});
  EXPECT_NE(drawn(view, &scene_, {}, menu), plain);
  Settings settings;
  settings.netGraph = true;
  EXPECT_NE(drawn(view, &scene_, settings), plain);
  EXPECT_EQ(drawn(view, &scene_), plain);
}

// Also during the flight over the title, in a replay and while there is no game.
TEST_F(GameViewTest, TheNoticeIsInEveryPictureUntilItIsTakenBack) {
  GameView view(2 * kWidth, 2 * kHeight);
  const Camera camera = [&] {
    Camera set;
    set.set(scene_.focus, stage_->mesh, view.width(), view.height());
    return set;
  }();
  const auto drawnBeside = [&] {
    view.drawBeside(scene_, camera, {}, {}, view.screenWidth() / 2);
    return view.read();
  };
  const Image game = drawn(view, &scene_);
  const Image empty = drawn(view, nullptr);
  const Image beside = drawnBeside();
  view.setNotice("picture saved");
  EXPECT_NE(drawn(view, &scene_), game);
  EXPECT_NE(drawn(view, nullptr), empty);
  const Image told = drawnBeside();
  EXPECT_NE(told, beside);
  const auto differsAt = [&](int x) {
    return pixel(told, {x, 2 * kHeight - 20}) != pixel(beside, {x, 2 * kHeight - 20});
  };
  EXPECT_TRUE(differsAt(3 * kWidth / 2)) << "in the middle of the right half";
  for (int x = 0; x < static_cast<int>(kWidth); ++x) EXPECT_FALSE(differsAt(x)) << x;
  view.setNotice("");
  EXPECT_EQ(drawn(view, nullptr), empty);
  EXPECT_EQ(drawnBeside(), beside);
}

TEST_F(GameViewTest, OnAnotherStageTheCameraJumpsToItsTarget) {
  Scene turned = sceneOf(cube());
  turned.focus = turned.stage->mesh.pose(3, {20, 30}, 1);
  GameView fresh(kWidth, kHeight);
  const Image expected = drawn(fresh, &turned);
  GameView view(kWidth, kHeight);
  drawn(view, &scene_);
  // The letters lie elsewhere in the texture, which some drivers round in another way.
  EXPECT_LE(largestDifference(drawn(view, &turned), expected), kRounding);
  EXPECT_NEAR(view.roll(), 0, 1e-3);
}

TEST_F(GameViewTest, OnTheSameStageTheCameraMovesGradually) {
  GameView view(kWidth, kHeight);
  drawn(view, &scene_);
  Scene turned = scene_;
  turned.focus = stage_->mesh.pose(0, {0, 0}, 1);
  drawn(view, &turned);
  EXPECT_GT(view.roll(), 0.3);
  EXPECT_LT(view.roll(), 0.7);
}

TEST_F(GameViewTest, ACutThatFadesBeginsWithThePictureBeforeIt) {
  Settings settings;
  settings.comfort = {.reducedMotion = true, .view = CameraView::kFaceFade};
  Settings cuts = settings;
  cuts.comfort.view = CameraView::kFace;
  Scene beyond = sceneOf(stage_);
  beyond.focus = stage_->mesh.pose(3, {0, 0}, 0);
  GameView view(kWidth, kHeight);
  GameView cutting(kWidth, kHeight);
  const auto middle = [](const Image& image) { return pixel(image, {kWidth / 2, kHeight / 2}); };
  const glm::vec3 before = middle(drawn(view, &scene_, settings));
  drawn(cutting, &scene_, cuts);
  const glm::vec3 after = middle(drawn(cutting, &beyond, cuts));
  ASSERT_GT(glm::distance(before, after), 0.05F);
  EXPECT_LT(glm::distance(middle(drawn(view, &beyond, settings)), before), 0.02F);
  EXPECT_LT(glm::distance(middle(drawn(view, &beyond, settings)), (before + after) / 2.0F), 0.02F) << "after 0.1 s";
  EXPECT_EQ(drawn(view, &beyond, settings), drawn(cutting, &beyond, cuts)) << "after 0.2 s";
}

TEST_F(GameViewTest, TheWholeFaceIsSeenUntilThePlayerBegins) {
  scene_.focus = stage_->mesh.pose(0, {180, 180}, 0);
  GameView usual(kWidth, kHeight);
  const Image expected = drawn(usual, &scene_);
  Scene waiting = scene_;
  waiting.begun = false;
  GameView view(kWidth, kHeight);
  const Image whole = drawn(view, &waiting);
  EXPECT_GT(largestDifference(whole, expected), 50);
  EXPECT_EQ(drawn(view, &waiting), whole);
  for (int frame = 0; frame < 20; ++frame) drawn(view, &scene_);
  EXPECT_LE(largestDifference(drawn(view, &scene_), expected), kRounding);
}

// Both players are near each other, so that one view could show them.
TEST_F(GameViewTest, WhoPlaysOnAloneKeepsItsOwnViewUnlessThePictureWasOne) {
  Scene second = sceneOf(stage_, {playerAt(*stage_, 0, 0, {30, 20}), playerAt(*stage_, 1, 0, {150, 20})});
  for (PlayerDrawing* own : {&scene_.players.back(), &second.players.back()}) own->local = true;
  scene_.focus = scene_.players.back().pose;
  second.focus = second.players.back().pose;
  GameView alone(kWidth, kHeight);
  const Image expected = drawn(alone, &scene_);
  for (const SharedViews views : {SharedViews::kEach, SharedViews::kOne}) {
    Settings settings;
    settings.views = views;
    GameView view(kWidth, kHeight);
    for (int frame = 0; frame < 30; ++frame) view.drawShared(std::vector{scene_, second}, {}, settings, {}, 0.1);
    view.draw(&scene_, {}, settings, {}, 0);
    EXPECT_EQ(largestDifference(view.read(), expected) <= kRounding, views == SharedViews::kEach);
  }
}

}  // namespace
}  // namespace platon::game_view_test
