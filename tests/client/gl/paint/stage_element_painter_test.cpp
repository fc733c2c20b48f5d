#include "client/gl/paint/stage_element_painter.h"

#include <algorithm>
#include <cstdlib>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "client/gl/gl_context.h"
#include "client/gl/renderer.h"
#include "client/gl/shader_program.h"
#include "client/scene/camera_target.h"
#include "platon/game/game.h"
#include "tests/client/gl/golden_picture.h"
#include "tests/client/gl/test_stage.h"
#include "tests/support/files.h"
#include "tests/support/sample_word.h"

namespace platon::stage_element_painter_test {
namespace {

constexpr std::uint32_t kWidth = 640;
constexpr std::uint32_t kHeight = 360;
constexpr std::size_t kBlock = 20;  // pixels; divides both sizes

Scene sceneOfLevel(const std::string& text) {
  const LevelResult result = loadLevel(text);
  if (!result.level) throw std::logic_error("test level: " + result.diagnostics.front().message);
  Scene scene = sceneOf(makeStageModel(*result.level));
  scene.elements = elementStatesOf(Game(result.level), std::nullopt, scene.stage->mesh);
  return scene;
}

// A cube with these segments on face 0, at whose centre the scene looks.
Scene sceneWith(const std::string& segments) {
  return sceneOfLevel("HEXAHEDRON\n1 0 0 0\n1 60 80\n480\n%\n" + segments + "%\n%\n%\n%\n%\n");
}

Scene inOtherState(Scene scene) {
  for (std::uint8_t& active : scene.elements.active) active = active == 0 ? 1 : 0;
  return scene;
}

class ElementPictureTest : public testing::Test {
 protected:
  Image draw(const Scene& scene) {
    camera_.set(scene.focus, scene.stage->mesh, kWidth, kHeight);
    return seen(scene);
  }

  // As the camera stands.
  Image seen(const Scene& scene) {
    renderer_.setQuality(kBestQuality);
    renderer_.draw(scene, camera_, {}, {.animated = false});
    EXPECT_EQ(takeGlErrors(), "");
    return renderer_.read();
  }

