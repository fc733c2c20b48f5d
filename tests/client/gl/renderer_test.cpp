#include "client/gl/renderer.h"

#include <array>
#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "client/gl/game_view.h"
#include "client/gl/gl_context.h"
#include "client/scene/walls.h"
#include "tests/client/gl/render_fixture.h"
#include "tests/client/gl/test_stage.h"

namespace platon::renderer_test {
namespace {

TEST_F(RenderTest, EqualScenesGiveEqualBytes) {
  const auto stage = cube();
  const Scene scene = sceneOf(stage, {playerAt(*stage, 0, 0, {30, 20})});
  const Image first = draw(scene);
  EXPECT_EQ(draw(scene), first);
}

TEST(Render, AnotherContextGivesEqualBytes) {
  const auto stage = stageOf("ICOSAHEDRON", 20, "");
  const Scene scene = sceneOf(stage, {playerAt(*stage, 4, 0, {30, 20})});
  std::array<Image, 2> images;
  for (Image& image : images) {
    const Offscreen context;
    GameView view(kWidth, kHeight);
    view.draw(&scene, {.message = "Hello", .warning = false, .help = true}, Settings(), Overlay(), 0.1);
    EXPECT_EQ(takeGlErrors(), "");
    image = view.read();
  }
  EXPECT_EQ(images[0], images[1]);
}

// Two views side by side are the pictures that each camera sees alone, with a gap between them.
TEST_F(RenderTest, EachOfSeveralViewsShowsWhatItsCameraSees) {
  const auto stage = cube();
  const std::array scenes{sceneOf(stage, {playerAt(*stage, 0, 0, {30, 20})}),
                          sceneOf(stage, {playerAt(*stage, 1, 2, {-60, 40})})};
  constexpr std::uint32_t kPart = kWidth / 2 - 2;
  std::array<Camera, 2> cameras;
  std::array<Image, 2> alone;
  for (std::size_t i = 0; i < 2; ++i) {
    cameras[i].set(scenes[i].focus, stage->mesh, kPart, kHeight);
    Renderer single(kPart, kHeight, font_);
    single.draw(scenes[i], cameras[i], {}, kStill);
    alone[i] = single.read();
  }
  const std::array views{SceneView{&scenes[0], &cameras[0], {0, 0}},
                         SceneView{&scenes[1], &cameras[1], {kWidth - kPart, 0}}};
  renderer_.draw(views, {}, kStill);
  EXPECT_EQ(takeGlErrors(), "");
  const Image both = renderer_.read();
  for (int y = 0; y < static_cast<int>(kHeight); y += 7) {
    for (int x = 0; x < static_cast<int>(kPart); x += 7) {
      EXPECT_EQ(pixel(both, {x, y}), pixel(alone[0], {x, y})) << x << " " << y;
      EXPECT_EQ(pixel(both, {x + static_cast<int>(kWidth - kPart), y}), pixel(alone[1], {x, y})) << x << " " << y;
    }
    EXPECT_EQ(pixel(both, {static_cast<int>(kWidth / 2), y}), glm::vec3(0)) << "the gap";
  }
}

TEST_F(RenderTest, EverySolidCoversTheMiddleButNotTheCorners) {
  const std::array<std::pair<const char*, int>, 5> solids{
      {{"TETRAHEDRON", 4}, {"HEXAHEDRON", 6}, {"OCTAHEDRON", 8}, {"DODECAHEDRON", 12}, {"ICOSAHEDRON", 20}}};
  for (const auto& [name, faces] : solids) {
    const Scene scene = sceneOf(stageOf(name, faces, ""));
    const Image image = draw(scene);
    const Image empty = drawEmpty();
    for (const int x : {-20, 0, 20}) {
      const glm::ivec2 at(static_cast<int>(kWidth / 2) + x, kHeight / 2);
      EXPECT_GT(glm::distance(pixel(image, at), pixel(empty, at)), 0.1F) << name;
    }
    EXPECT_EQ(pixel(image, {1, 1}), pixel(empty, {1, 1})) << name;
  }
}

TEST_F(RenderTest, PlayersHaveTheirColourAtTheirPosition) {
  const auto stage = cube();
  std::vector<PlayerDrawing> players;
  for (std::uint32_t slot = 0; slot < kBallColours; ++slot) {
    players.push_back(playerAt(*stage, slot, 0, {50.0 * slot - 175, slot % 2 == 0 ? -60 : -20}));
  }
  const Scene scene = sceneOf(stage, players);
  const Image image = draw(scene);
  for (const PlayerDrawing& player : players) {
    // Beside the number, away from the light's reflection.
    const glm::dvec3 beside = 0.7 * camera_.right() * StageModel::kPlayerRadius;
    const glm::vec3 colour = pixel(image, pixelOf(centreOf(player) + beside));
    std::uint32_t nearest = 0;
    const auto likeness = [&](std::uint32_t slot) {
      return glm::dot(glm::normalize(colour), glm::normalize(playerColour(slot)));
    };
    for (std::uint32_t slot = 0; slot < kBallColours; ++slot)
      nearest = likeness(slot) > likeness(nearest) ? slot : nearest;
    EXPECT_EQ(nearest, player.slot);
    EXPECT_GT(likeness(player.slot), 0.97);
  }
}

TEST_F(RenderTest, PlayersBehindTheSolidAreHidden) {
  const auto stage = cube();
  const Image without = draw(sceneOf(stage));
  const int opposite = stage->mesh.faceTowards(-stage->mesh.normal(0));
  EXPECT_EQ(draw(sceneOf(stage, {playerAt(*stage, 1, opposite, {20, 10})})), without);
  EXPECT_NE(draw(sceneOf(stage, {playerAt(*stage, 1, 0, {20, 10})})), without);
}

TEST_F(RenderTest, TheLocalPlayerHasABrightOutline) {
  const auto stage = cube();
  std::array<double, 2> outlines{};
  for (const bool local : {false, true}) {
    PlayerDrawing player = playerAt(*stage, 2, 0, {40, 30});
    player.local = local;
    const Image image = draw(sceneOf(stage, {player}));
    const glm::dvec3 rim = -0.94 * camera_.right() * StageModel::kPlayerRadius;
    outlines[local ? 1 : 0] = brightness(pixel(image, pixelOf(centreOf(player) + rim)));
  }
  EXPECT_GT(outlines[1], 0.65);
  EXPECT_LT(outlines[0], 0.4);
}

TEST_F(RenderTest, BehindAGhostTheSolidIsSeen) {
  const auto stage = cube();
  PlayerDrawing player = playerAt(*stage, 2, 0, {40, 30});
  const Image without = draw(sceneOf(stage));
  const glm::ivec2 beside = pixelOf(player.pose.position + 0.7 * camera_.right() * StageModel::kPlayerRadius);
  const glm::vec3 solid = pixel(without, beside);
  const glm::vec3 opaque = pixel(draw(sceneOf(stage, {player})), beside);
  Scene scene = sceneOf(stage);
  player.opacity = 0.25F;
  scene.ghosts = {player};
  const glm::vec3 ghost = pixel(draw(scene), beside);
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(ghost[i], glm::mix(solid[i], opaque[i], 0.25F), 0.01F) << i;
}

TEST_F(RenderTest, PlayersOfOneColourDifferByTheirNumber) {
  const auto stage = cube();
  PlayerDrawing one = playerAt(*stage, 0, 0, {40, 30});
  PlayerDrawing other = one;
  other.number = "8";
  EXPECT_NE(draw(sceneOf(stage, {one})), draw(sceneOf(stage, {other})));
}

TEST_F(RenderTest, SegmentsAreBright) {
  const Scene scene = sceneOf(cube());
  const Image image = draw(scene);
  for (const double x : {-190.0, -130.0, -70.0}) {
    EXPECT_GT(brightness(pixel(image, pixelOfTop(scene, {x, -120}))), 0.7) << x;
    EXPECT_LT(brightness(pixel(image, pixelOf(scene, {x, -140}))), 0.5) << x;
  }
}

TEST_F(RenderTest, MarksAreDrawnOnTheirFaceAboveOrBelowTheSegments) {
  const auto stage = cube();
  Scene scene = sceneOf(stage);
  const auto marksAt = [](int face, glm::vec2 place) {
    return std::make_shared<const std::vector<FaceMark>>(1, FaceMark{face, place, place, 30, {0, 1, 0, 1}});
  };
  const glm::dvec2 onSegment(-130, -120);
  const auto greenAt = [&](glm::dvec2 place) {
    const glm::vec3 colour = pixel(draw(scene), pixelOf(scene, place));
    return colour.g > 0.9F && colour.r < 0.1F;
  };
  EXPECT_FALSE(greenAt(onSegment));
  scene.marksAbove = marksAt(0, onSegment);
  EXPECT_TRUE(greenAt(onSegment));
  scene.marksBelow = std::exchange(scene.marksAbove, nullptr);
  EXPECT_FALSE(greenAt(onSegment)) << "below the segment";
  EXPECT_TRUE(greenAt(onSegment + glm::dvec2(0, 10)));
  scene.marksBelow = marksAt(1, onSegment);
  EXPECT_FALSE(greenAt(onSegment + glm::dvec2(0, 10))) << "on another face";
}

TEST_F(RenderTest, ASegmentThatEndsAtAnEdgeDoesNotOverhangIt) {
  const Scene scene = sceneOf(stageOf("HEXAHEDRON", 6, "0 100 240 100\n"));
  const Image image = draw(scene);
  const Image empty = drawEmpty();
  EXPECT_GT(brightness(pixel(image, pixelOfTop(scene, {232, 100}))), 0.7);
  EXPECT_EQ(pixel(image, pixelOfTop(scene, {245, 100})), pixel(empty, pixelOfTop(scene, {245, 100})));
}

TEST_F(RenderTest, TheGoalIsDrawnOnItsFaceOnly) {
  const Scene scene = sceneOf(cube());
  const Image image = draw(scene, kStill);
  const auto isGold = [](glm::vec3 colour) { return colour.r > 0.85F && colour.g > 0.65F && colour.b < 0.65F; };
  for (const glm::dvec2 side : {glm::dvec2(1, 0), glm::dvec2(-1, 0), glm::dvec2(0, 1), glm::dvec2(0, -1)}) {
    EXPECT_TRUE(isGold(pixel(image, pixelOf(scene, glm::dvec2(60, 80) + side * StageModel::kGoalRadius))))
        << side.x << " " << side.y;
  }
  EXPECT_GT(brightness(pixel(image, pixelOf(scene, {60, 80}))), 0.8) << "the star in the middle";
  Scene turned = scene;
  turned.focus = scene.stage->mesh.pose(scene.stage->mesh.faceTowards(-scene.stage->mesh.normal(0)), {0, 0}, 0);
  const Image behind = draw(turned, kStill);
  int gold = 0;
  for (int y = 0; y < static_cast<int>(kHeight); ++y) {
    for (int x = 0; x < static_cast<int>(kWidth); ++x) gold += isGold(pixel(behind, {x, y})) ? 1 : 0;
  }
  EXPECT_EQ(gold, 0);
}

TEST_F(RenderTest, WithoutAnimationThePictureDoesNotDependOnTime) {
  Scene scene = sceneOf(cube());
  const Image still = draw(scene, kStill);
  scene.seconds = 1.3;
  EXPECT_EQ(draw(scene, kStill), still);
  EXPECT_NE(draw(scene), still);
}

TEST_F(RenderTest, AnotherStageReplacesTheFirst) {
  const Image first = draw(sceneOf(cube()));
  const Image second = draw(sceneOf(stageOf("HEXAHEDRON", 6, "-200 -40 -60 -40\n")));
  EXPECT_NE(first, second);
  EXPECT_EQ(draw(sceneOf(cube())), first);
}

TEST_F(RenderTest, PanelsAndTextAreAtTheirPositions) {
  const Scene scene = sceneOf(cube());
  const Image plain = draw(scene);
  Overlay overlay;
  overlay.panels.push_back({{100, 100}, {300, 200}, 0, {1, 0, 0, 1}});
  overlay.texts.push_back({{400, 300}, 40, {0, 1, 0, 1}, "I"});
  renderer_.draw(scene, camera_, std::array{overlay});
  const Image image = renderer_.read();
  EXPECT_EQ(pixel(image, {100, 75}), glm::vec3(1, 0, 0)) << "the virtual screen is twice as high as this picture";
  EXPECT_EQ(pixel(image, {48, 75}), pixel(plain, {48, 75}));
  const float stem = font_.advance(U'I') * 40 / 2;
  EXPECT_GT(pixel(image, {static_cast<int>((400 + stem) / 2), 143}).g, 0.9F);
}

TEST_F(RenderTest, MoreSamplesSmoothTheEdges) {
  const Scene scene = sceneOf(cube());
  Scene tilted = scene;
  tilted.focus = scene.stage->mesh.pose(0, {0, 0}, 0.3);
  // The number of neighbouring pixels in a row that differ strongly.
  const auto steps = [&](int samples) {
    renderer_.setQuality({samples, 1, false, true});
    const Image image = draw(tilted);
    int count = 0;
    for (int y = 0; y < static_cast<int>(kHeight); ++y) {
      for (int x = 1; x < static_cast<int>(kWidth); ++x)
        count += glm::distance(pixel(image, {x - 1, y}), pixel(image, {x, y})) > 0.35F ? 1 : 0;
    }
    return count;
  };
  const int rough = steps(1);
  EXPECT_LT(steps(4), rough * 9 / 10);
}

TEST_F(RenderTest, ALowerQualityShowsTheSameScene) {
  const auto stage = cube();
  const Scene scene = sceneOf(stage, {playerAt(*stage, 0, 0, {30, 20})});
  const Image full = draw(scene);
  renderer_.setQuality({1, 0.75, false, false});
  const Image low = draw(scene);
  ASSERT_EQ(low.pixels.size(), full.pixels.size());
  double sum = 0;
  for (std::size_t i = 0; i < full.pixels.size(); ++i) sum += std::abs(int{full.pixels[i]} - int{low.pixels[i]});
  EXPECT_LT(sum / static_cast<double>(full.pixels.size()), 6);
  EXPECT_GT(sum, 0);
  renderer_.setQuality(namedQuality(QualityLevel::kHigh).quality);
  EXPECT_EQ(draw(scene), full);
}

TEST_F(RenderTest, WallsShadeTheFaceBesideThem) {
  const Scene scene = sceneOf(cube());
  const Scene without = sceneOf(stageOf("HEXAHEDRON", 6, ""));
  for (const NamedQuality& named : kQualities) {
    renderer_.setQuality(named.quality);
    const Image plain = draw(without, kStill);
    const Image shaded = draw(scene, kStill);
    const auto darkerAt = [&](glm::dvec2 place) {
      return brightness(pixel(plain, pixelOf(scene, place))) - brightness(pixel(shaded, pixelOf(scene, place)));
    };
    EXPECT_GT(darkerAt({-120, -129}), 0.03) << named.name;
    EXPECT_NEAR(darkerAt({-120, -60}), 0, 0.01) << named.name;
  }
}

TEST_F(RenderTest, FacesShowTheirNumbersOnlyIfAsked) {
  const Scene scene = sceneOf(stageOf("HEXAHEDRON", 6, ""));
  const Image sign = draw(scene);
  renderer_.setFaceNumbers(true);
  EXPECT_NE(draw(scene), sign);
  renderer_.setFaceNumbers(false);
  EXPECT_EQ(draw(scene), sign);
}

TEST_F(RenderTest, AFinishBurstsFromTheGoal) {
  Scene scene = sceneOf(cube());
  scene.attempt.emplace();
  draw(scene);
  scene.seconds = 1;
  draw(scene);
  scene.attempt->arrived = true;
  scene.seconds = 2;
  const Image before = draw(scene);
  scene.seconds = 2.3;
  const Image burst = draw(scene);
  const glm::ivec2 nearGoal = pixelOf(scene, {60, 80 - 2.5 * StageModel::kGoalRadius});
  EXPECT_GT(brightness(pixel(burst, nearGoal)), brightness(pixel(before, nearGoal)) + 0.05);
}

TEST_F(RenderTest, AReachedGoalIsARingRoundADarkDepth) {
  Scene scene = sceneOf(cube());
  scene.attempt.emplace();
  scene.attempt->arrived = true;
  const Image image = draw(scene, kStill);
  const auto brightnessAt = [&](double share) {
    return brightness(pixel(image, pixelOf(scene, {60 + share * 1.25 * StageModel::kGoalRadius, 80})));
  };
  EXPECT_GT(brightnessAt(1), 0.6) << "the ring";
  EXPECT_LT(brightnessAt(0), 0.25) << "the depth";
  EXPECT_GT(brightnessAt(0.8), brightnessAt(0.2) + 0.1) << "light rises towards the ring";
}

// Seen through the solid, a ring would look as if it lay on the face in front.
TEST_F(RenderTest, TheRingOfAHiddenGoalIsNotSeen) {
  const auto stage = cube();
  Scene scene = sceneOf(stage);
  scene.focus = stage->mesh.pose(stage->mesh.faceTowards(-stage->mesh.normal(0)), {0, 0}, 0);
  const Image image = draw(scene, kStill);
  for (const double angle : {0.5, 2.0, 3.5, 5.0}) {
    const auto at = [&](double radius) {
      const glm::dvec2 place = glm::dvec2(stage->goal.place) + radius * glm::dvec2(std::cos(angle), std::sin(angle));
      return pixel(image, pixelOf(stage->mesh.toWorld(0, place)));
    };
    EXPECT_NEAR(at(StageModel::kGoalRadius).r, at(1.8 * StageModel::kGoalRadius).r, 0.03F) << angle;
  }
}

TEST_F(RenderTest, TheBeamOfAHiddenGoalIsALineOfDashes) {
  const auto stage = cube();
  Scene scene = sceneOf(stage);
  scene.focus = stage->mesh.pose(stage->mesh.faceTowards(-stage->mesh.normal(0)), {0, 0}, 0);
  const Image image = draw(scene, kStill);
  const glm::dvec3 foot = stage->mesh.toWorld(0, glm::dvec2(stage->goal.place));
  double brightest = 0;
  double darkest = 1;
  for (int along = 1; along <= 60; ++along) {
    const glm::ivec2 seen = pixelOf(foot + 2.0 * along * stage->mesh.normal(0));
    const double more = brightness(pixel(image, seen)) - brightness(pixel(image, seen + glm::ivec2(40, 0)));
    brightest = std::max(brightest, more);
    darkest = std::min(darkest, more);
  }
  EXPECT_GT(brightest, 0.1);
  EXPECT_LT(darkest, 0.03);
}

TEST(Render, LargestAndSmallestSolidsShowTheirSegments) {
  const Offscreen context;
  GameView view(kWidth, kHeight);
  for (const char* size : {"200", "65536"}) {
    const LevelResult result =
        loadLevel(std::string("TETRAHEDRON\n0 0 0 0\n0 20 0\n") + size + "\n%\n-30 -20 30 -20\n%\n%\n%\n");
    ASSERT_TRUE(result.level);
    const auto stage = makeStageModel(*result.level);
    const Scene scene = sceneOf(stage, {playerAt(*stage, 0, 0, {0, -8})});
    view.draw(&scene, {}, Settings(), Overlay(), 0.1);
    const Image image = view.read();
    EXPECT_EQ(takeGlErrors(), "");
    Camera camera;
    camera.set(scene.focus, stage->mesh, kWidth, kHeight);
    const glm::dvec4 clip = camera.viewProjection() *
                            glm::dvec4(stage->mesh.toWorld(0, {-24, -20}) + Wall::kHeight * stage->mesh.normal(0), 1);
    const glm::ivec2 segment(static_cast<int>((clip.x / clip.w + 1) / 2 * kWidth),
                             static_cast<int>((1 - clip.y / clip.w) / 2 * kHeight));
    EXPECT_GT(brightness(pixel(image, segment)), 0.7) << size;
  }
}

TEST(Render, WithoutAGameTheOverlaysAreDrawn) {
  const Offscreen context;
  GameView view(kWidth, kHeight);
  Overlay menu;
  menu.panels.push_back({{0, 0}, {1280, 720}, 0, {1, 1, 1, 0.5F}});
  Settings settings;
  settings.netGraph = true;
  view.netGraph().add({});
  view.draw(nullptr, {.message = "Connecting", .warning = true, .help = true}, settings, menu, 0);
  EXPECT_EQ(takeGlErrors(), "");
  const Image image = view.read();
  view.draw(nullptr, {}, Settings(), Overlay(), 0);
  const Image plain = view.read();
  const auto differs = [&](int x, int y) { return pixel(image, {x, y}) != pixel(plain, {x, y}); };
  // The picture has half the size of the virtual screen.
  EXPECT_TRUE(differs(12, 345)) << "help";
  EXPECT_TRUE(differs(628, 345)) << "net graph";
  EXPECT_TRUE(differs(320, 100)) << "menu";
}

}  // namespace
}  // namespace platon::renderer_test