  Offscreen context_;
  Font font_;
  Renderer renderer_{kWidth, kHeight, font_};
  Camera camera_;
};

// The brightness of every pixel.
std::vector<double> greyOf(const Image& image) {
  std::vector<double> grey;
  for (std::uint32_t y = 0; y < image.height; ++y) {
    for (std::uint32_t x = 0; x < image.width; ++x)
      grey.push_back(brightness(pixel(image, {static_cast<int>(x), static_cast<int>(y)})));
  }
  return grey;
}

// The number of pixels whose brightness differs clearly.
long differingPixels(const Image& a, const Image& b) {
  const std::vector<double> left = greyOf(a);
  const std::vector<double> right = greyOf(b);
  long count = 0;
  for (std::size_t i = 0; i < left.size(); ++i) count += std::abs(left[i] - right[i]) > 0.1 ? 1 : 0;
  return count;
}

// "oneway", "up 2" … "plate 2": one of each kind.
std::vector<std::string> oneOfEachKind() {
  std::vector<std::string> words;
  for (const ElementKind kind : kElementKinds) words.push_back(sampleWord(kind).text());
  return words;
}

const std::vector<std::string> kWords = oneOfEachKind();

TEST(StageElementPainterTest, TheShaderHasACaseForEveryKind) {
  for (const ElementKind kind : kElementKinds)
    EXPECT_NE(shaderText("element.frag").find("case kind_" + std::string(wordOf(kind)) + ":"), std::string::npos)
        << wordOf(kind);
}

TEST_F(ElementPictureTest, EveryKindIsSeenAndDiffersFromAWallAndFromEveryOtherWithoutColour) {
  std::vector<std::string> names{"no segment", "a wall"};
  std::vector<Image> images{draw(sceneWith("")), draw(sceneWith("-120 0 120 0\n"))};
  for (const std::string& word : kWords) {
    names.push_back(word);
    images.push_back(draw(sceneWith("-120 0 120 0 " + word + "\n")));
  }
  for (std::size_t i = 0; i < images.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j)
      EXPECT_GT(differingPixels(images[i], images[j]), 100)
          << names[i] << " and " << names[j] << " look alike; client/gl/shaders/element.frag draws elements";
  }
}

TEST_F(ElementPictureTest, EveryStateIsSeenWithoutColour) {
  for (const std::string& word : kWords) {
    const Scene scene = sceneWith("-120 0 120 0 " + word + "\n");
    const Image before = draw(scene);
    const Image after = draw(inOtherState(scene));
    const bool changes = word != "oneway" && word != "hazard";
    EXPECT_EQ(differingPixels(before, after) > 50, changes)
        << "whether the pictures of '" << word << "' with ElementStates::active 1 and 0 differ; it has "
        << (changes ? "two states" : "one state") << ", as this test says";
    EXPECT_EQ(draw(scene), before) << word << " in its first state again";
  }
}

TEST_F(ElementPictureTest, ATakenKeyIsGone) {
  renderer_.setFaceNumbers(true);  // signs give way to elements
  const Scene scene = sceneWith("-120 0 120 0 key 5\n-120 50 120 50 door 5\n");
  Scene taken = scene;
  taken.elements.active[0] = 0;
  const Image without = draw(sceneWith("-120 50 120 50 door 5\n"));
  EXPECT_NE(draw(scene), without);
  EXPECT_EQ(draw(taken), without);
}

TEST_F(ElementPictureTest, NumbersDiffer) {
  for (const ElementKind kind : kElementKinds) {
    if (traitsOf(kind).number != ElementNumber::kDoor) continue;  // arrows show the edge, and a clock the times
    const std::string segment = "-120 0 120 0 " + std::string(wordOf(kind));
    EXPECT_NE(draw(sceneWith(segment + " 1\n")), draw(sceneWith(segment + " 7\n"))) << wordOf(kind);
  }
}

TEST_F(ElementPictureTest, AClockShowsHowLongItTakesWithoutColour) {
  for (const std::uint8_t active : {std::uint8_t{1}, std::uint8_t{0}}) {
    std::vector<Image> images;
    for (const float full : {0.1F, 0.4F, 0.7F, 1.0F}) {
      Scene scene = sceneWith("-120 0 120 0 timed 60 60\n");
      scene.elements.active[0] = active;
      scene.elements.clocks[0] = full;
      images.push_back(draw(scene));
      for (std::size_t i = 0; i + 1 < images.size(); ++i)
        EXPECT_GT(differingPixels(images[i], images.back()), 20) << full << ", active: " << int{active};
    }
  }
}

TEST_F(ElementPictureTest, AnElementAlongAnEdgeIsDrawnOnBothFaces) {
  Scene scene = sceneWith("-100 -240 100 -240 door 5\n");
  const int below = scene.stage->mesh.solid().neighbour(0, 0).face;
  ASSERT_EQ(scene.stage->faces[static_cast<std::size_t>(below)].elements.size(), 1U);
  Scene plain = sceneWith("");
  for (const int face : {0, below}) {
    scene.focus = plain.focus = scene.stage->mesh.pose(face, {0, 0}, 0);
    EXPECT_GT(differingPixels(draw(scene), draw(plain)), 100) << face;
  }
}

TEST_F(ElementPictureTest, FlagsAndNumbersStandUprightForThePlayer) {
  const Scene scene = sceneWith("-120 0 120 0 checkpoint\n");
  Scene turned = scene;
  turned.elements.ups[0] = {1, 0};
  EXPECT_GT(differingPixels(draw(scene), draw(turned)), 50);
}

// The number of a door on an edge stood a second time in the air before the neighbouring face.
TEST_F(ElementPictureTest, ANumberIsDrawnOnceAlsoOnAnEdge) {
  Scene scene = sceneWith("-100 -240 100 -240 door 5\n");
  const int below = scene.stage->mesh.solid().neighbour(0, 0).face;
  EXPECT_TRUE(scene.stage->faces[0].elements.front().own);
  EXPECT_FALSE(scene.stage->faces[static_cast<std::size_t>(below)].elements.front().own);
}

TEST_F(ElementPictureTest, AnotherStageReplacesTheFirst) {
  const Scene first = sceneWith("-120 0 120 0 door 5\n");
  const Scene second = sceneWith("-120 40 120 40 door 5\n");
  const Image image = draw(first);
  EXPECT_NE(draw(second), image);
  EXPECT_EQ(draw(first), image);
  EXPECT_EQ(draw(sceneWith("")), draw(sceneOf(sceneWith("").stage))) << "a stage without elements has no states";
}

constexpr double kHeightAbove =
    624 / 1.6 / 2 / CameraTarget::kTangent;  // of the eye above the face, along the ray from the centre

// Every element, at the edge of two faces; below, the same in the other state.
TEST_F(ElementPictureTest, EveryElementLooksAsBefore) {
  const std::string golden = "tests/client/gl/golden/elements.png";
  Scene scene = sceneOfLevel(readText("tests/levels/picture/elements.level"));
  camera_.resize(kWidth, kHeight);
  const glm::dvec3 place = scene.stage->mesh.toWorld(0, {200, -20});
  camera_.place(place * (1 + kHeightAbove / glm::length(place)), {0, 1, 0}, scene.stage->mesh);
  Image image = seen(scene);
  const Image other = seen(inOtherState(scene));
  image.pixels.insert(image.pixels.end(), other.pixels.begin(), other.pixels.end());
  image.height += other.height;
  const std::string drawn = testing::TempDir() + "platon_elements.png";
  writePng(image, drawn);
  const Image expected = readPng(golden);
  ASSERT_EQ(expected.pixels.size(), image.pixels.size())
      << "look at " << drawn << ", and write it with pngquant to " << golden;
  EXPECT_LT(blockDifference(image, expected, kBlock), 8)
      << "look at " << drawn << ", and if it is right, write it with pngquant to " << golden;
}

}  // namespace
}  // namespace platon::stage_element_painter_test
